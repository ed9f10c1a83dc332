using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Distance;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion;

public class PoseCycleTests
{
    private static readonly Skeleton chain = MovingPose.Chain(10, 0.1f, JointLimit.Free);

    [Fact]
    public void Joints_that_are_posed_four_at_a_time_have_the_bits_of_those_that_are_posed_alone()
    {
        LocalPose[] frames = Frames(joint => true);
        Pose all = Shown(new PoseCycle(new LocalPose(chain), frames, 1f, 1f), 0.37f, 0.8f);
        for (int joint = 0; joint < chain.Count; joint++)
        {
            int one = joint;
            Pose alone = Shown(new PoseCycle(new LocalPose(chain), Frames(j => j == one), 1f, 1f), 0.37f, 0.8f);
            Assert.Equal(alone.Rotations[joint], all.Rotations[joint]);
        }
    }

    [Fact]
    public void A_cycle_shows_its_frames_at_their_places_closes_and_is_the_stand_without_weight()
    {
        LocalPose[] frames = Frames(joint => true);
        var cycle = new PoseCycle(new LocalPose(chain), frames, 1f, 1f);
        for (int joint = 0; joint < chain.Count; joint++)
        {
            Assert.InRange(MovingPose.Between(frames[0].Pose.Rotations[joint], Shown(cycle, 0f, 1f).Rotations[joint]), 0, 1e-3);
            Assert.InRange(MovingPose.Between(frames[0].Pose.Rotations[joint], Shown(cycle, 1f, 1f).Rotations[joint]), 0, 1e-3);
            Assert.Equal(chain.LocalRotations[joint], Shown(cycle, 0.5f, 0f).Rotations[joint]);
        }
    }

    private static Pose Shown(PoseCycle cycle, float phase, float weight)
    {
        var pose = new LocalPose(chain);
        cycle.Pose(phase, weight, pose.Pose);
        return pose.Pose;
    }

    /// <summary>A cycle in which some joints turn about axes of their own.</summary>
    private static LocalPose[] Frames(Predicate<int> turns) => Enumerable.Range(0, PoseCycle.Frames + 1).Select(frame =>
    {
        var pose = new LocalPose(chain);
        for (int joint = 0; joint < chain.Count; joint++)
        {
            if (turns(joint))
            {
                double angle = (0.1 + (0.05 * joint)) * Math.Cos(Math.Tau * frame / PoseCycle.Frames);
                Vector3 axis = Vec.Normalize(new Vector3(1f, 0.3f * joint, 2f - (0.2f * joint)));
                pose.Pose.Rotations[joint] = Rotation.FromAxisAngle(axis, angle);
            }
        }

        return pose;
    }).ToArray();
}
