using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class ActTrialTests
{
    [Theory]
    [InlineData(RequestedKind.Walking, 4100, 6)]
    [InlineData(RequestedKind.Flying, 4100, 3)]
    [InlineData(RequestedKind.Swimming, 4100, 3)]
    public void Acts_keep_to_joints_speeds_ground_and_feet(RequestedKind kind, ulong first, int count)
    {
        List<string> wrong = [];
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = 0 });
            var profile = new MotionProfile(creature);
            foreach (ActTrial trial in ActTrial.Of(profile))
            {
                ActReport report = trial.Run(profile);
                Check("limit", report.LimitExcess, 0.0175f);
                Check("speed", report.JointSpeed, 120f);
                Check("slip", report.FootSlip ?? 0f, 0.03f);
                Check("sinks", report.Penetration ?? 0f, 0.03f);
                Check("misses", report.ContactError ?? 0f, 0.02f);

                void Check(string what, float value, float most)
                {
                    if (!(value <= most))
                    {
                        wrong.Add(FormattableString.Invariant($"{kind} {seed} {creature.Blueprint.Plan} {trial.Ability}: {what} {value:0.000}"));
                    }
                }
            }
        }

        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_creature_that_stands_can_do_most_of_the_acts()
    {
        int possible = 0;
        int all = 0;
        for (ulong seed = 4200; seed < 4210; seed++)
        {
            CreatureActs acts = new MotionProfile(Walkers.Any(seed)).Acts;
            possible += acts.Possible.Count();
            all += acts.All.Count;
            Assert.All(acts.All, ability => Assert.True(ability.IsPossible || ability.Refusal!.Length > 10, ability.Act.Name));
        }

        Assert.InRange(possible / (double)all, 0.5, 1);
    }
}
