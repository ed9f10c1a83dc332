namespace CreatureGen.Png;

/// <summary>What the bytes of a picture mean; one byte per channel.</summary>
public enum PngPixels
{
    /// <summary>Red, green, blue.</summary>
    Rgb,

    /// <summary>Red, green, blue, opacity (not multiplied in).</summary>
    Rgba,
}
