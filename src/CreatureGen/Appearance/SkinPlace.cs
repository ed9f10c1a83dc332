using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>A vertex of the surface as the coat sees it, folded onto the left side.</summary>
internal readonly struct SkinPlace
{
    private readonly float aroundAppendage;

    public SkinPlace(in VertexAddress address, Vector3 position, Vector3 normal, BodyShape body)
    {
        Region = address.Region;
        Appendage = address.Appendage;
        float side = address.Sign < 0 || position.X < 0f ? -1f : 1f;
        Position = new Vector3(Math.Abs(position.X), position.Y, position.Z);
        Normal = new Vector3(normal.X * side, normal.Y, normal.Z);
        Ring = Scalar.Clamp(address.Ring, 0f, BodyGrid.Rings - 1f);

        // Folded in segments, where both sides are exact, not in radians, where they are rounded differently.
        float segment = Math.Abs(address.Segment);
        segment = Math.Min(segment, BodyGrid.Segments - segment);
        Around = Scalar.Clamp(segment, 0f, BodyGrid.Segments / 2f) * (float)(PortableMath.Tau / BodyGrid.Segments);
        Arc = (float)BodyShape.At(body.Arc, Ring);
        Along = Scalar.Clamp(address.Along, 0f, 1f);
        aroundAppendage = address.Around;
    }

    public SurfaceRegion Region { get; }

    public int Appendage { get; }

    /// <summary>Rest position with x ≥ 0, metres at scale 1.</summary>
    public Vector3 Position { get; }

    /// <summary>Unit; as it would be on the left side.</summary>
    public Vector3 Normal { get; }

    /// <summary>Ring of the body, or of the socket's border that the vertex grew from.</summary>
    public float Ring { get; }

    /// <summary>Radians around the body, 0 dorsal to π ventral.</summary>
    public float Around { get; }

    /// <summary>0 on the back to 1 on the belly.</summary>
    public float Ventral => 0.5f * (1f - (float)PortableMath.Cos(Around));

    /// <summary>Metres along the body from the nose.</summary>
    public float Arc { get; }

    /// <summary>0..1 along the appendage.</summary>
    public float Along { get; }

    /// <summary>Of a wing or fin: 0 at the leading edge to 1 at the trailing edge.</summary>
    public float Chord => 0.5f * (1f - (float)PortableMath.Cos(aroundAppendage));

    /// <summary>Whether the vertex belongs to trunk, neck, head or tail, outside of the mouth.</summary>
    public bool IsTrunk => Region is SurfaceRegion.Body or SurfaceRegion.Nose or SurfaceRegion.Lip;

    /// <summary>Whether the vertex belongs to a leg or arm.</summary>
    public bool IsLimb => Region is SurfaceRegion.Leg or SurfaceRegion.Toe or SurfaceRegion.Hoof;
}
