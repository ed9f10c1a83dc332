using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>What of a mesh is seen in each pixel: fragments tile by tile, and depth and normal of the surface that fills most of the pixel.</summary>
internal sealed class VisibleSurface
{
    // Two triangles that meet in a pixel are shaded as one when the angle between their normals is below 25° and their depths differ by
    // no more than a few widths of the pixel.
    private const float OneSurfaceCosine = 0.9f;
    private const float OneSurfacePixels = 6f;

    // Nor are they where the colours of their corners change hard, as around a pupil: more than this, linear, in any channel.
    private const float OneSurfaceColour = 0.02f;

    private readonly RenderMesh mesh;
    private readonly Camera camera;
    private readonly ShadingMode shading;
    private readonly SamplePattern pattern;

    private VisibleSurface(RenderMesh mesh, Camera camera, ShadingMode shading, SamplePattern pattern, ScreenTriangle[] triangles, TileBins bins)
    {
        this.mesh = mesh;
        this.camera = camera;
        this.shading = shading;
        this.pattern = pattern;
        Triangles = triangles;
        Bins = bins;
        Fragments = new Fragment[bins.Count][];
        Depths = new float[bins.Width * bins.Height];
        Normals = new Vector3[bins.Width * bins.Height];
    }

    /// <summary>The triangles of the picture.</summary>
    public ScreenTriangle[] Triangles { get; }

    /// <summary>The tiles of the picture.</summary>
    public TileBins Bins { get; }

    /// <summary>Fragments of each tile, ordered by pixel.</summary>
    public Fragment[][] Fragments { get; }

    /// <summary>Distance along the camera's axis at each pixel, metres; 0 where nothing is seen.</summary>
    public float[] Depths { get; }

    /// <summary>Unit normals in the space of the camera (right, up, into the picture) at each pixel where something is seen.</summary>
    public Vector3[] Normals { get; }

    public static VisibleSurface Find(RenderMesh mesh, Camera camera, RenderOptions options)
    {
        SamplePattern pattern = SamplePattern.Of(options.Samples);
        ScreenTriangle[] triangles = ScreenProjection.Project(mesh, camera, options.Width, options.Height);
        var surface = new VisibleSurface(mesh, camera, options.Shading, pattern, triangles, new TileBins(triangles, options.Width, options.Height));
        Work.Share(surface.Bins.Count, options.Threads, () => new Scratch(pattern), surface.FindTile);
        return surface;
    }

    private void FindTile(int tile, Scratch scratch)
    {
        ReadOnlySpan<int> members = Bins[tile];
        if (members.Length == 0)
        {
            Fragments[tile] = [];
            return;
        }

        Bins.Pixels(tile, out int left, out int top, out int right, out int bottom);
        scratch.Rasteriser.Begin(left, top, right, bottom);
        foreach (int index in members)
        {
            scratch.Rasteriser.Draw(in Triangles[index], index);
        }

        scratch.Count = 0;
        for (int y = top; y < bottom; y++)
        {
            for (int x = left; x < right; x++)
            {
                FindPixel(x, y, scratch);
            }
        }

        Fragments[tile] = scratch.Fragments.AsSpan(0, scratch.Count).ToArray();
    }

    // Optimised from the first pixel on, as the rasteriser is.
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindPixel(int x, int y, Scratch scratch)
    {
        Vector256<int> seen = scratch.Rasteriser.Seen(x, y);
        int first = scratch.Count;
        int open = pattern.All;
        do
        {
            // The samples that show the same triangle as the first one left.
            int triangle = seen[BitOperations.TrailingZeroCount(open)];
            int mask = (int)Vector256.Equals(seen, Vector256.Create(triangle)).ExtractMostSignificantBits() & open;
            open &= ~mask;
            if (triangle >= 0)
            {
                Add(scratch, triangle, x, y, mask);
            }
        }
        while (open != 0);

        if (scratch.Count == first)
        {
            return;
        }

        int largest = first;
        for (int i = first + 1; i < scratch.Count; i++)
        {
            if (BitOperations.PopCount((uint)scratch.Fragments[i].Mask) > BitOperations.PopCount((uint)scratch.Fragments[largest].Mask))
            {
                largest = i;
            }
        }

        (scratch.Fragments[first], scratch.Fragments[largest]) = (scratch.Fragments[largest], scratch.Fragments[first]);
        ref Fragment main = ref scratch.Fragments[first];
        int pixel = main.Pixel;
        Depths[pixel] = main.Depth;
        var normal = new Vector3(main.NormalX, main.NormalY, main.NormalZ);
        Normals[pixel] = new Vector3(Vec.Dot(normal, camera.Right), Vec.Dot(normal, camera.Up), Vec.Dot(normal, camera.Forward));
        if (shading is ShadingMode.Smooth or ShadingMode.Unlit)
        {
            Merge(scratch, first);
        }
    }

