using System.Numerics;

namespace CreatureGen.Motion.Slithering;

/// <summary>The ground under a crawler, found by rays along −Y, in metres of the model.</summary>
internal readonly struct CrawlFloor
{
    /// <summary>How far above a known height the ground is looked for, and how far below, body lengths.</summary>
    private const float Climb = 0.5f;
    private const float Fall = 1f;

    private readonly IGround ground;
    private readonly float scale;
    private readonly float length;

    /// <summary>Takes the ground, the crawler's scale and its length in metres of the model.</summary>
    public CrawlFloor(IGround ground, float scale, float length)
    {
        this.ground = ground;
        this.scale = scale;
        this.length = length;
    }

    /// <summary>Height and upward unit normal of the ground at a place; where there is none, the height goes on level.</summary>
    /// <param name="x">Across.</param>
    /// <param name="near">Height of the ground close by.</param>
    /// <param name="z">Along.</param>
    /// <param name="normal">Receives the normal.</param>
    public double HeightAt(double x, double near, double z, out Vector3 normal)
    {
        var above = new Vector3((float)(x * scale), (float)((near + (Climb * length)) * scale), (float)(z * scale));
        if (ground.Cast(above, -Vector3.UnitY, (Climb + Fall) * length * scale, out GroundHit hit))
        {
            normal = hit.Normal;
            return hit.Point.Y / scale;
        }

        normal = Vector3.UnitY;
        return near;
    }
}
