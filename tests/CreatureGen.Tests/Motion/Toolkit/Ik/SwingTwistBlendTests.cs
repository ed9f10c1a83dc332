using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class SwingTwistBlendTests
{
    private const int Steps = 200;

    // A wing's: far to one side, little to the other.
    private static readonly JointLimit wing = new(new AngleRange(-1.4f, 1.48f), new AngleRange(-2.18f, 0.79f), new AngleRange(-1.4f, 0.7f));

    [Fact]
    public void It_stays_within_the_limit_and_does_not_jump_where_the_shortest_way_does()
    {
        var random = new RandomStream(7);
        double fastestClamped = 0;
        for (int pair = 0; pair < 400; pair++)
        {
            Joint joint = Of(pair % 2 == 0 ? Vector3.UnitY : Vec.Normalize(new Vector3(0.3f, -0.2f, 0.9f), Vector3.UnitY));
            Quaternion from = Within(random, joint);
            Quaternion to = Within(random, joint);
            Quaternion before = from;
            Quaternion clampedBefore = from;
            for (int i = 1; i <= Steps; i++)
            {
                float w = (float)i / Steps;
                Quaternion now = SwingTwistBlend.Between(from, to, w, joint);
                Quaternion clamped = SwingTwistLimit.ClampLocal(Rotation.Slerp(from, to, w), joint);
                double step = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before), now));
                double outside = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(SwingTwistLimit.ClampLocal(now, joint)), now));
                Assert.True(step < 8.0 / Steps, $"pair {pair}: {step} rad in a step");
                Assert.True(outside < 1e-3, $"pair {pair}: {outside} rad outside");
                fastestClamped = Math.Max(fastestClamped, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(clampedBefore), clamped)));
                (before, clampedBefore) = (now, clamped);
            }
        }

        Assert.True(fastestClamped > 0.5, $"the shortest way jumps by {fastestClamped} rad only");
    }

    [Fact]
    public void It_begins_and_ends_where_it_is_to()
    {
        Joint joint = Of(Vector3.UnitY);
        var random = new RandomStream(8);
        Quaternion from = Within(random, joint);
        Quaternion to = Within(random, joint);
        Assert.Equal(from, SwingTwistBlend.Between(from, to, 0f, joint));
        Assert.Equal(to, SwingTwistBlend.Between(from, to, 1f, joint));
        Assert.Equal(from, SwingTwistBlend.Between(from, from, 0.5f, joint));
    }

    [Fact]
    public void Half_of_a_swing_and_a_twist_is_half_of_each()
    {
        Joint joint = Of(Vector3.UnitY);
        Quaternion to = Rotation.Multiply(joint.LocalRotation, Rotation.Multiply(AxisRotation.Pitch(0.8f), AxisRotation.Yaw(0.6f)));
        Quaternion half = Rotation.Multiply(joint.LocalRotation, Rotation.Multiply(AxisRotation.Pitch(0.4f), AxisRotation.Yaw(0.3f)));
        Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(half), SwingTwistBlend.Between(joint.LocalRotation, to, 0.5f, joint))) < 1e-3);
    }

    private static Joint Of(Vector3 along)
    {
        Quaternion rest = Quaternion.Normalize(new Quaternion(0.3f, -0.5f, 0.7f, 0.4f));
        return new Joint("Wing", JointRole.Wing, Side.Left, -1, Vector3.Zero, rest, Vector3.Zero, rest, 1f, wing) { Along = along };
    }

    /// <summary>Any rotation within the limit of a joint.</summary>
    private static Quaternion Within(RandomStream random, Joint joint)
    {
        double way = 2 * Math.PI * random.Uniform();
        double far = 0.98 * Math.Sqrt(random.Uniform());
        float x = (float)(far * Math.Cos(way) * (Math.Cos(way) < 0 ? -wing.SwingX.Min : wing.SwingX.Max));
        float z = (float)(far * Math.Sin(way) * (Math.Sin(way) < 0 ? -wing.SwingZ.Min : wing.SwingZ.Max));
        float twist = wing.Twist.Min + ((float)random.Uniform() * (wing.Twist.Max - wing.Twist.Min));
        var axis = new Vector3(x, 0f, z);
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.Normalize(axis), axis.Length()) * Quaternion.CreateFromAxisAngle(Vector3.UnitY, twist);
        Quaternion own = BoneAxes.Of(joint);
        return Quaternion.Normalize(joint.LocalRotation * own * turn * Quaternion.Inverse(own));
    }
}
