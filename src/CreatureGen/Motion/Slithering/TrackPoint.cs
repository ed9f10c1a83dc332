using System.Numerics;

namespace CreatureGen.Motion.Slithering;

/// <summary>A point on the ground, world space, metres, and the ground's upward unit normal there.</summary>
internal readonly struct TrackPoint
{
    public TrackPoint(double x, double y, double z, Vector3 normal)
    {
        X = x;
        Y = y;
        Z = z;
        Normal = normal;
    }

    public double X { get; }

    public double Y { get; }

    public double Z { get; }

    public Vector3 Normal { get; }
}
