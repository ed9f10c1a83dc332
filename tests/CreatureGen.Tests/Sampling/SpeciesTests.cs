using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Inspection;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class SpeciesTests
{
    /// <summary>Seeds of each body: a few, or as many as the environment asks for when everything is tested.</summary>
    private static readonly int Seeds = Thoroughness.IsExhaustive ? 40 : 2;

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
        Assert.Equal(BaseBodyNames.All, SpeciesCatalogue.All.Select(species => species.Body));
        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            Assert.Equal(BaseBodyNames.FamilyOf(species.Body), species.Family);
            Assert.Same(species, SpeciesCatalogue.Find(species.Body));
        }

        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            Assert.Equal(1, SpeciesCatalogue.All.Count(other => ReferenceEquals(other.Table, species.Table)));
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
            Assert.True(species.Dominance.Min <= species.Dominance.Max && species.Dominance.Max < 1, species.Body);
        }
    }

    [Fact]
    public void Tables_are_sections_that_can_be_mixed()
    {
        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            BodyTable body = species.Table;
            for (int i = 0; i < BodyGrid.StationCount; i++)
            {
                Assert.True(body.Width[i] is >= 0.004 and < 0.8 && body.Top[i] is >= 0.004 and < 0.8 && body.Bottom[i] is >= 0.004 and < 0.8, $"{species.Body} station {i}");
                Assert.True(i == 0 ? body.Length[i] == 0 : body.Length[i] is > 0.01 and < 0.6, $"{species.Body} station {i}");
                Assert.InRange(body.Pitch[i], -Math.PI / 1.7, Math.PI / 1.7);
            }
        }
    }

    [Fact]
    public void A_mix_of_a_wasp_and_a_cow_keeps_the_waist()
    {
        var blend = BodyBlend.Of("wasp", "bovine", "bovine", 0.1, 0);
        BodyStations mixed = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = blend });
        Assert.True(mixed.Width[12] < 0.25 * mixed.Width[14]);
    }

    [Fact]
    public void A_mix_lies_between_its_bodies()
    {
        BodyTable a = SpeciesCatalogue.Find("shark").Table;
        BodyTable b = SpeciesCatalogue.Find("owl").Table;
        BodyStations mixed = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = BodyBlend.Of("shark", "owl", "owl", 0.3, 0.2) });
        BodyStations pure = BodyBlender.Blend(BodyFields.Body.Neutral with { Blend = BodyBlend.Of("shark", "owl", "owl", 0, 0) });
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
        CreatureOptions options = SpeciesSubject.Only(body, kind);
        Parallel.For(0, Seeds, new ParallelOptions { CancellationToken = TestContext.Current.CancellationToken }, i =>
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)i, options, out SocketTally sockets);
            Creature creature = CreatureAssembler.Assemble(blueprint);
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
            BodySkin skin = BodySkin.Span(shape, blueprint);
            BodySkin bare = BodySkin.Span(shape, blueprint with { Body = blueprint.Body with { Shell = blueprint.Body.Shell with { Style = ShellStyle.None } } });
            Assert.True(skin[42, 6].X > 1.05f * bare[42, 6].X);
            Assert.Equal(bare[42, 12], skin[42, 12]);
        }
    }

    [Fact]
    public void A_turtle_s_shell_is_wider_than_its_neck_and_stands_off_its_body()
    {
        foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Swimming })
        {
            foreach (CreatureBlueprint blueprint in Drawn("turtle", kind))
            {
                Assert.Equal(ShellStyle.Carapace, blueprint.Body.Shell.Style);
                BodySkin skin = SkinOf(blueprint);
                BodySkin bare = SkinOf(blueprint with { Body = blueprint.Body with { Shell = blueprint.Body.Shell with { Style = ShellStyle.None } } });
                Assert.True(skin[34, 7].X > 3 * skin[18, 7].X);
                Assert.True(skin[34, 7].X > 1.15f * bare[34, 7].X);
                Assert.True(skin[34, 7].X > skin[34, 9].X, "the rim overhangs");
            }
        }
    }

    [Fact]
    public void A_ray_is_wider_than_it_is_deep_and_a_shark_s_tail_is_higher_above_than_below()
    {
        foreach (CreatureBlueprint blueprint in Drawn("ray", RequestedKind.Swimming))
        {
            BodySkin skin = SkinOf(blueprint);
            Assert.True(skin[24, 8].X > 2.5f * (skin[24, 0].Y - skin[24, 16].Y));
        }

        foreach (CreatureBlueprint blueprint in Drawn("shark", RequestedKind.Swimming))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Top[53] > 1.5 * shape.Bottom[53]);
        }
    }

    [Fact]
    public void A_cock_has_a_comb_and_a_pair_of_wattles_and_carries_its_tail_high()
    {
        foreach (CreatureBlueprint blueprint in Drawn("rooster", RequestedKind.Walking))
        {
            Assert.Single(blueprint.Features, part => part.Kind == FeatureKind.Comb && part.Segment == 0);
            Assert.Single(blueprint.Features, part => part.Kind == FeatureKind.Comb && part.Segment > 10);
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Y[53] > shape.Y[40] + 0.1, "the end of its tail is above its back");
        }
    }

    [Fact]
    public void An_angler_has_a_lure_and_teeth()
    {
        foreach (CreatureBlueprint blueprint in Drawn("angler", RequestedKind.Swimming))
        {
            Assert.Single(blueprint.Features, part => part.Kind == FeatureKind.Lure);
            Assert.True(blueprint.Head.Mouth.Opening > 0.2 && blueprint.Head.Mouth.Teeth > 0.2);
        }
    }

    [Theory]
    [InlineData("duck")]
    [InlineData("raptor")]
    [InlineData("ostrich")]
    [InlineData("parrot")]
    [InlineData("heron")]
    [InlineData("owl")]
    [InlineData("penguin")]
    [InlineData("toucan")]
    public void A_walking_bird_folds_its_wings(string body)
    {
        foreach (CreatureBlueprint blueprint in Drawn(body, RequestedKind.Walking))
        {
            Assert.Equal(WingStyle.Folded, Assert.Single(blueprint.Wings).Style);
            Assert.Equal(LimbArchetype.Bird, Assert.Single(blueprint.Legs).Archetype);
        }
    }

    [Fact]
    public void A_folded_wing_lies_close_to_the_flank_from_the_shoulder_to_the_tail()
    {
        foreach (CreatureBlueprint blueprint in Drawn("owl", RequestedKind.Walking))
        {
            GrownSurface grown = GrownSurface.Grow(blueprint);
            BodyShape shape = grown.Skin.Shape;
            float widest = (float)shape.Width.Max();
            int found = 0;
            for (int v = 0; v < grown.Surface.Positions.Length; v++)
            {
                if (grown.Surface.Addresses[v].Region == SurfaceRegion.Wing)
                {
                    Vector3 p = grown.Surface.Positions[v];
                    Assert.True(Math.Abs(p.X) < widest + 0.12f && p.Z < shape.Z[23] + 0.05f && p.Z > shape.Z[54] - 0.1f);
                    found++;
                }
            }

            Assert.True(found > 200);
        }
    }

    [Fact]
    public void Herons_stand_high_and_parrots_low()
    {
        double Height(string body) => Drawn(body, RequestedKind.Walking).Average(b => BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail).Y[36]);
        Assert.True(Height("heron") > 1.5 * Height("parrot"));
    }

    [Fact]
    public void A_frog_s_hind_feet_stand_outside_of_its_fore_feet_and_a_cobra_s_hood_outside_of_its_head()
    {
        foreach (CreatureBlueprint blueprint in Drawn("frog", RequestedKind.Walking))
        {
            IReadOnlyList<CreatureGen.Rigging.Appendage> limbs = GrownSurface.Grow(blueprint).Appendages;
            Assert.True(limbs[1].Contact.X > limbs[0].Contact.X);
        }

        foreach (CreatureBlueprint blueprint in Drawn("cobra", RequestedKind.Walking))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Width[19] > 1.5 * shape.Width[12] && shape.Width[19] > 1.5 * shape.Width[28]);
        }
    }

    [Fact]
    public void A_penguin_stands_upright_and_a_parrot_s_tail_is_not_raised_to_the_sky()
    {
        foreach (CreatureBlueprint blueprint in Drawn("penguin", RequestedKind.Walking))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Y[20] - shape.Y[40] > 1.2 * Math.Abs(shape.Z[20] - shape.Z[40]));
        }

        foreach (CreatureBlueprint blueprint in Drawn("parrot", RequestedKind.Walking).Concat(Drawn("toucan", RequestedKind.Walking)))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.InRange(shape.Pitch[54], -0.9, 0.9);
        }
    }

    [Fact]
    public void A_rabbit_s_ears_are_longer_than_its_head_is_wide_and_a_bear_s_are_not()
    {
        Assert.All(Drawn("rabbit", RequestedKind.Walking).Where(b => b.Ears[0].Droop == 0), b => Assert.True(Ear(b) > 2));
        Assert.All(Drawn("bear", RequestedKind.Walking), b => Assert.True(Ear(b) < 0.9));

        static double Ear(CreatureBlueprint b) => Assert.Single(b.Ears).Length / BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail).Width[13];
    }

    [Fact]
    public void A_rhino_has_a_horn_on_its_nose_and_a_boar_stands_lower_than_a_horse()
    {
        Assert.All(Drawn("rhino", RequestedKind.Walking), b => Assert.Contains(b.Features, part => part.Kind == FeatureKind.Horn && part.Ring < 3 && part.Segment == 0));
        Assert.True(Hip("horse") > 1.2 * Hip("boar"));

        static double Hip(string body) => Drawn(body, RequestedKind.Walking).Average(b => BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail).Y[42]);
    }

    [Fact]
    public void Bats_and_pterosaurs_fly_on_membranes_and_have_one_pair_of_legs()
    {
        foreach ((string body, WingStyle style) in new[] { ("bat", WingStyle.Bat), ("pterosaur", WingStyle.Pterosaur) })
        {
            foreach (CreatureBlueprint blueprint in Drawn(body, RequestedKind.Flying))
            {
                Assert.Equal(style, Assert.Single(blueprint.Wings).Style);
                Assert.Single(blueprint.Legs);
            }
        }
    }

    [Fact]
    public void A_bat_has_a_short_muzzle_and_thighs_less_than_half_as_thick_as_its_trunk()
    {
        foreach (CreatureBlueprint blueprint in Drawn("bat", RequestedKind.Flying))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Arc[8] - shape.Arc[0] < 2 * shape.Width[12], $"{shape.Arc[8] - shape.Arc[0]} and {shape.Width[12]}");
            LegBlueprint leg = Assert.Single(blueprint.Legs);
            Assert.True(2 * leg.Thickness < 0.5 * (shape.Top[30] + shape.Bottom[30]), $"{2 * leg.Thickness} and {shape.Top[30] + shape.Bottom[30]}");
        }
    }

    [Fact]
    public void A_flying_fish_seldom_has_legs_and_hardly_ever_four()
    {
        int[] pairs = new int[3];
        for (ulong seed = 0; seed < 200; seed++)
        {
            pairs[BlueprintSampler.Sample(seed, SpeciesSubject.Only("fish", RequestedKind.Flying)).Legs.Count]++;
        }

        Assert.InRange(pairs[0], 110, 155);
        Assert.InRange(pairs[2], 1, 24);
    }

    [Fact]
    public void A_puffer_is_deeper_than_a_third_of_its_length_and_a_swordfish_s_sword_longer_than_its_head()
    {
        foreach (CreatureBlueprint blueprint in Drawn("puffer", RequestedKind.Swimming))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(3 * (shape.Top[26] + shape.Bottom[26]) > shape.Arc[48] - shape.Arc[0]);
        }

        foreach (CreatureBlueprint blueprint in Drawn("swordfish", RequestedKind.Swimming))
        {
            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            Assert.True(shape.Arc[7] - shape.Arc[0] > shape.Arc[16] - shape.Arc[7]);
        }
    }

    [Fact]
    public void A_sheet_of_36_walkers_shows_many_bodies_and_none_too_often()
    {
        for (ulong sheet = 0; sheet < 6; sheet++)
        {
            var counts = Enumerable.Range(0, 36).Select(i => BlueprintSampler.Sample((1000 * sheet) + (ulong)i, LocomotionKind.Walking)).GroupBy(b => (b.Body.Blend.First, b.Plan)).Select(g => g.Count()).ToList();
            Assert.True(counts.Count >= 17, $"{counts.Count} kinds of walkers");
            Assert.True(counts.Max() <= 8, $"one kind {counts.Max()} times");
        }
    }

    private static BodySkin SkinOf(CreatureBlueprint b) => BodySkin.Span(BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail), b);

    internal static IEnumerable<CreatureBlueprint> Drawn(string body, RequestedKind kind) =>
        Enumerable.Range(0, 12).Select(seed => BlueprintSampler.Sample((ulong)seed, SpeciesSubject.Only(body, kind)));
}
