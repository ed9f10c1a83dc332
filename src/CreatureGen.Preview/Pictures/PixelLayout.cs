namespace CreatureGen.Preview.Pictures;

/// <summary>What the bytes of a pixel are.</summary>
public enum PixelLayout
{
    /// <summary>Red, green, blue: three bytes, opaque.</summary>
    Rgb,

    /// <summary>Red, green, blue, opacity: four bytes, colour not multiplied by opacity.</summary>
    Rgba,
}
