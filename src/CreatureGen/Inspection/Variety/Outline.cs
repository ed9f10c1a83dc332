using System;
using System.Numerics;

namespace CreatureGen.Inspection.Variety;

/// <summary>An outline from one direction, as bits of a square picture.</summary>
internal sealed class Outline
{
    /// <summary>Pixels on a side.</summary>
    public const int Side = 96;

    /// <summary>Pixels that stay free at each edge.</summary>
    public const int Border = 2;

    private readonly ulong[] bits = new ulong[Side * Side / 64];

    /// <summary>The outline of a mesh from its left side, as large as the picture has room for.</summary>
    /// <param name="positions">Vertices, in any unit; y is up and z is ahead, which is to the right of the picture.</param>
    /// <param name="triangles">Three indices for each triangle.</param>
    public static Outline FromSide(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        Vector2 low = new(float.MaxValue);
        Vector2 high = new(float.MinValue);
        foreach (Vector3 p in positions)
        {
            low = new Vector2(Math.Min(low.X, p.Z), Math.Min(low.Y, p.Y));
            high = new Vector2(Math.Max(high.X, p.Z), Math.Max(high.Y, p.Y));
        }

        Vector2 middle = (low + high) * 0.5f;
        float scale = ScaleFor(Math.Max(high.X - low.X, high.Y - low.Y));
        var outline = new Outline();
        for (int i = 0; i < triangles.Length; i += 3)
        {
            outline.Fill(Corner(positions[triangles[i]]), Corner(positions[triangles[i + 1]]), Corner(positions[triangles[i + 2]]));
        }

        return outline;

        Vector2 Corner(Vector3 p) => (new Vector2(p.Z, p.Y) - middle) * scale;
    }

    /// <summary>The outline in a picture, brought to the size and the place that those of meshes have.</summary>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="inside">Whether the pixel in a column and a row, from the top left, is of the outline; of one at least it is.</param>
    public static Outline OfPicture(int width, int height, Func<int, int, bool> inside)
    {
        int left = width, right = -1, top = height, bottom = -1;
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                if (inside(x, y))
                {
                    left = Math.Min(left, x);
                    right = Math.Max(right, x);
                    top = Math.Min(top, y);
                    bottom = Math.Max(bottom, y);
                }
            }
        }

        float scale = ScaleFor(Math.Max(right + 1 - left, bottom + 1 - top));
        float middleX = 0.5f * (left + right + 1);
        float middleY = 0.5f * (top + bottom + 1);
        var outline = new Outline();
        for (int y = 0; y < Side; y++)
        {
            for (int x = 0; x < Side; x++)
            {
                int column = (int)Math.Floor(middleX + ((x + 0.5f - (Side * 0.5f)) / scale));
                int row = (int)Math.Floor(middleY - ((y + 0.5f - (Side * 0.5f)) / scale));
                if (column >= left && column <= right && row >= top && row <= bottom && inside(column, row))
                {
                    outline.Set(x, y);
                }
            }
        }

        return outline;
    }

    /// <summary>Pixels for each unit of length, by which what is this long fills the picture.</summary>
    public static float ScaleFor(float longest) => longest > 0f ? (Side - (2 * Border)) / longest : 0f;

    /// <summary>The area that both cover over the area that either covers: 1 for the same, 0 for nothing in common; 1 for two that are empty.</summary>
    public double Likeness(Outline other)
    {
        int both = 0;
        int either = 0;
        for (int i = 0; i < bits.Length; i++)
        {
            both += Count(bits[i] & other.bits[i]);
            either += Count(bits[i] | other.bits[i]);
        }

        return either == 0 ? 1 : (double)both / either;
    }

    /// <summary>Sets the pixels whose middles a triangle covers, and those that its corners are in, so that what is thin leaves a trace. Corners in pixels from the middle of the picture.</summary>
    public void Fill(Vector2 a, Vector2 b, Vector2 c)
    {
        const float half = Side * 0.5f;
        a += new Vector2(half);
        b += new Vector2(half);
        c += new Vector2(half);
        Set((int)a.X, (int)a.Y);
        Set((int)b.X, (int)b.Y);
        Set((int)c.X, (int)c.Y);
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
                    Set(x, y);
                }
            }
        }
    }

    private static float Turn(Vector2 a, Vector2 b, Vector2 p) => ((b.X - a.X) * (p.Y - a.Y)) - ((b.Y - a.Y) * (p.X - a.X));

    private void Set(int x, int y)
    {
        int pixel = (y * Side) + x;
        bits[pixel >> 6] |= 1UL << (pixel & 63);
    }

    /// <summary>Number of bits that are set. Based on: H. S. Warren, Hacker's Delight, 2nd ed. 2013, section 5-1.</summary>
    private static int Count(ulong word)
    {
        word -= (word >> 1) & 0x5555555555555555UL;
        word = (word & 0x3333333333333333UL) + ((word >> 2) & 0x3333333333333333UL);
        return (int)((((word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FUL) * 0x0101010101010101UL) >> 56);
    }
}
