using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>How surfaces are coloured.</summary>
public enum ShadingMode
{
    /// <summary>Studio light on smooth normals.</summary>
    Smooth,

    /// <summary>Studio light on flat faces: every triangle shows.</summary>
    Faceted,

    /// <summary>One colour per face: ((ddx × ddy) · lightDirection) · materialColour, where ddx and ddy are the changes of the position across the picture. See <see cref="FlatShading"/>.</summary>
    Flat,

    /// <summary>The colours of the surface as they are, without light.</summary>
    Unlit,
}

/// <summary>Places within a pixel at which it is tested what is seen there: more give smoother edges.</summary>
public enum SampleCount
{
    /// <summary>The middle of the pixel.</summary>
    One = 1,

    /// <summary>Four places, no two in one row or column.</summary>
    Four = 4,

    /// <summary>Eight places, no two in one row or column.</summary>
    Eight = 8,
}

/// <summary>What is seen behind the creature.</summary>
public enum BackdropKind
{
    /// <summary>A soft grey studio without a horizon, opaque.</summary>
    Studio,

    /// <summary>Nothing: the picture has opacity.</summary>
    Transparent,
}

/// <summary>What is under the creature.</summary>
public enum GroundKind
{
    /// <summary>A floor at y = 0 that shows only by the shadows on it.</summary>
    Shadows,

    /// <summary>Nothing.</summary>
    None,
}

/// <summary>How a picture is made.</summary>
public sealed record RenderOptions
{
    /// <summary>Pixels in a row, 1..8192.</summary>
    public int Width { get; init; } = 512;

    /// <summary>Rows, 1..8192.</summary>
    public int Height { get; init; } = 512;

    /// <summary>How surfaces are coloured.</summary>
    public ShadingMode Shading { get; init; } = ShadingMode.Smooth;

    /// <summary>Smoothness of edges.</summary>
    public SampleCount Samples { get; init; } = SampleCount.Eight;

    /// <summary>What is seen behind the creature.</summary>
    public BackdropKind Backdrop { get; init; } = BackdropKind.Studio;

    /// <summary>What is under the creature.</summary>
    public GroundKind Ground { get; init; } = GroundKind.Shadows;

    /// <summary>Light and colours of the studio.</summary>
    public Lighting Lighting { get; init; } = Lighting.Studio;

    /// <summary>Opacity of the whole creature, 0..1.</summary>
    public float Opacity { get; init; } = 1f;

    /// <summary>Direction to the light of <see cref="ShadingMode.Flat"/>, model space, any length but zero; null for that of the key light.</summary>
    public Vector3? FlatLightDirection { get; init; }

    /// <summary>Threads that share the work of one picture, at least 1. The picture is the same for any number.</summary>
    public int Threads { get; init; } = 1;
}
