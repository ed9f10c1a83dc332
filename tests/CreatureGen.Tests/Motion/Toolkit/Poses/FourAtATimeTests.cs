using System;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Poses;

/// <summary>Joints are blended several at a time where the processor allows: nobody must be able to tell.</summary>
public sealed class FourAtATimeTests
{
    private const int Joints = 23;

    [Theory]
    [InlineData(0f)]
    [InlineData(0.3f)]
    [InlineData(1f)]
    public void A_blend_of_many_joints_has_the_bits_of_blends_of_each_joint_alone(float weight)
    {
        (Quaternion[] r, Vector3[] p) = Poses(1);
        (Quaternion[] s, Vector3[] q) = Poses(2);
        var rotations = new Quaternion[Joints];
        var positions = new Vector3[Joints];
        PoseBlend.Mix(new Pose(r, p), new Pose(s, q), weight, new Pose(rotations, positions));
        for (int i = 0; i < Joints; i++)
        {
            var rotation = new Quaternion[1];
            var position = new Vector3[1];
            PoseBlend.Mix(One(r, p, i), One(s, q, i), weight, new Pose(rotation, position));
            Assert.Equal(rotation[0], rotations[i]);
            Assert.Equal(position[0], positions[i]);
        }
    }

    [Fact]
    public void A_mean_of_many_joints_has_the_bits_of_means_of_each_joint_alone()
    {
        (Quaternion[] r, Vector3[] p) = Poses(3);
        (Quaternion[] s, Vector3[] q) = Poses(4);
        (Quaternion[] f, Vector3[] g) = Poses(5);
        (Quaternion[] e, Vector3[] h) = Poses(8);
        float[] mask = new float[Joints];
        for (int i = 0; i < Joints; i++)
        {
            mask[i] = i is 5 or 6 or 18 ? 0f : 1f;
        }

        var rotations = new Quaternion[Joints];
        var positions = new Vector3[Joints];
        var mixer = new PoseMixer(new Pose(rotations, positions), new float[Joints]);
        mixer.Add(new Pose(r, p), 0.02f);
        mixer.Add(new Pose(s, q), 0.7f, mask);
        mixer.Add(new Pose(e, h), 0.03f);
        mixer.Finish(new Pose(f, g));
        for (int i = 0; i < Joints; i++)
        {
            var rotation = new Quaternion[1];
            var position = new Vector3[1];
            var alone = new PoseMixer(new Pose(rotation, position), new float[1]);
            alone.Add(One(r, p, i), 0.02f);
            alone.Add(One(s, q, i), 0.7f, mask.AsSpan(i, 1));
            alone.Add(One(e, h, i), 0.03f);
            alone.Finish(One(f, g, i));
            Assert.Equal(rotation[0], rotations[i]);
            Assert.Equal(position[0], positions[i]);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(8)]
    [InlineData(9)]
    [InlineData(15)]
    [InlineData(16)]
    [InlineData(17)]
    [InlineData(Joints)]
    public void A_mean_has_the_bits_of_sums_that_begin_at_nought_whichever_way_its_first_pose_is_added(int joints)
    {
        Pose first = Part(Poses(3), joints);
        Pose second = Part(Poses(4), joints);
        float[] ones = new float[joints];
        ones.AsSpan().Fill(1f);
        var evenly = new Pose(new Quaternion[joints], new Vector3[joints]);
        var masked = new Pose(new Quaternion[joints], new Vector3[joints]);
        var mixer = new PoseMixer(evenly, new float[joints]);
        mixer.Add(first, 0.4f);
        mixer.Add(second, 0.6f);
        mixer.Finish(first);
        mixer = new PoseMixer(masked, new float[joints]);
        mixer.Add(first, 0.4f, ones);
        mixer.Add(second, 0.6f, ones);
        mixer.Finish(first);
        Assert.Equal(masked.Rotations.ToArray(), evenly.Rotations.ToArray());
        Assert.Equal(masked.Positions.ToArray(), evenly.Positions.ToArray());
    }

    [Fact]
    public void A_mean_of_nothing_is_the_fallback_whatever_was_in_the_result_before()
    {
        (Quaternion[] r, Vector3[] p) = Poses(3);
        (Quaternion[] f, Vector3[] g) = Poses(5);
        var mixer = new PoseMixer(new Pose(r, p), new float[Joints]);
        mixer.Add(new Pose(f, g), 0f);
        mixer.Finish(new Pose(f, g));
        for (int i = 0; i < Joints; i++)
        {
            Assert.True((r[i] - f[i]).Length() < 1e-6f, $"joint {i}: {r[i]}; expected {f[i]}");
            Assert.True(Vector3.Distance(p[i], g[i]) < 1e-6f, $"joint {i}: {p[i]}; expected {g[i]}");
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    [InlineData(22)]
    public void A_rotation_that_is_infinite_or_too_large_to_have_a_length_is_refused(int joint)
    {
        foreach (float wrong in new[] { float.PositiveInfinity, float.NaN, 1e30f })
        {
            Assert.Throws<ArgumentException>(() => Blend(joint, wrong));
            Assert.Throws<ArgumentException>(() => Mean(joint, wrong));
        }
    }

    private static Pose Part((Quaternion[] Rotations, Vector3[] Positions) pose, int joints) => new(pose.Rotations.AsSpan(0, joints), pose.Positions.AsSpan(0, joints));

    private static void Blend(int joint, float wrong)
    {
        (Quaternion[] r, Vector3[] p) = Poses(6);
        (Quaternion[] s, Vector3[] q) = Poses(7);
        r[joint].Y = wrong;
        PoseBlend.Mix(new Pose(r, p), new Pose(s, q), 0.5f, new Pose(s, q));
    }

    private static void Mean(int joint, float wrong)
    {
        (Quaternion[] r, Vector3[] p) = Poses(6);
        (Quaternion[] s, Vector3[] q) = Poses(7);
        r[joint].Y = wrong;
        var mixer = new PoseMixer(new Pose(s, q), new float[Joints]);
        mixer.Add(new Pose(r, p), 1f);
        (Quaternion[] f, Vector3[] g) = Poses(8);
        mixer.Finish(new Pose(f, g));
    }

    private static Pose One(Quaternion[] rotations, Vector3[] positions, int joint) => new(rotations.AsSpan(joint, 1), positions.AsSpan(joint, 1));

    private static (Quaternion[] Rotations, Vector3[] Positions) Poses(ulong seed)
    {
        var random = new RandomStream(seed);
        var rotations = new Quaternion[Joints];
        var positions = new Vector3[Joints];
        for (int i = 0; i < Joints; i++)
        {
            rotations[i] = Quaternion.Normalize(new Quaternion(Next(), Next(), Next(), Next()));
            positions[i] = new Vector3(Next(), Next(), Next());
        }

        return (rotations, positions);

        float Next() => (float)random.Uniform(-1, 1);
    }
}
