using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Limbs;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class SocketRulesTests
{
    private static readonly CreatureBlueprint Bare = CreatureFields.Creature.Neutral;

    [Theory]
    [InlineData(1, 0, 2, 2)]
    [InlineData(1, 14, 2, 2)]
    [InlineData(51, 0, 2, 16)]
    [InlineData(31, 0, 22, 16)]
    public void A_socket_may_fill_the_left_side_up_to_its_borders(int ring, int segment, int rows, int columns)
    {
        Assert.Empty(Sentences(WithLegs(new SocketBlueprint(ring, segment, rows, columns))));
    }

    [Theory]
    [InlineData(52, 0, 2, 2, "legs[0].socket = rings 52..54, segments 0..2; expected rings within 1..53")]
    [InlineData(40, 4, 22, 2, "legs[0].socket = rings 40..62, segments 4..6; expected rings within 1..53")]
    [InlineData(20, 15, 2, 2, "legs[0].socket = rings 20..22, segments 15..17; expected segments within 0..16, the left side")]
    [InlineData(20, 31, 2, 2, "legs[0].socket = rings 20..22, segments 31..33; expected segments within 0..16, the left side")]
    [InlineData(20, 20, 2, 2, "legs[0].socket = rings 20..22, segments 20..22; expected segments within 0..16, the left side")]
    public void A_socket_that_leaves_the_left_side_is_reported(int ring, int segment, int rows, int columns, string problem)
    {
        Assert.Equal(problem, Assert.Single(Sentences(WithLegs(new SocketBlueprint(ring, segment, rows, columns)))));
    }

    [Theory]
    [InlineData(FinPlace.Dorsal, 31, 2, null)]
    [InlineData(FinPlace.Ventral, 15, 2, null)]
    [InlineData(FinPlace.Pectoral, 9, 4, null)]
    [InlineData(FinPlace.Dorsal, 15, 2, "segment 31 and 2 columns for a dorsal fin")]
    [InlineData(FinPlace.Dorsal, 31, 4, "segment 31 and 2 columns for a dorsal fin")]
    [InlineData(FinPlace.Dorsal, 0, 2, "segment 31 and 2 columns for a dorsal fin")]
    [InlineData(FinPlace.Ventral, 31, 2, "segment 15 and 2 columns for a ventral fin")]
    [InlineData(FinPlace.Ventral, 14, 2, "segment 15 and 2 columns for a ventral fin")]
    [InlineData(FinPlace.Pectoral, 31, 2, "segments within 0..16, the left side")]
    [InlineData(FinPlace.Pectoral, 15, 2, "segments within 0..16, the left side")]
    public void Midline_sockets_are_for_midline_fins(FinPlace place, int segment, int columns, string? expectation)
    {
        FinBlueprint fin = LimbFields.Fin.Neutral with { Place = place, Width = 0.5, Socket = new SocketBlueprint(30, segment, 4, columns) };
        IReadOnlyList<Problem> problems = BlueprintValidator.Validate(Bare with { Fins = new ValueList<FinBlueprint>(new[] { fin }) });
        Assert.Equal(expectation, problems.SingleOrDefault()?.Expectation);
    }

    [Fact]
    public void Sockets_that_share_cells_are_reported_pair_by_pair()
    {
        CreatureBlueprint crowded = WithLegs(new SocketBlueprint(20, 6, 4, 4), new SocketBlueprint(22, 8, 4, 4), new SocketBlueprint(23, 9, 2, 2));
        Assert.Equal(
            new[]
            {
                "legs[1].socket = rings 22..26, segments 8..12; expected no cell that legs[0].socket takes (rings 20..24, segments 6..10)",
                "legs[2].socket = rings 23..25, segments 9..11; expected no cell that legs[0].socket takes (rings 20..24, segments 6..10)",
                "legs[2].socket = rings 23..25, segments 9..11; expected no cell that legs[1].socket takes (rings 22..26, segments 8..12)",
            },
            Sentences(crowded));
    }

    [Fact]
    public void Sockets_of_all_kinds_are_compared()
    {
        var socket = new SocketBlueprint(26, 4, 4, 4);
        CreatureBlueprint crowded = WithLegs(socket) with
        {
            Wings = new ValueList<WingBlueprint>(new[] { LimbFields.Wing.Neutral with { Socket = socket } }),
            Fins = new ValueList<FinBlueprint>(new[] { LimbFields.Fin.Neutral with { Place = FinPlace.Pectoral, Width = 0.5, Socket = socket } }),
            Ears = new ValueList<EarBlueprint>(new[] { LimbFields.Ear.Neutral with { Socket = socket } }),
        };
        Assert.Equal(
            new[] { "wings[0].socket", "fins[0].socket", "fins[0].socket", "ears[0].socket", "ears[0].socket", "ears[0].socket" },
            BlueprintValidator.Validate(crowded).Select(problem => problem.Path));
    }

    [Fact]
    public void Sockets_that_touch_do_not_overlap()
    {
        Assert.Empty(Sentences(WithLegs(new SocketBlueprint(20, 6, 4, 4), new SocketBlueprint(24, 6, 4, 4), new SocketBlueprint(20, 10, 4, 4), new SocketBlueprint(24, 10, 2, 2))));
    }

    [Fact]
    public void A_midline_socket_overlaps_a_side_one_that_reaches_the_midline()
    {
        CreatureBlueprint With(int segment) => WithLegs(new SocketBlueprint(26, segment, 2, 2)) with { Fins = new ValueList<FinBlueprint>(new[] { LimbFields.Fin.Neutral }) };
        Assert.Equal("fins[0].socket", Assert.Single(BlueprintValidator.Validate(With(0))).Path);
        Assert.Empty(Sentences(With(1)));
    }

    [Fact]
    public void Overlap_is_what_counting_cells_says()
    {
        RandomStream random = new Seed(8).Stream();
        int overlaps = 0;
        for (int i = 0; i < 2000; i++)
        {
            SocketBlueprint[] sockets = { Draw(), Draw() };
            bool expected = Cells(sockets[0]).Intersect(Cells(sockets[1])).Any();
            Assert.Equal(expected, Sentences(WithLegs(sockets)).Any(problem => problem.Contains("no cell", StringComparison.Ordinal)));
            overlaps += expected ? 1 : 0;
        }

        Assert.InRange(overlaps, 200, 1800);

        SocketBlueprint Draw() => new(random.Integer(1, 52), random.Integer(0, 32), 2 * random.Integer(1, 12), 2 * random.Integer(1, 9));

        static IEnumerable<(int, int)> Cells(SocketBlueprint socket) =>
            from row in Enumerable.Range(socket.Ring, socket.Rows)
            from column in Enumerable.Range(socket.Segment, socket.Columns)
            from cell in new[] { column % 32, 31 - (column % 32) }
            select (row, cell);
    }

    [Theory]
    [InlineData(4, 8, false)]
    [InlineData(4, 10, true)]
    [InlineData(6, 9, true)]
    [InlineData(4, 6, false)]
    [InlineData(4, 11, false)]
    [InlineData(7, 9, false)]
    public void A_socket_keeps_clear_of_the_lips(int ring, int segment, bool tears)
    {
        CreatureBlueprint mouthless = WithLegs(new SocketBlueprint(ring, segment, 2, 2));
        CreatureBlueprint mouthed = mouthless with { Head = Bare.Head with { Mouth = new MouthBlueprint(7, 0.1, 0, 0) } };
        Assert.Empty(Sentences(mouthless));
        Assert.Equal(tears ? "rings from 7 on, or segments up to 10 or from 11 on, clear of the mouth" : null, BlueprintValidator.Validate(mouthed).SingleOrDefault()?.Expectation);

        // The rule is there because of this, and forbids no more than it must.
        Assert.Equal(tears, IsTorn(mouthed));
    }

    [Theory]
    [InlineData(12)]
    [InlineData(150, Explicit = true)]
    public void Wherever_valid_sockets_lie_the_surface_stays_closed(int each)
    {
        RandomStream random = new Seed(9).Stream();
        int grown = 0;
        foreach (CreatureBlueprint drawn in Samples.Drawn(2))
        {
            for (int i = 0; i < each; i++)
            {
                CreatureBlueprint blueprint = WithOneMore(drawn, random);
                if (BlueprintValidator.Validate(blueprint).Count == 0)
                {
                    Assert.False(IsTorn(blueprint), blueprint.ToString());
                    grown++;
                }
            }
        }

        Assert.InRange(grown, each, 16 * each / 3);
    }

    private static CreatureBlueprint WithOneMore(CreatureBlueprint drawn, RandomStream random)
    {
        var socket = new SocketBlueprint(random.Integer(1, 53), random.Integer(0, 15), 2 * random.Integer(1, 6), 2 * random.Integer(1, 5));
        switch (random.Integer(0, 6))
        {
            case 0:
            case 1:
                LegBlueprint leg = LimbFields.Leg.Neutral with { Socket = socket, Archetype = (LimbArchetype)random.Integer(0, 11), Stance = (LegStance)random.Integer(0, 2), Toes = random.Integer(1, 9) };
                return drawn with { Legs = new ValueList<LegBlueprint>(drawn.Legs.Append(leg)) };
            case 2:
                WingBlueprint wing = LimbFields.Wing.Neutral with { Socket = socket, Style = (WingStyle)random.Integer(0, 2) };
                return drawn with { Wings = new ValueList<WingBlueprint>(drawn.Wings.Append(wing)) };
            case 3:
                return drawn with { Ears = new ValueList<EarBlueprint>(drawn.Ears.Append(LimbFields.Ear.Neutral with { Socket = socket })) };
            case 4:
                FinBlueprint paired = LimbFields.Fin.Neutral with { Place = FinPlace.Pectoral, Width = 0.4, Socket = socket };
                return drawn with { Fins = new ValueList<FinBlueprint>(drawn.Fins.Append(paired)) };
            default:
                bool dorsal = random.Chance(0.5);
                FinBlueprint single = LimbFields.Fin.Neutral with { Place = dorsal ? FinPlace.Dorsal : FinPlace.Ventral, Style = (FinStyle)random.Integer(0, 4), Socket = socket with { Segment = dorsal ? 31 : 15, Columns = 2 } };
                return drawn with { Fins = new ValueList<FinBlueprint>(drawn.Fins.Append(single)) };
        }
    }

    /// <summary>Whether an edge of the grown surface is not run through exactly once in each direction.</summary>
    private static bool IsTorn(CreatureBlueprint blueprint)
    {
        int[] triangles = GrownSurface.Grow(blueprint).Surface.Triangles.ToArray();
        var edges = new Dictionary<(int, int), int>();
        for (int i = 0; i < triangles.Length; i += 3)
        {
            (int a, int b, int c) = (triangles[i], triangles[i + 1], triangles[i + 2]);
            foreach ((int, int) edge in new[] { (a, b), (b, c), (c, a) })
            {
                edges[edge] = edges.GetValueOrDefault(edge) + 1;
            }
        }

        return edges.Any(edge => edge.Value != 1 || !edges.ContainsKey((edge.Key.Item2, edge.Key.Item1)));
    }

    private static CreatureBlueprint WithLegs(params SocketBlueprint[] sockets) =>
        Bare with { Legs = new ValueList<LegBlueprint>(sockets.Select(socket => LimbFields.Leg.Neutral with { Socket = socket })) };

    private static string[] Sentences(CreatureBlueprint blueprint) => BlueprintValidator.Validate(blueprint).Select(problem => problem.ToString()).ToArray();
}
