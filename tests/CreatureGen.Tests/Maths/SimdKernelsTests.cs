using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Maths;

/// <summary>Products side by side in a register against the same written out, bit for bit.</summary>
public sealed class SimdKernelsTests
{
    private const int Draws = 20000;

    [Fact]
    public void Products_have_the_bits_of_their_written_out_forms()
    {
        var stream = new RandomStream(5);
        for (int i = 0; i < Draws; i++)
        {
            Quaternion a = Drawn(stream);
            Quaternion b = Drawn(stream);
            var v = new Vector3(a.Z, b.X, b.W);
            var w = new Vector3(b.Y, a.W, a.X);
            Same(Product(a, b), SimdKernels.Multiply(a, b));
            Same(new Quaternion(-a.X, -a.Y, -a.Z, a.W), SimdKernels.Conjugate(a));
            Same(new Quaternion(a.X * b.Z, a.Y * b.Z, a.Z * b.Z, a.W * b.Z), SimdKernels.Scale(a, b.Z));
            Same(new Quaternion((a.X * b.Z) + (b.X * b.Y), (a.Y * b.Z) + (b.Y * b.Y), (a.Z * b.Z) + (b.Z * b.Y), (a.W * b.Z) + (b.W * b.Y)), SimdKernels.Mix(a, b.Z, b, b.Y));
            Same((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W), SimdKernels.Dot(a, b));
            Same(new Vector3((v.Y * w.Z) - (v.Z * w.Y), (v.Z * w.X) - (v.X * w.Z), (v.X * w.Y) - (v.Y * w.X)), SimdKernels.Cross(v, w));
            Same((v.X * w.X) + (v.Y * w.Y) + (v.Z * w.Z), Vec.Dot(v, w));
            Same(Turned(a, v, 2f), SimdKernels.Rotate(a, v));
            Same(Turned(a, v, 2f / SimdKernels.Dot(a, a)), SimdKernels.RotateByAny(a, SimdKernels.Dot(a, a), v));
        }
    }

    [Fact]
    public void A_quarter_turn_about_up_takes_ahead_to_the_left()
    {
        var quarter = new Quaternion(0f, MathF.Sqrt(0.5f), 0f, MathF.Sqrt(0.5f));
        Vector3 left = SimdKernels.Rotate(quarter, Vector3.UnitZ);
        Assert.True(Vec.Distance(left, Vector3.UnitX) < 1e-6f);
        Assert.True(Vec.Distance(left, SimdKernels.RotateByAny(SimdKernels.Scale(quarter, 7f), 49f, Vector3.UnitZ)) < 1e-6f);
        Assert.Equal(new Vector3(0f, 0f, 1f), SimdKernels.Cross(Vector3.UnitX, Vector3.UnitY));
        Assert.Equal(new Quaternion(0f, 0f, 1f, 0f), SimdKernels.Multiply(new Quaternion(1f, 0f, 0f, 0f), new Quaternion(0f, 1f, 0f, 0f)));
    }

    [Fact]
    public void The_smaller_and_the_larger_are_those_of_comparisons_and_the_second_where_none_is()
    {
        float[] numbers = { 0f, -0f, 1f, -1f, 2.5f, float.MaxValue, float.MinValue, float.PositiveInfinity, float.NaN };
        foreach (float a in numbers)
        {
            foreach (float b in numbers)
            {
                Same(new Vector3(a < b ? a : b, b < a ? b : a, b), SimdKernels.Min(new Vector3(a, b, b), new Vector3(b, a, b)));
                Same(new Vector3(a > b ? a : b, b > a ? b : a, b), SimdKernels.Max(new Vector3(a, b, b), new Vector3(b, a, b)));
            }
        }
    }

    private static Quaternion Drawn(RandomStream stream) => new(Number(stream), Number(stream), Number(stream), Number(stream));

    private static float Number(RandomStream stream) => (float)stream.Uniform(-1, 1);

    private static Quaternion Product(Quaternion a, Quaternion b) => new(
        (a.W * b.X) + (a.X * b.W) + (a.Y * b.Z) - (a.Z * b.Y),
        (a.W * b.Y) - (a.X * b.Z) + (a.Y * b.W) + (a.Z * b.X),
        (a.W * b.Z) + (a.X * b.Y) - (a.Y * b.X) + (a.Z * b.W),
        (a.W * b.W) - (a.X * b.X) - (a.Y * b.Y) - (a.Z * b.Z));

    private static Vector3 Turned(Quaternion q, Vector3 v, float twice)
    {
        float tx = twice * ((q.Y * v.Z) - (q.Z * v.Y));
        float ty = twice * ((q.Z * v.X) - (q.X * v.Z));
        float tz = twice * ((q.X * v.Y) - (q.Y * v.X));
        return new Vector3(
            v.X + (q.W * tx) + ((q.Y * tz) - (q.Z * ty)),
            v.Y + (q.W * ty) + ((q.Z * tx) - (q.X * tz)),
            v.Z + (q.W * tz) + ((q.X * ty) - (q.Y * tx)));
    }

    private static void Same(float expected, float actual) => Assert.Equal(BitConverter.SingleToInt32Bits(expected), BitConverter.SingleToInt32Bits(actual));

    private static void Same(Vector3 expected, Vector3 actual)
    {
        Same(expected.X, actual.X);
        Same(expected.Y, actual.Y);
        Same(expected.Z, actual.Z);
    }

    private static void Same(Quaternion expected, Quaternion actual)
    {
        Same(expected.X, actual.X);
        Same(expected.Y, actual.Y);
        Same(expected.Z, actual.Z);
        Same(expected.W, actual.W);
    }
}
