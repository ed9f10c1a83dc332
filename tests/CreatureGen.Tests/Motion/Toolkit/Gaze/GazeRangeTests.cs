using CreatureGen.Motion.Toolkit;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Gaze;

public sealed class GazeRangeTests
{
    private static readonly GazeSettings settings = new(10f, maxYaw: 1.2f, maxUp: 0.3f, maxDown: 0.9f);

    [Theory]
    [InlineData(0f, 1.4f, 0f, 0.3f)]
    [InlineData(0f, -1.4f, 0f, -0.9f)]
    [InlineData(2f, 0.1f, 1.2f, 0.1f)]
    [InlineData(-2f, -0.1f, -1.2f, -0.1f)]
    [InlineData(0.5f, -0.5f, 0.5f, -0.5f)]
    public void A_head_looks_up_and_down_as_far_as_each_goes(float yaw, float pitch, float yawTaken, float pitchTaken)
    {
        LookAngles taken = GazeSolver.Bounded(new LookAngles(yaw, pitch), 0f, settings);
        Assert.Equal(new LookAngles(yawTaken, pitchTaken), taken);
    }

    [Fact]
    public void A_head_stays_on_its_side_of_what_is_straight_behind()
    {
        Assert.Equal(-1.2f, GazeSolver.Bounded(new LookAngles(3f, 0f), -0.5f, settings).Yaw);
        Assert.Equal(1.2f, GazeSolver.Bounded(new LookAngles(3f, 0f), 0.5f, settings).Yaw);
        Assert.Equal(1.2f, GazeSolver.Bounded(new LookAngles(2f, 0f), -0.5f, settings).Yaw);
    }
}
