using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public sealed class EffortTests
{
    [Fact]
    public void A_body_at_steady_speed_shows_none()
    {
        Assert.Equal(default, Effort.Of(Body(1), 0f, 0f));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(5)]
    public void It_crouches_and_leans_into_a_start_and_sits_back_in_braking(ulong seed)
    {
        LeggedBody body = Body(seed);
        Effort starts = Effort.Of(body, 0.4f, 0f);
        Effort brakes = Effort.Of(body, -0.4f, 0f);
        Assert.True(starts.HindDrop > 0f && starts.Shift > 0f && starts.Lean > 0f);
        Assert.True(brakes.HindDrop > 0f && brakes.ForeDrop < 0f && brakes.Shift < 0f && brakes.Lean < 0f);
        Assert.InRange(brakes.HindDrop, starts.HindDrop, 0.15f * body.LegLength);
    }

    [Fact]
    public void More_than_half_of_gravity_shows_no_more()
    {
        Assert.Equal(Effort.Of(Body(1), 0.5f, 0f), Effort.Of(Body(1), 5f, 0f));
        Assert.Equal(Effort.Of(Body(1), -0.5f, 0f), Effort.Of(Body(1), -5f, 0f));
    }

    [Fact]
    public void Who_brakes_uphill_or_starts_downhill_leaves_to_its_weight_what_that_does()
    {
        LeggedBody body = Body(1);
        Assert.Equal(Effort.Of(body, -0.25f, 0f), Effort.Of(body, -0.5f, 0.25f));
        Assert.Equal(Effort.Of(body, 0.25f, 0f), Effort.Of(body, 0.5f, -0.25f));
        Assert.Equal(default, Effort.Of(body, -0.3f, 0.4f));
        Assert.Equal(Effort.Of(body, -0.3f, 0f), Effort.Of(body, -0.3f, -0.4f));
    }

    private static LeggedBody Body(ulong seed) => LeggedBody.Of(new MotionSubject(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking })))!;
}
