using System;
using System.Numerics;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class SkinWeightsTests
{
    [Theory]
    [InlineData(0, 0, 0, 0)]
    [InlineData(short.MaxValue, 3, 2, 1)]
    public void Joints_come_back_as_they_were_given(int first, int second, int third, int fourth)
    {
        var weights = new SkinWeights(first, second, third, fourth, Vector4.UnitX);
        Assert.Equal((first, second, third, fourth), (weights.Joint0, weights.Joint1, weights.Joint2, weights.Joint3));
    }

    [Theory]
    [InlineData(short.MaxValue + 1, 0, 0, 0)]
    [InlineData(0, 65536, 0, 0)]
    [InlineData(0, 0, int.MaxValue, 0)]
    [InlineData(0, 0, 0, int.MinValue)]
    public void A_joint_of_more_than_two_bytes_is_refused_by_its_number(int first, int second, int third, int fourth)
    {
        var refused = Assert.Throws<ArgumentOutOfRangeException>(() => new SkinWeights(first, second, third, fourth, Vector4.UnitX));
        Assert.Contains(FormattableString.Invariant($"joints {first}, {second}, {third} and {fourth}; expected none outside -32768..32767"), refused.Message);
    }
}
