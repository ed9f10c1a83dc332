using System.Numerics;
using CreatureGen.Motion.Toolkit;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class IkStatusTests
{
    /// <summary>A limb of 1 m and 1 m that stretches to 1.989 m, eases from 1.925 m and folds to 0.518 m.</summary>
    [Theory]
    [InlineData(1.2f, IkStatus.Reached)]
    [InlineData(1.9f, IkStatus.Reached)]
    [InlineData(1.98f, IkStatus.Softened)]
    [InlineData(2.5f, IkStatus.TooFar)]
    [InlineData(0.3f, IkStatus.TooNear)]
    public void A_limb_says_how_it_came_to_its_target(float distance, IkStatus status)
    {
        IkResult result = TwoBoneIk.Solve(Vector3.Zero, new Vector3(0f, -1f, 0f), new Vector3(0f, -1.9f, -0.435f), Vector3.UnitX, new Vector3(0f, -distance, 0f), Vector3.UnitZ, Reach.Default, out _, out _);
        Assert.Equal(status, result.Status);
        Assert.Equal(status == IkStatus.Reached, result.Reached);
        Assert.Equal(status == IkStatus.TooFar ? distance - 1.989f : status == IkStatus.TooNear ? 0.518f - distance : 0f, result.Residual, 0.03f);
    }

    /// <summary>The reach alone says so too, before the limb is asked.</summary>
    [Fact]
    public void A_reach_says_which_end_of_it_is_in_the_way()
    {
        Reach.Default.Limit(0.3, 1, 1, out IkStatus near);
        Reach.Default.Limit(2.5, 1, 1, out IkStatus far);
        Assert.Equal(IkStatus.TooNear, near);
        Assert.Equal(IkStatus.TooFar, far);
    }
}
