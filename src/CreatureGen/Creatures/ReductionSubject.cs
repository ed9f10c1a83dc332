using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Creatures;

/// <summary>What a reduction works on: the half of a mesh that says all about it (<see cref="MirroredHalf"/>), as points and triangles with numbers of their own.</summary>
internal sealed class ReductionSubject
{
    private readonly CreatureMesh mesh;

    /// <summary>Takes the half of a mesh.</summary>
    public ReductionSubject(CreatureMesh mesh)
    {
        this.mesh = mesh;
        VertexWelding welding = VertexWelding.Weld(mesh.Positions);
        PlaceOf = welding.NewIndex.ToArray();
        Vector3[] places = welding.Positions.ToArray();
        int[] corners = welding.Apply(mesh.Triangles);
        int[] images = SagittalTwins.Find(welding);
        bool mirrored = Array.IndexOf(images, -1) < 0;
        var sides = new sbyte[places.Length];
        for (int p = 0; p < places.Length; p++)
        {
            // Without mirror images all is one side.
            images[p] = mirrored ? images[p] : p;
            sides[p] = mirrored ? (sbyte)Math.Sign(places[p].X) : (sbyte)1;
        }

        Pieces = new SurfacePieces(places, corners);
        Half = new MirroredHalf(PlaceOf, corners, mesh.Triangles, images, sides, Pieces.PieceOf);
        int[] pointAt = NumberPoints(corners, places.Length);
        Positions = new Vector3[Points];
        Twin = new int[Points];
        Side = new sbyte[Points];
        Rim = new bool[Points];
        PieceOf = new int[Points];
        for (int place = 0; place < places.Length; place++)
        {
            int p = pointAt[place];
            if (p >= 0)
            {
                bool halved = Half.IsHalved[Pieces.PieceOf[place]];
                Positions[p] = places[place];
                PieceOf[p] = Pieces.PieceOf[place];
                Side[p] = sides[place];
                Rim[p] = halved && sides[place] == 0;
                Twin[p] = halved ? p : pointAt[images[place]];
            }
        }

        Corners = new int[3 * Half.Triangles.Length];
        Vertices = new int[Corners.Length];
        for (int c = 0; c < Corners.Length; c++)
        {
            int at = (3 * Half.Triangles[c / 3]) + (c % 3);
            Corners[c] = pointAt[corners[at]];
            Vertices[c] = mesh.Triangles[at];
        }

        PointOf = Array.ConvertAll(PlaceOf, place => pointAt[place]);
        Box = PointBounds.Of(places);
    }

    /// <summary>Number of points.</summary>
    public int Points { get; private set; }

    /// <summary>Place of each point.</summary>
    public Vector3[] Positions { get; }

    /// <summary>The point of each corner, three for each triangle.</summary>
    public int[] Corners { get; }

    /// <summary>The drawn vertex of each corner.</summary>
    public int[] Vertices { get; }

    /// <summary>The point of each drawn vertex, −1 on the side that is an image.</summary>
    public int[] PointOf { get; }

    /// <summary>The place of each drawn vertex, by number; those of one place have the same.</summary>
    public int[] PlaceOf { get; }

    /// <summary>The mirror image of each point in pieces of which both sides are there; a point on the plane, and those of all other pieces, are their own.</summary>
    public int[] Twin { get; }

    /// <summary>The side that each point is on: 1 left, −1 right, 0 on the plane.</summary>
    public sbyte[] Side { get; }

    /// <summary>The points at which a halved piece ends at the plane.</summary>
    public bool[] Rim { get; }

    /// <summary>The piece of each point, as <see cref="Pieces"/> numbers them.</summary>
    public int[] PieceOf { get; }

    /// <summary>The pieces of the whole.</summary>
    public SurfacePieces Pieces { get; }

    /// <summary>Which triangles these are, and what their images are.</summary>
    public MirroredHalf Half { get; }

    /// <summary>The box around the whole.</summary>
    public PointBounds Box { get; }

    /// <summary>Unit normal of each point: the mean of those of its vertices.</summary>
    public Vector3[] Normals()
    {
        var normals = new Vector3[Points];
        for (int v = 0; v < PointOf.Length; v++)
        {
            if (PointOf[v] >= 0)
            {
                normals[PointOf[v]] += mesh.Normals[v];
            }
        }

        for (int p = 0; p < normals.Length; p++)
        {
            normals[p] = Vec.Normalize(normals[p], Vector3.UnitY);
        }

        return normals;
    }

    /// <summary>Numbers the places that corners of the half are at; −1 for others.</summary>
    private int[] NumberPoints(int[] corners, int places)
    {
        int[] pointAt = new int[places];
        foreach (int t in Half.Triangles)
        {
            pointAt[corners[3 * t]] = pointAt[corners[(3 * t) + 1]] = pointAt[corners[(3 * t) + 2]] = 1;
        }

        for (int place = 0; place < places; place++)
        {
            pointAt[place] = pointAt[place] == 1 ? Points++ : -1;
        }

        return pointAt;
    }
}
