namespace CreatureGen.Preview.Pictures;

/// <summary>The colour of a pixel, sRGB-encoded, 0..255.</summary>
/// <param name="R">Red.</param>
/// <param name="G">Green.</param>
/// <param name="B">Blue.</param>
/// <param name="A">Opacity; 255 is opaque.</param>
public readonly record struct Pixel(byte R, byte G, byte B, byte A = 255);
