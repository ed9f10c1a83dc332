using System;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

public sealed class WingBeatEventTests
{
    [Theory]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Buzzing)]
    public void An_animator_tells_of_every_beat_once_and_evenly_at_any_frame_rate(BodyPlan plan)
    {
        Creature creature = StrokeSubject.Of(plan)[0];
        int[] counts = new int[3];
        int[] rates = { 4, 30, 144 };
        for (int r = 0; r < rates.Length; r++)
        {
            var animator = new CreatureAnimator(creature);
            double last = double.NaN;
            for (int i = 0; i < 12 * rates[r]; i++)
            {
                animator.Update(1f / rates[r], new MotionInput(creature.DefaultSpeed, ClimbRate: creature.DefaultSpeed, Medium: MotionMedium.Air), FlatGround.Level);
                foreach (MotionEvent e in animator.Events)
                {
                    if (e.Kind != MotionEventKind.WingBeat)
                    {
                        continue;
                    }

                    double at = ((i + 1.0) / rates[r]) - e.SecondsAgo;
                    counts[r]++;
                    Assert.True(!(at <= last), "beats come one after the other");
                    if (at > 6 && !double.IsNaN(last))
                    {
                        Assert.InRange((at - last) * animator.Frequency, 0.97, 1.03);
                    }

                    last = at;
                    Assert.Equal(CreatureGen.Rigging.JointRole.Wing, creature.Skeleton.Joints[e.Joint].Role);
                }
            }
        }

        Assert.True(counts[0] > 10);
        Assert.True(Math.Abs(counts[0] - counts[2]) <= 1 + (counts[2] / 40) && Math.Abs(counts[1] - counts[2]) <= 1, $"{counts[0]} {counts[1]} {counts[2]}");
    }
}
