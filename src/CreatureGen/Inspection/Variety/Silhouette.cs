using System;
using System.Numerics;

namespace CreatureGen.Inspection.Variety;

/// <summary>The outlines of a creature from the side, from the front and from above, as bits: what an eye tells creatures apart by, without colour and size.</summary>
/// <remarks>All three views have one scale, by which the longest side of the creature fills the picture, and lie in its middle.</remarks>
internal sealed class Silhouette
{
    /// <summary>Pixels on a side of a view.</summary>
    public const int Side = 96;

    /// <summary>Pixels that stay free at each edge.</summary>
    private const int Border = 2;

    private const int Views = 3;
    private const int WordsPerView = Side * Side / 64;

    private readonly ulong[] bits = new ulong[Views * WordsPerView];

    /// <summary>Draws the outlines of a mesh.</summary>
    /// <param name="positions">Vertices, in any unit.</param>
    /// <param name="triangles">Three indices for each triangle.</param>
    public Silhouette(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        Vector3 low = new(float.MaxValue);
        Vector3 high = new(float.MinValue);
        foreach (Vector3 position in positions)
        {
            low = new Vector3(Math.Min(low.X, position.X), Math.Min(low.Y, position.Y), Math.Min(low.Z, position.Z));
            high = new Vector3(Math.Max(high.X, position.X), Math.Max(high.Y, position.Y), Math.Max(high.Z, position.Z));
        }

        Vector3 size = high - low;
        float longest = Math.Max(size.X, Math.Max(size.Y, size.Z));
        float scale = longest > 0f ? (Side - (2 * Border)) / longest : 0f;
        Vector3 middle = (low + high) * 0.5f;
        for (int i = 0; i < triangles.Length; i += 3)
        {
            Vector3 a = (positions[triangles[i]] - middle) * scale;
            Vector3 b = (positions[triangles[i + 1]] - middle) * scale;
            Vector3 c = (positions[triangles[i + 2]] - middle) * scale;
            Fill(0, new Vector2(a.Z, a.Y), new Vector2(b.Z, b.Y), new Vector2(c.Z, c.Y));
            Fill(1, new Vector2(a.X, a.Y), new Vector2(b.X, b.Y), new Vector2(c.X, c.Y));
            Fill(2, new Vector2(a.X, a.Z), new Vector2(b.X, b.Z), new Vector2(c.X, c.Z));
        }
    }

    /// <summary>How much two creatures have in common: the mean over the views of the area that both cover, relative to the area that either covers. 1 for the same, 0 for nothing.</summary>
    public double Likeness(Silhouette other)
    {
        double sum = 0;
        for (int view = 0; view < Views; view++)
        {
            int both = 0;
            int either = 0;
            for (int i = view * WordsPerView; i < (view + 1) * WordsPerView; i++)
            {
                both += Count(bits[i] & other.bits[i]);
                either += Count(bits[i] | other.bits[i]);
            }

            sum += either == 0 ? 1 : (double)both / either;
        }

        return sum / Views;
    }

    /// <summary>Sets the pixels whose middles a triangle covers, and those that its corners are in, so that what is thin leaves a trace.</summary>
    private void Fill(int view, Vector2 a, Vector2 b, Vector2 c)
    {
        const float half = Side * 0.5f;
        a += new Vector2(half);
        b += new Vector2(half);
        c += new Vector2(half);
        Set(view, (int)a.X, (int)a.Y);
        Set(view, (int)b.X, (int)b.Y);
        Set(view, (int)c.X, (int)c.Y);
        int left = Math.Max(0, (int)Math.Min(a.X, Math.Min(b.X, c.X)));
        int right = Math.Min(Side - 1, (int)Math.Max(a.X, Math.Max(b.X, c.X)));
        int bottom = Math.Max(0, (int)Math.Min(a.Y, Math.Min(b.Y, c.Y)));
        int top = Math.Min(Side - 1, (int)Math.Max(a.Y, Math.Max(b.Y, c.Y)));
        for (int y = bottom; y <= top; y++)
        {
            for (int x = left; x <= right; x++)
            {
                var p = new Vector2(x + 0.5f, y + 0.5f);
                float ab = Turn(a, b, p);
                float bc = Turn(b, c, p);
                float ca = Turn(c, a, p);
                if ((ab >= 0f && bc >= 0f && ca >= 0f) || (ab <= 0f && bc <= 0f && ca <= 0f))
                {
                    Set(view, x, y);
                }
            }
        }
    }

    private static float Turn(Vector2 a, Vector2 b, Vector2 p) => ((b.X - a.X) * (p.Y - a.Y)) - ((b.Y - a.Y) * (p.X - a.X));

    private void Set(int view, int x, int y)
    {
        int pixel = (y * Side) + x;
        bits[(view * WordsPerView) + (pixel >> 6)] |= 1UL << (pixel & 63);
    }

    /// <summary>Number of bits that are set. Based on: H. S. Warren, Hacker's Delight, 2nd ed. 2013, section 5-1.</summary>
    private static int Count(ulong word)
    {
        word -= (word >> 1) & 0x5555555555555555UL;
        word = (word & 0x3333333333333333UL) + ((word >> 2) & 0x3333333333333333UL);
        return (int)((((word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FUL) * 0x0101010101010101UL) >> 56);
    }
}
