using System.Numerics;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// The lights and the backdrop of the studio. Directions go with the camera: x to its right, y up (+Y of the model), z level towards it.
/// Colours are linear RGB and may exceed 1.
/// </summary>
public sealed record Lighting
{
    /// <summary>The studio as it is by default: a warm key light from the upper left, cool sky, warm floor, a rim of light from behind.</summary>
    public static Lighting Studio { get; } = new();

    /// <summary>Direction to the key light; any length but zero, y above 0.</summary>
    public Vector3 KeyDirection { get; init; } = new(-0.5f, 0.85f, 0.5f);

    /// <summary>Colour of the key light.</summary>
    public Vector3 Key { get; init; } = new(1.28f, 1.17f, 1.02f);

    /// <summary>Radius of the key light divided by its distance: how soft shadows are.</summary>
    public float KeySize { get; init; } = 0.07f;

    /// <summary>Light from above.</summary>
    public Vector3 Sky { get; init; } = new(0.46f, 0.505f, 0.58f);

    /// <summary>Light from the floor.</summary>
    public Vector3 Bounce { get; init; } = new(0.29f, 0.27f, 0.25f);

    /// <summary>Light from the side of the camera, without shadow.</summary>
    public Vector3 Fill { get; init; } = new(0.10f, 0.105f, 0.115f);

    /// <summary>Direction to the light from behind.</summary>
    public Vector3 RimDirection { get; init; } = new(0.65f, 0.55f, -0.75f);

    /// <summary>Light from behind, seen only at outlines.</summary>
    public Vector3 Rim { get; init; } = new(0.42f, 0.46f, 0.52f);

    /// <summary>Brightness of the whole creature.</summary>
    public float Exposure { get; init; } = 1f;

    /// <summary>Colour of the backdrop at the upper edge of the picture.</summary>
    public Vector3 BackdropTop { get; init; } = new(0.50f, 0.55f, 0.60f);

    /// <summary>Colour of the backdrop at the lower edge of the picture.</summary>
    public Vector3 BackdropBottom { get; init; } = new(0.47f, 0.475f, 0.485f);

    /// <summary>Brightness of the glow behind the creature, added to 1 in the middle of the picture.</summary>
    public float BackdropGlow { get; init; } = 0.2f;

    /// <summary>How dark the place is where the creature touches the floor, 0..1.</summary>
    public float ContactShadow { get; init; } = 0.85f;
}
