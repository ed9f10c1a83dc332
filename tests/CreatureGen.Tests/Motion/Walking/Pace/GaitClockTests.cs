using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public sealed class GaitClockTests
{
    private const float Gravity = 9.81f;

    /// <summary>Creatures of broad and of narrow build turn on the spot in steps of one size, or in smaller ones where a leg does not reach so far.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Upright)]
    [InlineData(BodyPlan.Sprawling)]
    public void A_cycle_on_the_spot_turns_the_body_by_no_more_than_26_degrees(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            LeggedBody body = LeggedBody.Of(new MotionSubject(creature))!;
            foreach (float turn in new[] { 0.1f, 0.4f, -0.9f })
            {
                var clock = new GaitClock(body, GaitLibrary.Walk);
                clock.Slide(0.01f, RootVelocity.At(0f, 0f, turn), Gravity, 0f, 0f);
                Assert.True(clock.Frequency >= System.Math.Abs(turn) / 0.45f - 1e-4f, $"{clock.Frequency} cycles per second at {turn} rad/s");
            }
        }
    }
}
