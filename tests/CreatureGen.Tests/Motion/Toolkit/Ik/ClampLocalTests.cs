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

public sealed class ClampLocalTests
{
    /// <summary>The turn away from rest comes after rest: about the joint's own axes, not about its parent's.</summary>
    [Theory]
    [InlineData(1.2f, 0.5f)]
    [InlineData(-1.2f, -0.3f)]
    [InlineData(0.4f, 0.4f)]
    public void A_joint_is_clamped_about_its_own_axes_away_from_its_rest(float asked, float allowed)
    {
        Quaternion rest = Quaternion.Normalize(new Quaternion(0.3f, -0.5f, 0.7f, 0.4f));
        var limit = new JointLimit(new AngleRange(-0.3f, 0.5f), new AngleRange(-0.2f, 0.2f), new AngleRange(-0.1f, 0.1f));
        var joint = new Joint("Joint", JointRole.Spine, Side.Median, -1, Vector3.Zero, rest, Vector3.Zero, rest, 1f, limit);
        Quaternion local = rest * Quaternion.CreateFromAxisAngle(Vector3.UnitX, asked);
        Quaternion expected = rest * Quaternion.CreateFromAxisAngle(Vector3.UnitX, allowed);
        Assert.True(Math.Abs(Quaternion.Dot(expected, SwingTwistLimit.ClampLocal(local, joint))) > 1f - 1e-6f);
    }

    /// <summary>Inside, near and far beyond, of bones along any axis.</summary>
    [Fact]
    public void A_limit_kept_beside_others_gives_the_bits_of_its_joint()
    {
        var random = new RandomStream(3);
        for (int i = 0; i < 3000; i++)
        {
            Quaternion rest = Turn(random, 3);
            var limit = new JointLimit(new AngleRange(-0.3f, 0.9f), new AngleRange(-0.2f, 0.6f), new AngleRange(-0.4f, 0.1f));
            Vector3 along = i % 3 == 0 ? Vector3.UnitZ : Vector3.UnitY;
            var joint = new Joint("Joint", JointRole.Spine, Side.Median, -1, Vector3.Zero, rest, Vector3.Zero, rest, 1f, limit) { Along = along };
            Quaternion local = Rotation.Multiply(rest, Turn(random, 1.2));
            Assert.Equal(SwingTwistLimit.ClampLocal(local, joint), new LocalLimit(joint).Clamp(local));
        }
    }

    private static Quaternion Turn(RandomStream random, double most) =>
        Rotation.FromAxisAngle(Vec.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1)), Vector3.UnitX), random.Uniform(-most, most));
}