    private void Add(Scratch scratch, int triangle, int x, int y, int mask)
    {
        ref readonly ScreenTriangle t = ref Triangles[triangle];
        float dx = x - t.MinX;
        float dy = y - t.MinY;
        if (mask != pattern.All)
        {
            // The middle of what is seen, so that nothing is taken from beyond the triangle's edge.
            int sumX = 0;
            int sumY = 0;
            for (int s = 0; s < pattern.Count; s++)
            {
                if ((mask >> s & 1) != 0)
                {
                    sumX += pattern.X[s];
                    sumY += pattern.Y[s];
                }
            }

            float scale = 1f / (BitOperations.PopCount((uint)mask) * ScreenProjection.SubPixel);
            dx += sumX * scale;
            dy += sumY * scale;
        }

        float depth = 1f / Math.Clamp(t.Depth + (t.DepthX * dx) + (t.DepthY * dy), t.DepthMin, t.DepthMax);
        float b = Math.Clamp((t.B + (t.BX * dx) + (t.BY * dy)) * depth, 0f, 1f);
        float c = Math.Clamp((t.C + (t.CX * dx) + (t.CY * dy)) * depth, 0f, 1f);
        if (b + c > 1f)
        {
            float sum = b + c;
            b /= sum;
            c /= sum;
        }

        Vector3 normal = NormalAt(t.Source, b, c) * t.Side;
        scratch.Add(new Fragment
        {
            Triangle = triangle,
            Pixel = (y * Bins.Width) + x,
            Mask = mask,
            Depth = depth,
            B = b,
            C = c,
            NormalX = normal.X,
            NormalY = normal.Y,
            NormalZ = normal.Z,
        });
    }

    private Vector3 NormalAt(int source, float b, float c)
    {
        int i0 = mesh.Triangles[source];
        int i1 = mesh.Triangles[source + 1];
        int i2 = mesh.Triangles[source + 2];
        if (shading is ShadingMode.Smooth or ShadingMode.Unlit)
        {
            Vector3 smooth = (mesh.Normals[i0] * (1f - b - c)) + (mesh.Normals[i1] * b) + (mesh.Normals[i2] * c);
            float square = Vec.LengthSquared(smooth);
            if (square > 1e-8f)
            {
                return smooth * (1f / MathF.Sqrt(square));
            }
        }

        return FlatShading.FaceNormal(mesh.Positions[i0], mesh.Positions[i1], mesh.Positions[i2]);
    }

    // Joins fragments of one smooth surface, which would be shaded alike.
    private void Merge(Scratch scratch, int first)
    {
        ref Fragment main = ref scratch.Fragments[first];
        float limit = main.Depth * OneSurfacePixels / camera.PixelsPerTangent(Bins.Height);
        int kept = first + 1;
        for (int i = first + 1; i < scratch.Count; i++)
        {
            ref Fragment other = ref scratch.Fragments[i];
            float cosine = (main.NormalX * other.NormalX) + (main.NormalY * other.NormalY) + (main.NormalZ * other.NormalZ);
            if (cosine > OneSurfaceCosine
                && Math.Abs(other.Depth - main.Depth) < limit
                && Triangles[main.Triangle].Part == Triangles[other.Triangle].Part
                && IsSameColour(in main, in other))
            {
                main.Mask |= other.Mask;
            }
            else
            {
                scratch.Fragments[kept++] = other;
            }
        }

        scratch.Count = kept;
    }

    private bool IsSameColour(in Fragment a, in Fragment b)
    {
        Vector3 difference = ColourAt(in a) - ColourAt(in b);
        return Math.Max(Math.Abs(difference.X), Math.Max(Math.Abs(difference.Y), Math.Abs(difference.Z))) <= OneSurfaceColour;
    }

    private Vector3 ColourAt(in Fragment fragment)
    {
        int source = Triangles[fragment.Triangle].Source;
        return (mesh.Colours[mesh.Triangles[source]] * (1f - fragment.B - fragment.C))
            + (mesh.Colours[mesh.Triangles[source + 1]] * fragment.B)
            + (mesh.Colours[mesh.Triangles[source + 2]] * fragment.C);
    }

    /// <summary>What one thread needs.</summary>
    private sealed class Scratch(SamplePattern pattern)
    {
        public Rasteriser Rasteriser { get; } = new(pattern);

        public Fragment[] Fragments { get; private set; } = new Fragment[2048];

        public int Count { get; set; }

        public void Add(in Fragment fragment)
        {
            if (Count == Fragments.Length)
            {
                Fragment[] larger = new Fragment[Count * 2];
                Fragments.CopyTo(larger, 0);
                Fragments = larger;
            }

            Fragments[Count++] = fragment;
        }
    }
}
