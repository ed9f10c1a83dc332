using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Legs;

public sealed class FootRollTests
{
    [Fact]
    public void Toes_of_a_flat_foot_leave_the_ground_without_a_jerk()
    {
        const float Step = 0.002f;
        float rate = 0f;
        for (float pitch = 0f; pitch < 1.3f; pitch += Step)
        {
            float next = (FootRoll.ToePitch(pitch + Step) - FootRoll.ToePitch(pitch)) / Step;
            Assert.InRange(next - rate, -0.005f, 0.005f);
            rate = next;
        }

        Assert.Equal(0.8f, rate, 0.001f);
        Assert.Equal(0f, FootRoll.ToePitch(0.3f));
    }

    [Theory]
    [InlineData(BodyPlan.Plantigrade)]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void A_heel_begins_to_rise_earlier_the_shorter_the_stance_and_is_up_as_it_ends(BodyPlan plan)
    {
        foreach (LegRig leg in new MotionProfile(StrokeSubject.Of(plan)[0]).Legs!.Legs)
        {
            float first = 1f;
            float last = 0f;
            foreach (float duty in new[] { 0.35f, 0.45f, 0.55f, 0.65f, 0.8f })
            {
                float begins = 0.2f;
                while (FootRoll.Pitch(Standing(begins), leg, duty, 1f) <= 0f)
                {
                    begins += 0.005f;
                }

                Assert.True(begins >= last, $"duty {duty}: {begins} after {last}");
                Assert.InRange(begins, 0.495f, 0.63f);
                Assert.Equal(leg.Traits.ToeOff * leg.RollFraction, FootRoll.Pitch(Standing(1f), leg, duty, 1f), 1e-5f);
                first = Math.Min(first, begins);
                last = begins;
            }

            Assert.True(first < last - 0.03f, $"{first} to {last}");
        }
    }

    private static Foot Standing(float progress) => new() { Phase = FootPhase.Stance, Stance = progress };
}
