using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Anatomy;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>The welded surface of a whole creature and what grew out of it. Metres at scale 1.</summary>
internal sealed class GrownSurface
{
    private readonly int[] bodyVertices;
    private readonly LimbEnds ends;

    private GrownSurface(Surface surface, SurfaceAdjacency adjacency, BodySkin skin, IReadOnlyList<Appendage> appendages, LimbEnds ends, MouthSeam mouth, int[] bodyVertices)
    {
        Surface = surface;
        Adjacency = adjacency;
        Skin = skin;
        Appendages = appendages;
        this.ends = ends;
        Mouth = mouth;
        this.bodyVertices = bodyVertices;
    }

    public Surface Surface { get; }

    public SurfaceAdjacency Adjacency { get; }

    /// <summary>The body without its limbs.</summary>
    public BodySkin Skin { get; }

    /// <summary>Indexed by <see cref="VertexAddress.Appendage"/>.</summary>
    public IReadOnlyList<Appendage> Appendages { get; }

    /// <summary>Ends of toes, fingers and tips on the left; <see cref="DigitTip.Vertex"/> indexes <see cref="Surface"/>.</summary>
    public IReadOnlyList<DigitTip> Tips => ends.Tips;

    /// <summary>Webs between toes on the left; <see cref="ToeWeb.Vertex"/> indexes <see cref="Surface"/>.</summary>
    public IReadOnlyList<ToeWeb> Webs => ends.Webs;

    /// <summary>Its lips.</summary>
    public MouthSeam Mouth { get; }

    /// <summary>The vertex of the surface at a ring and segment of the body, or the next one forward of it that no socket has taken.</summary>
    public int BodyVertex(int ring, int segment)
    {
        while (bodyVertices[(ring * BodyGrid.Segments) + (segment & (BodyGrid.Segments - 1))] < 0)
        {
            ring--;
        }

        return bodyVertices[(ring * BodyGrid.Segments) + (segment & (BodyGrid.Segments - 1))];
    }

    /// <summary>Spans the body, grows all limbs, closes the body and relaxes the seams.</summary>
    public static GrownSurface Grow(CreatureBlueprint blueprint)
    {
        BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
        BodySkin skin = BodySkin.Span(shape, blueprint);
        using var builder = new SurfaceBuilder();
        var body = new BodySurface(builder, skin);
        var appendages = new List<Appendage>();
        var borders = new List<int>();
        var ends = new LimbEnds();
        foreach (LegBlueprint leg in blueprint.Legs)
        {
            Take(LegGrower.Grow(body, leg, appendages.Count, ends), leg.Socket);
        }

        foreach (WingBlueprint wing in blueprint.Wings)
        {
            Appendage grown = wing.Style == WingStyle.Folded ? FoldedWingGrower.Grow(body, wing, appendages.Count) : WingGrower.Grow(body, wing, appendages.Count, FreeBehind(blueprint, wing.Socket));
            Take(grown with { IsCarried = blueprint.Kind == LocomotionKind.Walking }, wing.Socket);
        }

        foreach (FinBlueprint fin in blueprint.Fins)
        {
            Take(fin.Place == FinPlace.Pectoral ? PectoralGrower.Grow(body, fin, appendages.Count) : MidlineFinGrower.Grow(body, fin, appendages.Count), fin.Socket);
        }

        foreach (EarBlueprint ear in blueprint.Ears)
        {
            Take(EarGrower.Grow(body, ear, appendages.Count), ear.Socket);
        }

        MouthSlit mouth = MouthSlit.CloseBody(body, blueprint.Head, blueprint.Tail.Style);
        Surface surface = Surface.From(builder, out int[] index);
        var adjacency = new SurfaceAdjacency(surface.Positions.Length, surface.Faces);
        for (int i = 0; i < borders.Count; i++)
        {
            borders[i] = index[borders[i]];
        }

        AddToeRoots(surface, adjacency, borders);
        SeamRelaxer.Relax(surface, adjacency, borders);
        if (blueprint.Plan == BodyPlan.Legless)
        {
            PressFlat(surface);
        }

        SurfaceUntangler.Untangle(surface);

        for (int i = 0; i < ends.Webs.Count; i++)
        {
            ends.Webs[i] = ends.Webs[i] with { Vertex = index[ends.Webs[i].Vertex] };
        }

        for (int i = 0; i < ends.Tips.Count; i++)
        {
            DigitTip t = ends.Tips[i];
            ends.Tips[i] = new DigitTip(t.Kind, t.Position, t.Direction, t.Radius, t.ClawLength, index[t.Vertex]);
        }

        int[] bodyVertices = new int[BodyGrid.Rings * BodyGrid.Segments];
        for (int v = 0; v < bodyVertices.Length; v++)
        {
            bodyVertices[v] = index[body[v / BodyGrid.Segments, v % BodyGrid.Segments]];
        }

        var seam = new MouthSeam(blueprint.Head.Mouth.CornerRing, Indices(mouth.UpperLip), Indices(mouth.LowerLip));
        return new GrownSurface(surface, adjacency, skin, appendages, ends, seam, bodyVertices);

        void Take(Appendage appendage, SocketBlueprint socket)
        {
            appendages.Add(appendage with { Pair = 1 + CountOf(appendages, appendage) });
            borders.AddRange(SocketLoop.BorderOf(body, socket));
        }

        int[] Indices(IReadOnlyList<int> vertices)
        {
            int[] result = new int[vertices.Count];
            for (int i = 0; i < result.Length; i++)
            {
                result[i] = index[vertices[i]];
            }

            return result;
        }
    }

    /// <summary>Toes grow out of the end of a leg as a leg does out of the body: their roots are seams too.</summary>
    private static void AddToeRoots(Surface surface, SurfaceAdjacency adjacency, List<int> borders)
    {
        for (int v = 0; v < surface.Positions.Length; v++)
        {
            if (surface.Addresses[v].Region != SurfaceRegion.Leg || surface.Addresses[v].Along < 1f || surface.Addresses[v].Sign < 0)
            {
                continue;
            }

            foreach (int n in adjacency.Of(v))
            {
                if (surface.Addresses[n].Region == SurfaceRegion.Toe)
                {
                    borders.Add(v);
                    break;
                }
            }
        }
    }

    /// <summary>The last ring of the flank behind a pair of wings before the next wings or thighs begin.</summary>
    private static int FreeBehind(CreatureBlueprint blueprint, SocketBlueprint wing)
    {
        int free = BodyGrid.Rings - 1;
        foreach (WingBlueprint other in blueprint.Wings)
        {
            free = other.Socket.Ring > wing.Ring ? Math.Min(free, other.Socket.Ring - 1) : free;
        }

        foreach (LegBlueprint leg in blueprint.Legs)
        {
            free = leg.Socket.Ring >= wing.Ring + wing.Rows ? Math.Min(free, leg.Socket.Ring) : free;
        }

        return free;
    }

    /// <summary>A belly that lies on the ground does not sink into it.</summary>
    private static void PressFlat(Surface surface)
    {
        for (int v = 0; v < surface.Positions.Length; v++)
        {
            Vector3 p = surface.Positions[v];
            surface.Positions[v] = new Vector3(p.X, System.Math.Max(p.Y, 0f), p.Z);
        }
    }

    private static int CountOf(List<Appendage> appendages, Appendage one)
    {
        int count = 0;
        foreach (Appendage a in appendages)
        {
            count += a.Kind == one.Kind ? 1 : 0;
        }

        return count;
    }
}
