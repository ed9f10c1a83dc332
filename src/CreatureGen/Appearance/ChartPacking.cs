using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Geometry;

namespace CreatureGen.Appearance;

/// <summary>
/// Lays the texture charts of a surface side by side in the unit square, all at one density.
/// </summary>
/// <remarks>
/// The tallest chart comes first, each as high up as it fits under the outline of those before it; the density is the largest, found by bisection, at which all fit.
/// Based on: J. Jylänki 2010, "A thousand ways to pack the bin" (skyline, bottom left).
/// </remarks>
internal sealed class ChartPacking
{
    /// <summary>Free space around a chart, as a part of the picture's side: two texels of the smallest picture, of 256.</summary>
    private const float Margin = 2f / 256f;

    private const int Bisections = 16;

    /// <summary>Places for plain texels in the free row above all charts, where pieces without a chart lie.</summary>
    private const int Swatches = 8;

    private readonly Vector2[] low;
    private readonly Vector2[] place;
    private readonly float density;

    private ChartPacking(Vector2[] low, Vector2[] place, float density)
    {
        this.low = low;
        this.place = place;
        this.density = density;
    }

    /// <summary>Part of the picture's side that one metre takes.</summary>
    public float Density => density;

    /// <summary>Where a point of a chart lies in the picture, 0..1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector2 Map(int chart, Vector2 texcoord) => place[chart] + ((texcoord - low[chart]) * new Vector2(density));

    /// <summary>The middle of a place for plain texels.</summary>
    /// <param name="swatch">0..7.</param>
    public static Vector2 Swatch(int swatch) => new((swatch + 0.5f) * Margin, 0.5f * Margin);

    /// <summary>Whether texture coordinates are those of plain texels.</summary>
    public static bool IsSwatch(Vector2 texcoord) => texcoord.Y < Margin && texcoord.X < Swatches * Margin;

    /// <summary>Texels along a side of a place for plain texels, in a picture of a size.</summary>
    public static int SwatchSide(int size) => (int)(Margin * size);

    /// <summary>Packs all charts of a surface.</summary>
    public static ChartPacking Pack(Surface surface)
    {
        int count = surface.Charts;
        var low = new Vector2[count];
        var high = new Vector2[count];
        Array.Fill(low, new Vector2(float.MaxValue));
        Array.Fill(high, new Vector2(float.MinValue));
        ReadOnlySpan<FaceTexcoords> texcoords = surface.Texcoords;
        for (int f = 0; f < surface.Faces.Length; )
        {
            // The faces of a chart mostly follow one another.
            int chart = surface.Faces[f].Chart;
            Vector2 min = low[chart];
            Vector2 max = high[chart];
            for (; f < surface.Faces.Length && surface.Faces[f].Chart == chart; f++)
            {
                FaceTexcoords t = texcoords[f];
                min = new Vector2(Min(min.X, t.A.X, t.B.X, t.C.X, t.D.X), Min(min.Y, t.A.Y, t.B.Y, t.C.Y, t.D.Y));
                max = new Vector2(Max(max.X, t.A.X, t.B.X, t.C.X, t.D.X), Max(max.Y, t.A.Y, t.B.Y, t.C.Y, t.D.Y));
            }

            low[chart] = min;
            high[chart] = max;
        }

        int[] order = new int[count];
        float[] height = new float[count];
        float area = 0f;
        for (int i = 0; i < count; i++)
        {
            order[i] = i;
            bool used = high[i].X >= low[i].X;
            Vector2 size = used ? high[i] - low[i] : Vector2.Zero;
            low[i] = used ? low[i] : Vector2.Zero;
            high[i] = low[i] + size;
            height[i] = size.Y;
            area += size.X * size.Y;
        }

        Array.Sort(order, (a, b) => height[a] != height[b] ? height[b].CompareTo(height[a]) : a.CompareTo(b));
        var place = new Vector2[count];
        var outline = new List<Step>(count + 2);
        float fits = 0f;
        float tooLarge = 1f / (float)Math.Sqrt(Math.Max(area, 1e-6f));
        for (int round = 0; round < Bisections; round++)
        {
            float middle = (fits + tooLarge) / 2f;
            if (Place(order, low, high, middle, place, outline))
            {
                fits = middle;
            }
            else
            {
                tooLarge = middle;
            }
        }

        Place(order, low, high, fits, place, outline);
        return new ChartPacking(low, place, fits);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Min(float bound, float a, float b, float c, float d) => Math.Min(bound, Math.Min(Math.Min(a, b), Math.Min(c, d)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Max(float bound, float a, float b, float c, float d) => Math.Max(bound, Math.Max(Math.Max(a, b), Math.Max(c, d)));

    /// <summary>Puts each chart as high up as it fits, left before right, under the outline of those already placed; false when one does not fit.</summary>
    private static bool Place(int[] order, Vector2[] low, Vector2[] high, float density, Vector2[] place, List<Step> outline)
    {
        outline.Clear();

        // Charts keep clear of the plain texels as they do of each other: white would show at their edges.
        outline.Add(new Step(0f, Swatches * Margin, Margin));
        outline.Add(new Step(Swatches * Margin, 1f, 0f));
        foreach (int chart in order)
        {
            Vector2 room = ((high[chart] - low[chart]) * density) + new Vector2(Margin, Margin);
            int best = -1;
            float min = 1f - Margin - room.Y;
            for (int i = 0; i < outline.Count; i++)
            {
                float below = Lowest(outline, i, room.X);
                if (below < min)
                {
                    best = i;
                    min = below;
                }
            }

            if (best < 0)
            {
                return false;
            }

            place[chart] = new Vector2(outline[best].From + Margin, min + Margin);
            Cover(outline, best, new Step(outline[best].From, outline[best].From + room.X, min + room.Y));
        }

        return true;
    }

    /// <summary>Where a chart that starts at a step may begin downwards; infinite when it does not fit to the right of there.</summary>
    private static float Lowest(List<Step> outline, int first, float width)
    {
        float end = outline[first].From + width;
        if (end > 1f - Margin)
        {
            return float.PositiveInfinity;
        }

        float below = 0f;
        for (int i = first; i < outline.Count && outline[i].From < end; i++)
        {
            below = Math.Max(below, outline[i].Below);
        }

        return below;
    }

    /// <summary>Lays a new step over the outline.</summary>
    private static void Cover(List<Step> outline, int at, Step step)
    {
        outline.Insert(at, step);
        int next = at + 1;
        while (next < outline.Count && outline[next].To <= step.To)
        {
            outline.RemoveAt(next);
        }

        if (next < outline.Count)
        {
            outline[next] = new Step(step.To, outline[next].To, outline[next].Below);
        }
    }

    /// <summary>A level part of the outline: how far down the picture is taken between two places.</summary>
    private readonly struct Step
    {
        public Step(float from, float to, float below)
        {
            From = from;
            To = to;
            Below = below;
        }

        public float From { get; }

        public float To { get; }

        public float Below { get; }
    }
}
