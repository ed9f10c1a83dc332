using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Inspection;

/// <summary>What the library promises of every seed, over 40 seeds of each kind, and 2,000 when all is asked for.</summary>
public sealed class EverySeedTests
{
    /// <summary>Per thousand animals; the surface is untangled as far as smoothing does it.</summary>
    private const int MaxSelfIntersecting = 3;

    /// <summary>Per thousand creatures whose parts are of several animals: thick legs and fins set where no animal has them. As measured.</summary>
    private const int MaxStrangeSelfIntersecting = 5;

    [Theory]
    [InlineData(RequestedKind.Walking, 12, 0)]
    [InlineData(RequestedKind.Walking, 12, 0.6)]
    [InlineData(RequestedKind.Flying, 12, 0)]
    [InlineData(RequestedKind.Flying, 12, 0.6)]
    [InlineData(RequestedKind.Swimming, 12, 0)]
    [InlineData(RequestedKind.Swimming, 12, 0.6)]
    [InlineData(RequestedKind.Walking, 2000, 0, Explicit = true)]
    [InlineData(RequestedKind.Walking, 2000, 0.6, Explicit = true)]
    [InlineData(RequestedKind.Flying, 2000, 0, Explicit = true)]
    [InlineData(RequestedKind.Flying, 2000, 0.6, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 2000, 0, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 2000, 0.6, Explicit = true)]
    public void Every_creature_keeps_every_invariant(RequestedKind kind, int seeds, double strangeness)
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = kind, Strangeness = strangeness };
        var violations = new ConcurrentBag<string>();
        int selfIntersecting = 0;
        Parallel.For(0, seeds, new ParallelOptions { CancellationToken = TestContext.Current.CancellationToken }, i =>
        {
            ulong seed = (ulong)i;
            Creature creature = CreatureAssembler.Assemble(BlueprintSampler.Sample(seed, options, out SocketTally sockets));
            foreach (InvariantViolation violation in CreatureInspection.Inspect(creature))
            {
                violations.Add($"{kind} {seed}: {violation.Invariant}: {violation.Detail}");
            }

            if (sockets.LimbRefusals != 0)
            {
                violations.Add($"{kind} {seed}: {sockets.LimbRefusals} sockets of limbs refused");
            }

            if (CreatureInspection.CountSelfIntersections(creature) > 0)
            {
                Interlocked.Increment(ref selfIntersecting);
            }
        });

        Assert.True(violations.IsEmpty, string.Join("\n", violations.OrderBy(line => line, StringComparer.Ordinal).Take(20)));
        Assert.InRange(selfIntersecting, 0, Math.Max(1, (strangeness > 0 ? MaxStrangeSelfIntersecting : MaxSelfIntersecting) * seeds / 1000));
    }

    [Theory]
    [InlineData(0.5, 6000, 4)]
    [InlineData(0.05, 20000, 4)]
    [InlineData(20, 20000, 4)]
    [InlineData(0.5, 6000, 40, Explicit = true)]
    [InlineData(0.05, 20000, 40, Explicit = true)]
    [InlineData(20, 20000, 40, Explicit = true)]
    public void Size_breaks_no_invariant(double scale, int budget, int seeds)
    {
        foreach (LocomotionKind kind in new[] { LocomotionKind.Walking, LocomotionKind.Flying, LocomotionKind.Swimming })
        {
            for (ulong seed = 0; seed < (ulong)seeds; seed++)
            {
                Creature creature = CreatureAssembler.Assemble(BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking + (int)kind, Strangeness = 0 }) with { Scale = scale, TriangleBudget = budget });
                IEnumerable<InvariantViolation> found = CreatureInspection.Inspect(creature);
                Assert.Empty(found);
            }
        }
    }

    /// <summary>Their arms are a twentieth of them and far in front of their hips. Seed 66549 once stood on the tips of its toes.</summary>
    [Fact]
    public void Uprights_stand_over_the_weight_of_body_and_arms()
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = BodyPlanWeight.Only(BodyPlan.Upright) };
        int armed = 0;
        foreach (ulong seed in Enumerable.Range(0, Thoroughness.Of(120)).Select(i => (ulong)i).Append(66549UL))
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, options);
            if (!blueprint.Legs.Any(leg => leg.Archetype == LimbArchetype.Arm))
            {
                continue;
            }

            armed++;
            Creature creature = CreatureAssembler.Assemble(blueprint with { Legs = new(blueprint.Legs.Select(leg => leg with { ClawLength = 0 }).ToArray()) });
            float[] soles = creature.Mesh.Positions.ToArray().Where(p => p.Y <= 0.004f * creature.StandingHeight).Select(p => p.Z).ToArray();
            float along = (creature.Mass.Centre.Z - soles.Min()) / (soles.Max() - soles.Min());
            Assert.True(along is > 0.18f and < 0.8f, $"{seed}: {along} of the way from heel to toe");
        }

        Assert.True(armed > Thoroughness.Of(60), $"{armed} with arms");
    }

    /// <summary>Serpents with great heads and short tails, which even a raised front did not carry.</summary>
    [Theory]
    [InlineData(57061)]
    [InlineData(53362)]
    [InlineData(81008)]
    public void Heavy_heads_do_not_tip_a_serpent_over(ulong seed) =>
        Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(BlueprintSampler.Sample(seed, LocomotionKind.Walking))));
}
