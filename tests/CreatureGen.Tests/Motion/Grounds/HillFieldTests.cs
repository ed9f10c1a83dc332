using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

public sealed class HillFieldTests
{
    [Theory]
    [InlineData(0.02f)]
    [InlineData(1f)]
    [InlineData(7f)]
    public void Hills_are_as_high_as_the_legs_make_them(float length)
    {
        HeightFieldGround ground = new HillField(new Seed(5), length).Around(5f * length, 0f, 40f * length);
        float lowest = float.MaxValue;
        float highest = float.MinValue;
        for (float z = 1f; z < 39f; z += 0.11f)
        {
            float y = At(ground, ((0.7f * z) % 9f - 4.5f) * length, z * length);
            lowest = Math.Min(lowest, y);
            highest = Math.Max(highest, y);
        }

        Assert.InRange(highest, 0.08f * length, 0.1441f * length);
        Assert.InRange(lowest, -0.1441f * length, -0.08f * length);
    }

    [Fact]
    public void Hills_are_where_they_are_however_much_of_them_is_asked_for()
    {
        var hills = new HillField(new Seed(9), 0.8f);
        HeightFieldGround near = hills.Around(3f, -1f, 4f);
        HeightFieldGround far = hills.Around(9f, -6f, 30f);
        for (float z = -0.9f; z < 4f; z += 0.37f)
        {
            // Cells of the two begin at different places, and are flat within.
            Assert.Equal(At(far, 0.21f, z), At(near, 0.21f, z), 2e-3f);
        }
    }

    [Fact]
    public void Hills_with_a_period_are_the_same_after_it_and_others_are_not()
    {
        const float Period = 3.7f;
        HeightFieldGround repeating = new HillField(new Seed(3), 0.7f, Period).Around(2f, -1f, 9f);
        HeightFieldGround endless = new HillField(new Seed(3), 0.7f).Around(2f, -1f, 9f);
        float max = 0f;
        for (float z = 0f; z < Period; z += 0.13f)
        {
            Assert.Equal(At(repeating, 0.4f, z), At(repeating, 0.4f, z + Period), 2e-3f);
            max = Math.Max(max, Math.Abs(At(endless, 0.4f, z) - At(endless, 0.4f, z + Period)));
        }

        Assert.True(max > 0.02f);
    }

    [Fact]
    public void Seeds_have_hills_of_their_own()
    {
        Assert.NotEqual(
            At(new HillField(new Seed(1), 1f).Around(2f, 0f, 2f), 0.5f, 1f),
            At(new HillField(new Seed(2), 1f).Around(2f, 0f, 2f), 0.5f, 1f));
    }

    [Theory]
    [InlineData(float.NaN, 1f)]
    [InlineData(0f, 1f)]
    [InlineData(1f, float.PositiveInfinity)]
    [InlineData(1f, 1e9f)]
    public void Hills_without_a_size_are_refused(float length, float to) =>
        Assert.ThrowsAny<ArgumentException>(() => new HillField(new Seed(1), length).Around(1f, 0f, to));

    private static float At(HeightFieldGround ground, float x, float z)
    {
        Assert.True(ground.Cast(new Vector3(x, 100f, z), -Vector3.UnitY, 200f, out GroundHit hit));
        return hit.Point.Y;
    }
}
