using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class OutwardOrderTests
{
    [Fact]
    public void Joints_of_different_chains_take_turns()
    {
        // Two chains of three joints each on a root.
        Assert.Equal([0, 1, 4, 2, 5, 3, 6], OutwardOrder.Of([-1, 0, 1, 2, 0, 4, 5]));
    }

    [Fact]
    public void A_single_joint_a_chain_and_a_fan_stay_as_they_are()
    {
        Assert.Empty(OutwardOrder.Of([]));
        Assert.Equal([0], OutwardOrder.Of([-1]));
        Assert.Equal([0, 1, 2, 3], OutwardOrder.Of([-1, 0, 1, 2]));
        Assert.Equal([0, 1, 2, 3], OutwardOrder.Of([-1, 0, 0, 0]));
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Every_joint_comes_once_and_after_its_parent(BodyPlan plan)
    {
        Skeleton skeleton = RigSubject.Of(plan).Skeleton;
        int[] order = skeleton.Outwards.ToArray();
        Assert.Equal(Enumerable.Range(0, skeleton.Count), order.Order());
        Assert.All(order.Skip(1), joint => Assert.True(Array.IndexOf(order, skeleton.Parents[joint]) < Array.IndexOf(order, joint)));
    }
}
