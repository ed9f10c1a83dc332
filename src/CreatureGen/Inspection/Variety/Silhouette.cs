using System;
using System.Numerics;

namespace CreatureGen.Inspection.Variety;

/// <summary>The outlines of a creature from the side, from the front and from above, as bits: what an eye tells creatures apart by, without colour and size.</summary>
/// <remarks>All three views have one scale, by which the longest side of the creature fills the picture, and lie in its middle.</remarks>
internal sealed class Silhouette
{
    private readonly Outline side = new();
    private readonly Outline front = new();
    private readonly Outline above = new();

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
        float scale = Outline.ScaleFor(Math.Max(size.X, Math.Max(size.Y, size.Z)));
        Vector3 middle = (low + high) * 0.5f;
        for (int i = 0; i < triangles.Length; i += 3)
        {
            Vector3 a = (positions[triangles[i]] - middle) * scale;
            Vector3 b = (positions[triangles[i + 1]] - middle) * scale;
            Vector3 c = (positions[triangles[i + 2]] - middle) * scale;
            side.Fill(new Vector2(a.Z, a.Y), new Vector2(b.Z, b.Y), new Vector2(c.Z, c.Y));
            front.Fill(new Vector2(a.X, a.Y), new Vector2(b.X, b.Y), new Vector2(c.X, c.Y));
            above.Fill(new Vector2(a.X, a.Z), new Vector2(b.X, b.Z), new Vector2(c.X, c.Z));
        }
    }

    /// <summary>How much two creatures have in common: the mean over the views of the area that both cover, relative to the area that either covers. 1 for the same, 0 for nothing.</summary>
    public double Likeness(Silhouette other) => (side.Likeness(other.side) + front.Likeness(other.front) + above.Likeness(other.above)) / 3;
}
