using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class SpeciesTests
{
    private const int Seeds = 40;

    public static TheoryData<string, RequestedKind> EveryBody
    {
        get
        {
            var data = new TheoryData<string, RequestedKind>();
            foreach (SpeciesProfile species in SpeciesCatalogue.All)
            {
                Add(species.Frequency.Walking, RequestedKind.Walking);
                Add(species.Frequency.Flying, RequestedKind.Flying);
                Add(species.Frequency.Swimming, RequestedKind.Swimming);

                void Add(double frequency, RequestedKind kind)
                {
                    if (frequency > 0)
                    {
                        data.Add(species.Body, kind);
                    }
                }
            }

            return data;
        }
    }

    [Fact]
    public void Every_body_has_a_profile_and_every_profile_a_body()
    {
        Assert.Equal(BaseBodyNames.All.Order(StringComparer.Ordinal), SpeciesCatalogue.All.Select(species => species.Body).Order(StringComparer.Ordinal));
        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            Assert.Equal(BaseBodies.Find(species.Body).Family, species.Family);
        }
    }

    [Fact]
    public void Every_profile_can_be_drawn_as_some_kind()
    {
        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            Assert.True(species.Frequency.Walking + species.Frequency.Flying + species.Frequency.Swimming > 0, species.Body);
            Assert.True(species.Frequency.Walking == 0 || species.WalkingPlans.Length > 0, species.Body);
            Assert.True(species.Frequency.Swimming == 0 || species.SwimmingPlans.Length > 0, species.Body);
            Assert.True(species.Dominance.Least <= species.Dominance.Most && species.Dominance.Most < 1, species.Body);
        }
    }

    [Fact]
    public void Tables_are_sections_that_can_be_mixed()
    {
        foreach (BaseBody body in BaseBodies.All)
        {
            for (int i = 0; i < BodyGrid.StationCount; i++)
            {
                Assert.True(body.Width[i] is >= 0.004 and < 0.8 && body.Top[i] is >= 0.004 and < 0.8 && body.Bottom[i] is >= 0.004 and < 0.8, $"{body.Name} station {i}");
                Assert.True(i == 0 ? body.Length[i] == 0 : body.Length[i] is > 0.01 and < 0.6, $"{body.Name} station {i}");
                Assert.InRange(body.Pitch[i], -Math.PI / 1.7, Math.PI / 1.7);
            }
        }
    }

    [Fact]
    public void A_mix_of_a_wasp_and_a_cow_keeps_the_waist()
    {
        var blend = new BodyBlend("wasp", "bovine", "bovine", 0.1, 0);
        BodyStations mixed = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = blend });
        Assert.True(mixed.Width[12] < 0.25 * mixed.Width[14]);
    }

    [Fact]
    public void A_mix_lies_between_its_bodies()
    {
        BaseBody a = BaseBodies.Find("shark");
        BaseBody b = BaseBodies.Find("owl");
        BodyStations mixed = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = new BodyBlend("shark", "owl", "owl", 0.3, 0.2) });
        BodyStations pure = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = new BodyBlend("shark", "owl", "owl", 0, 0) });
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            Assert.InRange(mixed.Width[i], Math.Min(a.Width[i], b.Width[i]) - 1e-12, Math.Max(a.Width[i], b.Width[i]) + 1e-12);
            Assert.InRange(mixed.Length[i], Math.Min(a.Length[i], b.Length[i]) - 1e-12, Math.Max(a.Length[i], b.Length[i]) + 1e-12);
            Assert.Equal(a.Top[i], pure.Top[i], 12);
        }
    }

    [Theory]
    [MemberData(nameof(EveryBody))]
    public void Every_body_builds_with_every_invariant(string body, RequestedKind kind)
    {
        var violations = new ConcurrentBag<string>();
        CreatureOptions options = Only(body, kind);
        Parallel.For(0, Seeds, new ParallelOptions { CancellationToken = TestContext.Current.CancellationToken }, i =>
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)i, options, out SocketTally sockets);
            Creature creature = CreatureGenerator.Build(blueprint);
            foreach (InvariantViolation violation in CreatureInspection.Inspect(creature))
            {
                violations.Add($"{body} {i}: {violation.Invariant}: {violation.Detail}");
            }

            if (sockets.LimbRefusals > 0 || blueprint.Body.Blend.First != body)
            {
                violations.Add($"{body} {i}: {sockets.LimbRefusals} refused, body {blueprint.Body.Blend.First}");
            }
        });
        Assert.True(violations.IsEmpty, string.Join("\n", violations.Order(StringComparer.Ordinal).Take(10)));
    }

    [Theory]
    [InlineData("beetle", 3)]
    [InlineData("spider", 4)]
    [InlineData("centipede", 12)]
    [InlineData("hopper", 3)]
    [InlineData("mantis", 3)]
    public void Insects_have_the_legs_of_their_species(string body, int pairs)
    {
        foreach (CreatureBlueprint blueprint in Drawn(body, RequestedKind.Walking))
        {
            Assert.Equal(pairs, blueprint.Legs.Count);
        }
    }

    [Fact]
    public void A_mantis_stands_on_four_legs_and_holds_up_two()
    {
        foreach (CreatureBlueprint blueprint in Drawn("mantis", RequestedKind.Walking))
        {
            Assert.Equal(2, blueprint.Legs.Count(leg => leg.Stance == LegStance.Standing));
            Assert.Equal(LimbArchetype.Raptorial, blueprint.Legs[0].Archetype);
        }
    }

    [Fact]
    public void A_wasp_has_a_waist_and_an_ant_two()
    {
        foreach (string body in new[] { "wasp", "ant" })
        {
            foreach (CreatureBlueprint blueprint in Drawn(body, RequestedKind.Walking))
            {
                BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
                Assert.True(shape.Width[38] < 0.4 * shape.Width[28], body);
                Assert.True(shape.Width[38] < 0.4 * shape.Width[48], body);
            }
        }
    }

    [Fact]
    public void Wing_cases_cover_a_beetle_s_back()
    {
        foreach (CreatureBlueprint blueprint in Drawn("beetle", RequestedKind.Walking))
        {
            Assert.Equal(ShellStyle.Elytra, blueprint.Body.Shell.Style);
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            BodySkin skin = BodySkin.Span(shape, blueprint.Body, blueprint.Head, blueprint.Tail);
            BodySkin bare = BodySkin.Span(shape, blueprint.Body with { Shell = blueprint.Body.Shell with { Style = ShellStyle.None } }, blueprint.Head, blueprint.Tail);
            Assert.True(skin[42, 6].X > 1.05f * bare[42, 6].X);
            Assert.Equal(bare[42, 12], skin[42, 12]);
        }
    }

    internal static IEnumerable<CreatureBlueprint> Drawn(string body, RequestedKind kind) =>
        Enumerable.Range(0, 12).Select(seed => BlueprintSampler.Sample((ulong)seed, Only(body, kind)));

    internal static CreatureOptions Only(string body, RequestedKind kind) => CreatureOptions.Default with
    {
        Kind = kind,
        BaseBodies = new ValueList<BaseBodyWeight>(BaseBodyNames.All.Select(name => new BaseBodyWeight(name, name == body ? 1 : 0))),
    };
}
