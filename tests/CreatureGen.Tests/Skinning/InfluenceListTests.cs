using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Seeding;
using CreatureGen.Skinning;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class InfluenceListTests
{
    [Fact]
    public void The_four_largest_are_kept_in_order_and_joints_are_added_up()
    {
        SkinWeights w = Weights((3, 0.1f), (9, 0.3f), (4, 0.2f), (7, 0.05f), (3, 0.15f), (5, 0.2f));
        Assert.Equal(new[] { 9, 3, 4, 5 }, new[] { w.Joint0, w.Joint1, w.Joint2, w.Joint3 });
        Assert.Equal(0.25f / 0.95f, w.Weights.Y, 1e-5f);
    }

    [Fact]
    public void Sums_are_exactly_one_in_any_order_of_adding()
    {
        RandomStream random = new Seed(1).Stream();
        for (int round = 0; round < 5000; round++)
        {
            var influences = Enumerable.Range(0, random.Integer(1, 9)).Select(j => (j + 2, (float)(random.Uniform(0, 1) * random.Uniform(0, 1)))).ToArray();
            Vector4 w = Weights(influences).Weights;
            Assert.Equal(1f, w.X + w.Y + w.Z + w.W);
            Assert.Equal(1f, w.W + w.X + w.Y + w.Z);
            Assert.True(w.X >= w.Y && w.Y >= w.Z && w.Z >= w.W && w.W >= 0f);
        }
    }

    [Fact]
    public void Thirds_stay_in_order_and_a_tie_goes_to_the_first_joint()
    {
        SkinWeights w = Weights((8, 1f), (6, 1f), (7, 1f));
        Assert.Equal(new[] { 6, 7, 8, 0 }, new[] { w.Joint0, w.Joint1, w.Joint2, w.Joint3 });
        Assert.True(w.Weights.X >= w.Weights.Y);
    }

    [Fact]
    public void What_cannot_be_seen_is_dropped()
    {
        SkinWeights w = Weights((4, 0.9985f), (5, 0.0015f));
        Assert.Equal((4, 0, 1f), (w.Joint0, w.Joint1, w.Weights.X));
    }

    [Fact]
    public void A_vertex_without_a_joint_or_with_a_weight_that_is_no_number_is_refused()
    {
        Assert.Throws<InvalidOperationException>(() => Weights());
        Assert.Throws<InvalidOperationException>(() => Weights((3, -1f)));
        Assert.Throws<InvalidOperationException>(() => Weights((3, float.NaN)));
        Assert.Throws<InvalidOperationException>(() => Weights((3, float.PositiveInfinity)));
        Assert.Throws<InvalidOperationException>(() => Weights(Enumerable.Range(1, InfluenceList.Capacity + 1).Select(j => (j, 1f)).ToArray()));
    }

    private static SkinWeights Weights(params (int Joint, float Weight)[] influences)
    {
        var list = new InfluenceList(new int[InfluenceList.Capacity], new float[InfluenceList.Capacity]);
        foreach ((int joint, float weight) in influences)
        {
            list.Add(joint, weight);
        }

        return list.ToWeights();
    }
}
