using System;
using System.Numerics;
using CreatureGen.Motion.Toolkit.Clips;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Clips;

public sealed class PackedValueTests
{
    // Of a turn the three smaller numbers are kept, at most the range times half a step of 20,642 off each.
    private const float Step = 1f / 20642f;

    [Fact]
    public void A_turn_comes_back_within_half_a_step_of_each_component()
    {
        var random = new RandomStream(5);
        float worst = 0f;
        for (int i = 0; i < 20000; i++)
        {
            var q = new Vector4((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1));
            q /= q.Length();
            var turn = new Quaternion(q.X, q.Y, q.Z, q.W);
            float range = PackedValue.RangeOf(turn);
            (ushort a, ushort b, ushort c) = PackedValue.Pack(turn, range);
            Quaternion back = PackedValue.Turn(a, b, c, range);
            float sign = Math.Sign(Quaternion.Dot(turn, back));
            float[] kept = { Math.Abs(turn.X - (sign * back.X)), Math.Abs(turn.Y - (sign * back.Y)), Math.Abs(turn.Z - (sign * back.Z)), Math.Abs(turn.W - (sign * back.W)) };
            Array.Sort(kept);

            // The fourth is what makes the length 1: it takes the errors of the others on.
            worst = Math.Max(worst, kept[2] / range);
        }

        Assert.InRange(worst, 0.2f * Step, 0.51f * Step);
    }

    /// <summary>The highest and the lowest of the three digits do not run into one another nor into what tells which component is left out.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Digits_at_their_ends_keep_apart(int left)
    {
        for (int corner = 0; corner < 27; corner++)
        {
            float[] q = new float[4];
            int digits = corner;
            for (int k = 0; k < 4; k++)
            {
                q[k] = k == left ? 0f : 0.5f * ((digits % 3) - 1);
                digits /= k == left ? 1 : 3;
            }

            q[left] = MathF.Sqrt(1f - (q[0] * q[0]) - (q[1] * q[1]) - (q[2] * q[2]) - (q[3] * q[3])) + 1e-6f;
            (ushort a, ushort b, ushort c) = PackedValue.Pack(new Quaternion(q[0], q[1], q[2], q[3]), 0.5f);
            Quaternion back = PackedValue.Turn(a, b, c, 0.5f);
            Assert.Equal(q[0], back.X, 1e-5f);
            Assert.Equal(q[1], back.Y, 1e-5f);
            Assert.Equal(q[2], back.Z, 1e-5f);
            Assert.Equal(q[3], back.W, 1e-5f);
        }
    }
}
