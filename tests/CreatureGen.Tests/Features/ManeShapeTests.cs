using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Sampling;
using CreatureGen.Species;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class ManeShapeTests
{
    [Theory]
    [InlineData("lion")]
    [InlineData("horse")]
    [InlineData("boar", Explicit = true)]
    [InlineData("bison", Explicit = true)]
    [InlineData("camel", Explicit = true)]
    [InlineData("hyena", Explicit = true)]
    public void Hair_is_closed_symmetric_and_seated_in_the_skin(string body)
    {
        for (ulong seed = 0; seed < 6; seed++)
        {
            CreatureBlueprint blueprint = Draw(body, seed);
            Assert.NotEmpty(blueprint.Manes);
            BodySkin skin = SkinOf(blueprint);
            foreach (ManeBlueprint mane in blueprint.Manes)
            {
                Piece hair = Build(mane, skin, out List<SkinAddress> addresses, (int)seed % 3);
                PieceChecks.IsSound(hair);
                PieceChecks.IsSymmetric(hair);
                Assert.Equal(hair.Positions.Length, addresses.Count);
                for (int v = 0; v < addresses.Count; v++)
                {
                    // No farther from the place it moves with than a lock is long: nothing floats.
                    float away = Vector3.Distance(hair.Positions[v], skin[addresses[v].Ring, addresses[v].Segment]);
                    double farthest = (1.25 * mane.Length * Math.Max(1, mane.Growth)) + mane.Width + Cell(skin, addresses[v]);
                    Assert.True(away < farthest, $"{body} {seed}: {away} of {farthest} at ring {addresses[v].Ring}");
                }
            }
        }
    }

    [Fact]
    public void Hair_is_no_coarser_than_its_room_asks_for()
    {
        CreatureBlueprint blueprint = Draw("lion", 1);
        BodySkin skin = SkinOf(blueprint);
        int[] triangles = Enumerable.Range(0, 3).Select(TrianglesAt).ToArray();
        Assert.True(triangles[0] > triangles[1] && triangles[1] > triangles[2]);
        Assert.Equal(0, ManeShape.CoarsenessWithin(triangles[0], blueprint.Manes));
        Assert.Equal(1, ManeShape.CoarsenessWithin(triangles[0] - 1, blueprint.Manes));
        Assert.Equal(1, ManeShape.CoarsenessWithin(triangles[1], blueprint.Manes));
        Assert.Equal(2, ManeShape.CoarsenessWithin(triangles[1] - 1, blueprint.Manes));
        Assert.Equal(2, ManeShape.CoarsenessWithin(-1, blueprint.Manes));
        Assert.Equal(0, ManeShape.CoarsenessWithin(0, []));

        int TrianglesAt(int coarseness) => blueprint.Manes.Sum(mane => Build(mane, skin, out _, coarseness).Triangles.Length / 3);
    }

    /// <summary>To cut twenty triangles out of a finished creature took several times as long as to grow it.</summary>
    [Theory]
    [InlineData("lion", 1)]
    [InlineData("bison", 2)]
    [InlineData("horse", 3)]
    public void A_maned_creature_a_triangle_over_its_budget_has_coarser_hair_and_is_whole_otherwise(string body, ulong seed)
    {
        CreatureBlueprint blueprint = Draw(body, seed);
        CreatureMesh whole = CreatureGenerator.Build(blueprint with { TriangleBudget = 100000 }).Mesh;
        CreatureMesh tight = CreatureGenerator.Build(blueprint with { TriangleBudget = (whole.Triangles.Length / 3) - 1 }).Mesh;
        var left = new HashSet<Vector3>(tight.Positions.ToArray());
        int gone = whole.Positions.ToArray().Count(p => !left.Contains(p));
        int hair = blueprint.Manes.Sum(mane => Build(mane, SkinOf(blueprint), out _).Positions.Length);
        Assert.True(hair > 500);
        Assert.InRange(gone, hair / 5, hair);
    }

    [Fact]
    public void A_lock_begins_below_the_skin_and_ends_above_it()
    {
        BodySkin skin = SkinOf(Draw("horse", 1));
        var mane = new ManeBlueprint(20, 20, 4, 4, 1, 1, 0.1, 1, 0.02, 0.5, 0.6, 0);
        Piece hair = Build(mane, skin, out _);
        Assert.Equal(2 * 17, hair.Positions.Length);
        SurfacePoint root = skin.At(20, 4);
        Vector3 middle = (hair.Positions[0] + hair.Positions[1] + hair.Positions[2] + hair.Positions[3]) / 4;
        Assert.InRange(Vector3.Dot(middle - root.Position, root.Normal), -0.02f, 0f);
        Assert.True(Vector3.Dot(hair.Positions[16] - root.Position, root.Normal) > 0.005f);
    }

    [Fact]
    public void A_lock_tapers_from_its_first_third_to_a_point_and_its_edges_are_darker_than_its_middle()
    {
        BodySkin skin = SkinOf(Draw("horse", 1));
        Piece hair = Build(new ManeBlueprint(20, 20, 4, 4, 1, 1, 0.1, 1, 0.012, 0.3, 0.6, 0), skin, out _);
        float[] widths = Enumerable.Range(0, 4).Select(i => Vector3.Distance(hair.Positions[4 * i], hair.Positions[(4 * i) + 2])).ToArray();
        Assert.True(widths[1] > widths[2] && widths[2] > 1.5f * widths[3], string.Join(" ", widths));
        for (int i = 0; i < 4; i++)
        {
            Assert.True(hair.Colours[4 * i].X < 0.8f * hair.Colours[(4 * i) + 1].X);
        }
    }

    [Fact]
    public void Locks_of_all_kits_are_at_least_four_times_as_long_as_wide()
    {
        foreach (ManePreset kit in new[] { NeckPresets.Ruff, NeckPresets.Falling, NeckPresets.Bristles, NeckPresets.Shag, NeckPresets.Beard, TailHair.Tuft, TailHair.Skirt, TailHair.Brush, TailHair.Scut })
        {
            Assert.All(kit.Fields, mane => Assert.True(mane.Length >= 4 * 2 * mane.Width, $"{mane}"));
        }
    }

    /// <summary>Round the underside of a whale a horse's mane was an open frame around its face.</summary>
    [Theory]
    [InlineData(24816000, RequestedKind.Swimming)]
    [InlineData(24834010, RequestedKind.Swimming)]
    public void Hair_that_does_not_hang_ends_where_the_body_turns_under(ulong seed, RequestedKind kind)
    {
        CreatureBlueprint drawn = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
        BodySkin skin = SkinOf(drawn);
        ManeBlueprint falling = NeckPresets.Falling.Fields[0];
        double unit = 0.5 * (skin.Shape.Top[StationRing.NeckMiddle] + skin.Shape.Bottom[StationRing.NeckMiddle]);
        Build(falling with { Length = 1.2 * unit * falling.Length, Width = unit * falling.Width }, skin, out List<SkinAddress> addresses);
        Assert.All(addresses, address => Assert.True(skin.At(address.Ring, address.Segment).Normal.Y > -0.35f, $"hair at ring {address.Ring}, segment {address.Segment}"));
        Assert.Contains(addresses, address => address.Segment >= 6);
    }

    [Fact]
    public void Hair_hangs_less_in_the_water_than_on_land()
    {
        double[] hangs = new[] { RequestedKind.Walking, RequestedKind.Swimming }.Select(kind => BlueprintSampler.Sample(24832011, CreatureOptions.Default with { Kind = kind }).Manes.Where(mane => mane.IsOfBody).Max(mane => mane.Hang)).ToArray();
        Assert.True(hangs[1] > 0 && hangs[1] < 0.5 * hangs[0], $"{hangs[1]} of {hangs[0]}");
    }

    /// <summary>Steepest that hair in the water falls off the way to the tail, radians: what falls down the flanks is a row of strips there, what falls forward hides the face.</summary>
    private const double Trailing = 0.5;

    [Theory]
    [InlineData(24835009)]
    [InlineData(24835010)]
    [InlineData(24840019)]
    public void Hair_trails_behind_what_swims(ulong seed)
    {
        ManeBlueprint[] manes = BlueprintSampler.Sample(seed, LocomotionKind.Swimming).Manes.ToArray();
        Assert.NotEmpty(manes);
        Assert.All(manes, mane => Assert.True(mane.Fall <= Trailing || mane.LastRing < StationRing.NeckMiddle, $"{mane}"));
        Assert.All(manes, mane => Assert.True(mane.Fall < Math.PI / 2, $"{mane}"));
    }

    [Fact]
    public void Hair_on_the_midline_is_single_and_all_other_hair_comes_in_pairs()
    {
        BodySkin skin = SkinOf(Draw("horse", 2));
        var mane = new ManeBlueprint(18, 22, 0, 16, 1, 3, 0.1, 1, 0.02, 0.5, 0, 0);
        Assert.Equal(4 * 17, Build(mane, skin, out _).Positions.Length);
        Assert.Equal(17, Build(mane with { LastSegment = 0, Columns = 1 }, skin, out _).Positions.Length);
        Assert.Equal(2 * 17, Build(mane with { Segment = 3, LastSegment = 3, Columns = 1 }, skin, out _).Positions.Length);
    }

    [Fact]
    public void Hair_of_a_neck_bends_with_the_neck()
    {
        Creature creature = SpeciesSubject.Of("horse", RequestedKind.Walking, 3);
        int neck = creature.Skeleton.IndexOf("Neck_01");
        Assert.True(neck >= 0);
        var joints = new HashSet<int>();
        Vector2 hair = ChartPacking.Swatch((int)SurfaceFinish.Hair);
        for (int v = 0; v < creature.Mesh.Positions.Length; v++)
        {
            if (creature.Mesh.Texcoords[v] == hair)
            {
                joints.Add(creature.Mesh.Weights[v].Joint0);
            }
        }

        Assert.Contains(neck, joints);
        Assert.Contains(creature.Skeleton.IndexOf("Head"), joints);
    }

    [Fact]
    public void Fields_of_hair_that_end_before_they_begin_are_problems()
    {
        CreatureBlueprint blueprint = Draw("lion", 0);
        ManeBlueprint wrong = blueprint.Manes[0] with { Ring = 20, LastRing = 18, Segment = 9, LastSegment = 8 };
        IReadOnlyList<Problem> problems = BlueprintValidator.Validate(blueprint with { Manes = new ValueList<ManeBlueprint>(new[] { wrong }) });
        Assert.Equal(new[] { "manes[0].lastRing", "manes[0].lastSegment" }, problems.Select(problem => problem.Path));
    }

    [Theory]
    [InlineData("lizard")]
    [InlineData("ceratops")]
    public void A_collar_is_closed_symmetric_thin_and_rooted_in_the_head(string body)
    {
        for (ulong seed = 0; seed < 10; seed++)
        {
            CreatureBlueprint blueprint = Draw(body, seed);
            FrillBlueprint frill = Assert.Single(blueprint.Frills);
            BodySkin skin = SkinOf(blueprint);
            var builder = new PieceBuilder();
            FrillShape.Append(builder, frill, skin, Vector3.One * 0.5f, Vector3.One * 0.3f, Vector3.One * 0.1f);
            Piece collar = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
            PieceChecks.IsSound(collar);
            PieceChecks.IsSymmetric(collar);
            Vector3 centre = skin.Shape.Centre((int)frill.Ring);
            float nearest = collar.Positions.Min(p => Vector3.Distance(p, centre));
            float farthest = collar.Positions.Max(p => Vector3.Distance(p, centre));
            Assert.True(nearest < 1.02 * Math.Max(skin.Shape.Width[(int)frill.Ring], skin.Shape.Top[(int)frill.Ring]), $"{body} {seed} floats");
            Assert.True(farthest > nearest + (0.6 * frill.Length), $"{body} {seed} does not stand off the head");
        }
    }

    private static float Cell(BodySkin skin, SkinAddress at) =>
        Vector3.Distance(skin[at.Ring, at.Segment], skin[Math.Min(at.Ring + 1, BodyGrid.Rings - 1), (at.Segment + 1) % BodyGrid.Segments]);

    private static Piece Build(ManeBlueprint mane, BodySkin skin, out List<SkinAddress> addresses, int coarseness = 0)
    {
        addresses = new List<SkinAddress>();
        var builder = new PieceBuilder();
        ManeShape.Append(builder, mane, coarseness, skin, Vector3.One * 0.5f, addresses);
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    private static BodySkin SkinOf(CreatureBlueprint blueprint)
    {
        BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
        return BodySkin.Span(shape, blueprint);
    }

    private static CreatureBlueprint Draw(string body, ulong seed) => BlueprintSampler.Sample(seed, SpeciesSubject.Only(body, RequestedKind.Walking));
}
