using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Springs;

public sealed class SpringCollisionTests
{
    private const float BarRadius = 0.01f;
    private const float HairRadius = 0.005f;

    [Theory]
    [InlineData(0.05f)]
    [InlineData(0.1f)]
    [InlineData(0.25f)]
    [InlineData(0.38f)]
    public void A_bar_pushes_bones_aside_wherever_along_them_it_passes(float height)
    {
        // Two bones of 0.2 m hang from a joint at the origin; a thin bar comes through them from the side, up to 0.1 m deep.
        Skeleton skeleton = Hanging(2, 0.2f);
        var rig = new SpringRig(skeleton, [0]);
        var state = new SpringState(rig);
        var settings = new SpringSettings(new ChainCurve(2f), new ChainCurve(0.7f), new ChainCurve(HairRadius), maxSwing: 3f);
        double deepest = 0;
        for (int i = 0; i < 240; i++)
        {
            float x = -0.03f + Math.Min(0.13f, 0.1f * i / 60f);
            SpringCollider[] bar = [SpringCollider.Capsule(-1, new Vector3(x, -height, -1f), new Vector3(x, -height, 1f), BarRadius)];
            MovingPose pose = new(skeleton);
            SpringBones.Update(rig, state, settings, RootPlace.Identity, bar, 1f / 60f, pose.Local, pose.Model);
            for (int k = 0; k < 2; k++)
            {
                deepest = Math.Max(deepest, BarRadius + HairRadius - FromBar(pose.ModelPositions[k], pose.ModelPositions[k + 1], x, -height));
            }
        }

        Assert.True(deepest < 0.001, $"{deepest * 1000:0.0} mm");
    }

    [Fact]
    public void A_bone_whose_joint_lies_in_a_ball_leaves_it_on_the_shortest_way_and_does_not_tremble()
    {
        Skeleton skeleton = Hanging(1, 0.3f);
        var rig = new SpringRig(skeleton, [0]);
        var state = new SpringState(rig);
        var settings = new SpringSettings(new ChainCurve(2f), new ChainCurve(1f), maxSwing: 3f);
        SpringCollider[] ball = [SpringCollider.Capsule(-1, new Vector3(-0.06f, 0f, 0f), new Vector3(-0.06f, 0f, 0f), 0.1f), SpringCollider.Capsule(-1, new Vector3(-0.02f, -0.3f, 0f), new Vector3(-0.02f, -0.3f, 0f), 0.05f)];
        Vector3 last = default;
        for (int i = 0; i < 300; i++)
        {
            MovingPose pose = new(skeleton);
            SpringBones.Update(rig, state, settings, RootPlace.Identity, ball, 1f / 60f, pose.Local, pose.Model);
            Vector3 tip = pose.ModelPositions[1];
            Assert.True(Vec.Distance(tip, new Vector3(-0.02f, -0.3f, 0f)) > 0.05f - 1e-3f);
            Assert.True(i < 240 || Vec.Distance(tip, last) < 1e-5f, $"{i}: {tip}");
            last = tip;
        }
    }

    [Fact]
    public void Nearest_points_of_two_segments_are_those_of_a_search()
    {
        CreatureGen.Seeding.RandomStream random = new CreatureGen.Seeding.Seed(5).Stream();
        for (int i = 0; i < 300; i++)
        {
            Vector3 a = Point(), wayA = Point(), b = Point(), wayB = i % 7 == 0 ? wayA * 0.5f : i % 11 == 0 ? Vector3.Zero : Point();
            float s = CreatureGen.Motion.Toolkit.Springs.Segments.Nearest(a, wayA, b, wayB, out float t);
            float found = Vec.Distance(a + (wayA * s), b + (wayB * t));
            float least = float.MaxValue;
            for (int k = 0; k <= 40; k++)
            {
                for (int m = 0; m <= 40; m++)
                {
                    least = Math.Min(least, Vec.Distance(a + (wayA * (k / 40f)), b + (wayB * (m / 40f))));
                }
            }

            Assert.True(found <= least + 1e-4f, $"{i}: {found} {least}");
        }

        Vector3 Point() => new((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1));
    }

    /// <summary>Bones that hang down from the origin.</summary>
    private static Skeleton Hanging(int bones, float length)
    {
        var joints = new JointPlacement[bones + 1];
        for (int i = 0; i <= bones; i++)
        {
            joints[i] = new JointPlacement($"Hair {i}", i - 1, Quaternion.Identity, i == 0 ? Vector3.Zero : new Vector3(0f, -length, 0f));
        }

        return Skeleton.Build(joints);
    }

    /// <summary>Distance between a bone and a bar along Z.</summary>
    private static double FromBar(Vector3 from, Vector3 to, float x, float y)
    {
        double dx = to.X - from.X, dy = to.Y - from.Y;
        double t = Math.Clamp((((x - from.X) * dx) + ((y - from.Y) * dy)) / ((dx * dx) + (dy * dy)), 0, 1);
        double ax = from.X + (t * dx) - x, ay = from.Y + (t * dy) - y;
        return Math.Sqrt((ax * ax) + (ay * ay));
    }
}
