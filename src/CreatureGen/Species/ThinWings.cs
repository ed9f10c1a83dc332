using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>A pair of thin wings.</summary>
internal readonly struct ThinWing
{
    public ThinWing(double ring, double length, double width, double azimuth, double elevation, ThinWingStyle style = ThinWingStyle.Blade)
    {
        Ring = ring;
        Length = length;
        Width = width;
        Azimuth = azimuth;
        Elevation = elevation;
        Style = style;
    }

    public double Ring { get; }

    /// <summary>Metres; varies by a tenth.</summary>
    public double Length { get; }

    /// <summary>Metres.</summary>
    public double Width { get; }

    /// <summary>Degrees towards the front from straight out.</summary>
    public double Azimuth { get; }

    /// <summary>Degrees above the level plane.</summary>
    public double Elevation { get; }

    /// <summary>Its outline.</summary>
    public ThinWingStyle Style { get; }
}

/// <summary>The thin wings of a species: as its fliers spread them and as its walkers carry them.</summary>
internal sealed record ThinWings
{
    public ThinWing[] Spread { get; init; } = Array.Empty<ThinWing>();

    public ThinWing[] Folded { get; init; } = Array.Empty<ThinWing>();
}
