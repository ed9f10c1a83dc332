using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using CreatureGen.Species;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class ToothTests
{
    private static readonly Vector3 ivory = new(0.8f, 0.75f, 0.6f);

    public static TheoryData<string> Families => new(families.Keys);

    private static readonly Dictionary<string, Dentition> families = new()
    {
        ["carnivore"] = CarnivoreTeeth.Teeth,
        ["grazer"] = GrazerTeeth.Teeth,
        ["gnawer"] = GnawerTeeth.Teeth,
        ["peg"] = PegTeeth.Teeth,
        ["crocodile"] = CrocodileTeeth.Teeth,
        ["saw"] = SawTeeth.Teeth,
        ["needle"] = NeedleTeeth.Teeth,
        ["fang"] = FangTeeth.Teeth,
    };

    [Theory]
    [MemberData(nameof(Families))]
    public void Teeth_of_every_family_are_closed_grow_from_the_gum_and_are_mirrored_exactly(string family)
    {
        foreach (ToothSet[] sets in new[] { families[family].Upper, families[family].Lower })
        {
            float longest = sets.Max(set => Math.Max(set.Height.First, set.Height.Last));
            var builder = new PieceBuilder();
            ToothRow.Append(builder, Lip(-Vector3.UnitY), sets, 0.03f, 0.004f, ivory);
            builder.AppendMirrored(0, 0);
            Piece row = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
            PieceChecks.IsSound(row);
            PieceChecks.IsSymmetric(row);
            Assert.InRange(1f - row.Positions.Min(p => p.Y), 0.03f * 0.7f * longest, 0.0301f);
            Assert.True(row.Positions.Max(p => p.Y) > 1f, "roots are hidden in the gum");
            Assert.InRange(PieceChecks.TriangleCount(row), 60, 420);
        }
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void Teeth_of_a_row_do_not_stand_in_each_other(string family)
    {
        foreach (ToothSet[] sets in new[] { families[family].Upper, families[family].Lower })
        {
            float end = 0f;
            foreach (ToothSet set in sets)
            {
                Assert.True(set.Stretch.From >= end && set.Stretch.To > set.Stretch.From && set.Stretch.To <= 1f && set.Fill <= 1f);
                end = set.Stretch.To;
            }
        }
    }

    [Fact]
    public void A_gum_of_either_jaw_is_closed_and_reaches_the_middle_of_the_mouth()
    {
        foreach (Vector3 direction in new[] { Vector3.UnitY, -Vector3.UnitY })
        {
            var builder = new PieceBuilder();
            GumShape.Append(builder, Lip(direction), 0.01f, 0.012f, ivory);
            Piece left = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
            PieceChecks.IsSound(left);
            Assert.InRange(left.Positions.Min(p => p.X), 0f, 0.0005f);
            Assert.InRange(left.Positions.Max(p => Vector3.Dot(p - Vector3.UnitY, direction)), 0.004f, 0.01f);
        }
    }

    [Theory]
    [InlineData("feline", 1)]
    [InlineData("bovine", 1)]
    [InlineData("rabbit", 1)]
    [InlineData("serpent", 0.9)]
    [InlineData("shark", 1)]
    [InlineData("reptile", 0.8)]
    public void Who_shuts_its_mouth_hides_its_teeth_and_who_opens_it_shows_them(string body, double chance)
    {
        int toothed = 0;
        CreatureBlueprint[] drawn = SpeciesTests.Drawn(body, body == "shark" ? RequestedKind.Swimming : RequestedKind.Walking).ToArray();
        foreach (CreatureBlueprint creature in drawn.Where(creature => creature.Head.Mouth.Teeth > 0 && creature.Head.Beak == null))
        {
            toothed++;
            Assert.True(Seen(creature, 0) <= 0.05, $"{creature.Body.Blend.Face}: {Seen(creature, 0)} of the teeth show in a shut mouth");
            Assert.True(Seen(creature, 0.4) > 0.2, $"{creature.Body.Blend.Face}: {Seen(creature, 0.4)} of the teeth show in an open mouth");
        }

        Assert.True(toothed >= 0.5 * chance * drawn.Length, $"{toothed} of {drawn.Length} have teeth");
    }

    [Fact]
    public void Teeth_of_crocodiles_are_seen_in_a_shut_mouth()
    {
        foreach (CreatureBlueprint crocodile in SpeciesTests.Drawn("crocodile", RequestedKind.Walking).Take(6))
        {
            Assert.True(Seen(crocodile, 0) > 0.2);
        }
    }

    [Fact]
    public void No_tooth_of_a_mixed_creature_that_shuts_its_mouth_is_longer_than_the_jaw_is_deep_by_half()
    {
        int bared = 0;
        for (ulong seed = 15030001; seed <= 15030400 && bared < 12; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 });
            if (creature.Head.Mouth.Teeth == 0 || creature.Head.Beak != null || !SpeciesCatalogue.Find(creature.Body.Blend.Face).Dentition.Bared)
            {
                continue;
            }

            creature = creature with { Head = creature.Head with { Mouth = creature.Head.Mouth with { Opening = 0 } } };
            GrownSurface grown = GrownSurface.Grow(creature);
            var normals = new Vector3[grown.Surface.Positions.Length];
            SurfaceNormals.Smooth(grown.Surface.Positions, grown.Surface.Triangles, grown.Surface.Mirror, normals);
            var builder = new PieceBuilder();
            new ToothSetter(creature, grown, normals, SpeciesCatalogue.Find(creature.Body.Blend.Face).Dentition).AppendTeeth(builder, Jaw.Upper, ivory);
            Vector3 up = grown.Skin.Shape.Up(StationRing.MuzzleFront);
            float lip = Vector3.Dot(grown.Surface.Positions[grown.Mouth.UpperLip[grown.Mouth.UpperLip.Length / 2]], up);
            float lowest = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere).Positions.Where(p => p.Z > grown.Surface.Positions[grown.Mouth.UpperLip[0]].Z).Min(p => Vector3.Dot(p, up));
            Assert.True(lip - lowest < 0.55 * grown.Skin.Shape.Bottom[StationRing.MuzzleFront] + 0.5 * Sag(grown, up, lip), FormattableString.Invariant($"{seed}: teeth of {(lip - lowest) / grown.Skin.Shape.Bottom[StationRing.MuzzleFront]:0.00} jaws"));
            bared++;
        }

        Assert.InRange(bared, 6, 12);

        // A lip that bends down towards its corner carries its teeth lower.
        static double Sag(GrownSurface grown, Vector3 up, float lip) => 2 * Math.Max(0, lip - grown.Mouth.UpperLip.Min(vertex => Vector3.Dot(grown.Surface.Positions[vertex], up)));
    }

    /// <summary>Share of the corners of teeth that nothing of the skin is before, as seen from beside or from ahead.</summary>
    private static double Seen(CreatureBlueprint creature, double opening)
    {
        creature = creature with { Head = creature.Head with { Mouth = creature.Head.Mouth with { Opening = opening } } };
        GrownSurface grown = GrownSurface.Grow(creature);
        Surface surface = grown.Surface;
        var normals = new Vector3[surface.Positions.Length];
        SurfaceNormals.Smooth(surface.Positions, surface.Triangles, surface.Mirror, normals);
        var setter = new ToothSetter(creature, grown, normals, SpeciesCatalogue.Find(creature.Body.Blend.Face).Dentition);
        var builder = new PieceBuilder();
        setter.AppendTeeth(builder, Jaw.Upper, ivory);
        setter.AppendTeeth(builder, Jaw.Lower, ivory);
        Piece teeth = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        Vector3 ahead = grown.Skin.Shape.Forward(StationRing.Nose);
        int[] head = Enumerable.Range(0, surface.Triangles.Length / 3).Where(t => surface.Addresses[surface.Triangles[3 * t]].Ring < 12 && surface.Addresses[surface.Triangles[3 * t]].Appendage < 0).ToArray();
        Vector3[] tips = teeth.Positions.Where(p => p.X > 0f).ToArray();
        Vector3 aslant = 0.35f * grown.Skin.Shape.Up(StationRing.Nose);
        return tips.Count(tip => IsSeen(tip, Vector3.UnitX) || IsSeen(tip, ahead)) / (double)tips.Length;

        // Lips that are shut are a hair apart: what is seen is seen from a little above and below too.
        bool IsSeen(Vector3 tip, Vector3 direction) => IsFree(tip, direction + aslant) && IsFree(tip, direction - aslant);

        bool IsFree(Vector3 from, Vector3 direction) => !head.Any(t => RayCast.Hit(
            from,
            direction,
            surface.Positions[surface.Triangles[3 * t]],
            surface.Positions[surface.Triangles[(3 * t) + 1]],
            surface.Positions[surface.Triangles[(3 * t) + 2]],
            out _,
            out _,
            out _));
    }

    private static LipLine Lip(Vector3 direction) => new(
        Enumerable.Range(0, 12).Select(i => 1.5f * i / 11).Select(a => new SurfacePoint(
            new Vector3(0.1f * MathF.Sin(a), 1f, 0.3f * MathF.Cos(a)),
            Vector3.Normalize(new Vector3(3f * MathF.Sin(a), 0f, MathF.Cos(a))))).ToArray(),
        direction);
}
