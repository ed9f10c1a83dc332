using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The body's part of the surface: its grid of vertices, the cells that sockets have cut out of it, and its faces.</summary>
internal sealed class BodySurface
{
    private const float HeadEnd = 16;
    private const float TorsoEnd = 44;

    // Faces follow one another in strips of so many columns along the body: two rows of a strip's vertices fit into the smallest caches of graphics cards, and what is near in space is near in the list.
    private const int StripWidth = 6;

    private readonly int[] ids = new int[BodyGrid.Rings * BodyGrid.Segments];
    private readonly bool[] cut = new bool[(BodyGrid.Rings - 1) * BodyGrid.Segments];
    private readonly int headChart;
    private readonly int torsoChart;
    private readonly int tailChart;
    private readonly float halfGirth;

    /// <summary>Adds the vertices of the grid to the surface.</summary>
    public BodySurface(SurfaceBuilder surface, BodySkin skin)
    {
        Surface = surface;
        Skin = skin;
        headChart = surface.NewChart();
        torsoChart = surface.NewChart();
        tailChart = surface.NewChart();
        BodyShape shape = skin.Shape;
        float total = (float)shape.Arc[BodyGrid.Rings - 1];
        float widest = 0f;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            float along = (float)shape.Arc[i] / total;
            widest = System.Math.Max(widest, (float)(shape.Width[i] + ((shape.Top[i] + shape.Bottom[i]) / 2)));
            for (int j = 0; j < BodyGrid.Segments; j++)
            {
                ids[(i * BodyGrid.Segments) + j] = surface.Add(skin[i, j], new VertexAddress
                {
                    Region = SurfaceRegion.Body,
                    Appendage = -1,
                    Sign = (sbyte)(j > BodyGrid.Segments / 2 ? -1 : 1),
                    Along = along,
                    Around = (float)(PortableMath.Tau * System.Math.Min(j, BodyGrid.Segments - j) / BodyGrid.Segments),
                    Ring = i,
                    Segment = j,
                });
            }

            for (int j = 1; j < BodyGrid.Segments / 2; j++)
            {
                surface.Pair(this[i, j], this[i, BodyGrid.MirrorSegment(j)]);
            }
        }

        halfGirth = widest * (float)PortableMath.Pi / 2f;
    }

    /// <summary>The surface it is part of.</summary>
    public SurfaceBuilder Surface { get; }

    /// <summary>Where its vertices lie.</summary>
    public BodySkin Skin { get; }

    /// <summary>The vertex of a ring and a segment (any whole number).</summary>
    public int this[int ring, int segment] => ids[(ring * BodyGrid.Segments) + (segment & (BodyGrid.Segments - 1))];

    /// <summary>Takes a cell out of the body. Its mirror image has to be taken out too.</summary>
    public void Cut(int ring, int segment) => cut[(ring * BodyGrid.Segments) + (segment & (BodyGrid.Segments - 1))] = true;

    /// <summary>Adds the faces of all cells that were not cut. <paramref name="mouth"/> says which vertices the lower jaw uses.</summary>
    public void AddFaces(MouthSlit mouth)
    {
        for (int first = 0; first < BodyGrid.Segments / 2; first += StripWidth)
        {
            int last = System.Math.Min(first + StripWidth, BodyGrid.Segments / 2);
            for (int i = 0; i < BodyGrid.Rings - 1; i++)
            {
                for (int j = first; j < last; j++)
                {
                    if (!cut[(i * BodyGrid.Segments) + j])
                    {
                        Add(i, j, j + 1, ChartOf(i), mouth);
                    }
                }
            }

            for (int i = 0; i < BodyGrid.Rings - 1; i++)
            {
                for (int j = first; j < last; j++)
                {
                    if (!cut[(i * BodyGrid.Segments) + BodyGrid.MirrorCell(j)])
                    {
                        AddMirrored(i, j, j + 1, ChartOf(i), mouth);
                    }
                }
            }
        }
    }

    private int ChartOf(int ring) => ring < HeadEnd ? headChart : ring < TorsoEnd ? torsoChart : tailChart;

    /// <summary>Loop around the first ring, for the cap of the nose.</summary>
    public int[] NoseLoop()
    {
        int[] loop = new int[BodyGrid.Segments];
        for (int k = 0; k < loop.Length; k++)
        {
            loop[k] = this[0, -k];
        }

        return loop;
    }

    /// <summary>Loop around the last ring, for the cap of the tail.</summary>
    public int[] TailLoop()
    {
        int[] loop = new int[BodyGrid.Segments];
        for (int k = 0; k < loop.Length; k++)
        {
            loop[k] = this[BodyGrid.Rings - 1, k];
        }

        return loop;
    }

    private void Add(int i, int j0, int j1, int chart, MouthSlit mouth) =>
        Surface.Quad(
            mouth.Vertex(this, i, j0, i, j0),
            mouth.Vertex(this, i, j1, i, j0),
            mouth.Vertex(this, i + 1, j1, i, j0),
            mouth.Vertex(this, i + 1, j0, i, j0),
            chart,
            new FaceTexcoords(Texcoord(i, j0), Texcoord(i, j1), Texcoord(i + 1, j1), Texcoord(i + 1, j0)));

    private void AddMirrored(int i, int j0, int j1, int chart, MouthSlit mouth)
    {
        int cell = BodyGrid.MirrorCell(j0);
        Surface.Quad(
            mouth.Vertex(this, i, -j0, i, cell),
            mouth.Vertex(this, i + 1, -j0, i, cell),
            mouth.Vertex(this, i + 1, -j1, i, cell),
            mouth.Vertex(this, i, -j1, i, cell),
            chart,
            new FaceTexcoords(Texcoord(i, j0), Texcoord(i + 1, j0), Texcoord(i + 1, j1), Texcoord(i, j1)));
    }

    /// <summary>Left and right share the texture: the chart is folded along back and belly, and neither has a seam.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector2 Texcoord(int ring, int segment) => new(halfGirth * segment / (BodyGrid.Segments / 2), (float)Skin.Shape.Arc[ring]);
}
