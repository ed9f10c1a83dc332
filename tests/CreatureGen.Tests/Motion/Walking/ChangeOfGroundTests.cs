using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class ChangeOfGroundTests
{
    [Fact]
    public void A_walker_that_comes_from_hills_onto_a_plane_lifts_its_feet_as_one_that_was_always_there()
    {
        var profile = new MotionProfile(Walkers.Any(42));
        HeightFieldGround hills = new HillField(new Seed(42), profile.LegLength).Around(20f, -20f, 60f);
        var input = new MotionInput(Speed: profile.Gaits!.Speeds[0].Comfortable);
        float[] level = Highest(profile, input, FlatGround.Level);
        float[] after = Highest(profile, input, hills);
        for (int i = 0; i < level.Length; i++)
        {
            Assert.InRange(after[i], level[i] - (0.01f * profile.LegLength), level[i] + (0.01f * profile.LegLength));
        }
    }

    /// <summary>Greatest height of each ball on a plane, metres, after some time on another ground.</summary>
    private static float[] Highest(MotionProfile profile, MotionInput input, IGround before)
    {
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), before);
        Walkers.Run(animator, 3f, 60f, input, before);
        Walkers.Run(animator, 4f, 60f, input, FlatGround.Level);
        var highest = new float[animator.FootCount];
        for (int i = 0; i < 180; i++)
        {
            animator.Update(1f / 60f, input, FlatGround.Level);
            for (int foot = 0; foot < highest.Length; foot++)
            {
                highest[foot] = Math.Max(highest[foot], animator.Root.ToWorld(animator.ModelPose.Positions[animator.Foot(foot).Joint]).Y);
            }
        }

        return highest;
    }
}
