using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public sealed class TrunkBendsTests
{
    /// <summary>Half a degree: a bend is told by angles about the axes of the model, a limit by swing and twist.</summary>
    private const double Tolerance = 0.009;

    [Fact]
    public void However_a_trunk_is_asked_to_bend_no_joint_of_it_goes_beyond_its_limits()
    {
        for (ulong seed = 1; seed <= 38; seed++)
        {
            LeggedBody body = Body(seed);
            foreach (Vector3 bend in Corners(body.Bends))
            {
                Vector3 kept = body.Bends.Within(bend) / body.ForeSlot;
                for (int i = 1; i <= body.ForeSlot; i++)
                {
                    Quaternion rest = body.Skeleton.ModelRotations[body.Trunk[i]];
                    Quaternion turn = Rotation.Multiply(Rotation.Inverse(rest), Rotation.Multiply(AxisRotation.YawPitchRoll(kept.Y, kept.X, kept.Z), rest));
                    double excess = JointExcess.Of(turn, body.Skeleton.Joints[body.Trunk[i]].Limit);
                    Assert.True(excess < Tolerance, $"{seed}: {body.Skeleton.Joints[body.Trunk[i]].Name} is {excess} rad beyond its limits, bent by {bend}");
                }
            }
        }
    }

    [Fact]
    public void A_bend_is_drawn_in_as_a_whole_and_not_farther_than_it_has_to_be()
    {
        LeggedBody body = Body(24800047);
        foreach (Vector3 bend in Corners(body.Bends))
        {
            Vector3 kept = body.Bends.Within(bend);
            Assert.InRange(kept.Length() / bend.Length(), 0.3f, 1f);
            Assert.InRange(Vector3.Dot(Vector3.Normalize(kept), Vector3.Normalize(bend)), 0.9999f, 1.0001f);
            Assert.InRange(Vector3.Distance(body.Bends.Within(kept), kept), 0f, 0.06f * kept.Length());
            Assert.Equal(0.4f * kept, body.Bends.Within(0.4f * kept));
        }
    }

    [Fact]
    public void Bends_to_both_sides_are_mirror_images()
    {
        LeggedBody body = Body(24800047);
        foreach (Vector3 bend in Corners(body.Bends))
        {
            Vector3 left = body.Bends.Within(bend);
            Vector3 right = body.Bends.Within(bend * new Vector3(1f, -1f, -1f));
            Assert.InRange(Vector3.Distance(left * new Vector3(1f, -1f, -1f), right), 0f, 1e-4f);
        }
    }

    [Fact]
    public void The_stiffest_joint_decides_how_far_all_bend_about_one_axis()
    {
        LeggedBody body = Body(2);
        JointLimit[] limits = Array.ConvertAll(body.Trunk[1..(body.ForeSlot + 1)], joint => body.Skeleton.Joints[joint].Limit);
        Assert.Equal(0.95f * limits.Length * limits.Min(limit => limit.SwingZ.Max), body.Bends.Yaw, 5);
        Assert.Equal(0.95f * limits.Length * limits.Min(limit => limit.Twist.Max), body.Bends.Roll, 5);
        Assert.Equal(0.7125f * limits.Length * limits.Min(limit => limit.SwingX.Max), body.Bends.Pitch, 5);
    }

    private static Vector3[] Corners(TrunkBends bends)
    {
        var corners = new Vector3[8];
        for (int i = 0; i < corners.Length; i++)
        {
            corners[i] = new Vector3(i % 2 == 0 ? bends.Pitch : -bends.Pitch, i / 2 % 2 == 0 ? bends.Yaw : -bends.Yaw, i / 4 == 0 ? bends.Roll : -bends.Roll);
        }

        return corners;
    }

    private static LeggedBody Body(ulong seed) => new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking })).Legs
        ?? throw new InvalidOperationException($"{seed} has no legs");
}
