using System.Numerics;

namespace CreatureGen.Bodies;

/// <summary>A point of the body's skin and its outward direction, model space, metres at scale 1.</summary>
internal readonly struct SurfacePoint
{
    public SurfacePoint(Vector3 position, Vector3 normal)
    {
        Position = position;
        Normal = normal;
    }

    public Vector3 Position { get; }

    /// <summary>Unit.</summary>
    public Vector3 Normal { get; }
}
