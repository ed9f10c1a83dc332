using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>A place of a species' own for a pair of legs.</summary>
internal readonly struct LegSite
{
    public LegSite(LimbArchetype archetype, int ring, double segment, double azimuth, double reach, double thickness)
    {
        Archetype = archetype;
        Ring = ring;
        Segment = segment;
        Azimuth = azimuth;
        Reach = reach;
        Thickness = thickness;
    }

    public LimbArchetype Archetype { get; }

    /// <summary>Ring of its centre.</summary>
    public int Ring { get; }

    /// <summary>Segment of its centre.</summary>
    public double Segment { get; }

    /// <summary>Turn towards the front, radians.</summary>
    public double Azimuth { get; }

    /// <summary>Factor on the reach of the creature's legs.</summary>
    public double Reach { get; }

    /// <summary>Factor on their thickness.</summary>
    public double Thickness { get; }
}

/// <summary>Legs of a species' own, all of which it always has.</summary>
internal sealed record LegPreset
{
    /// <summary>Legs that stand, or hang under a swimmer, front to rear.</summary>
    public LegSite[] Sites { get; init; } = Array.Empty<LegSite>();

    /// <summary>Limbs that hang in front of it too.</summary>
    public LegSite[] Arms { get; init; } = Array.Empty<LegSite>();

    /// <summary>Unit of the outward shape, metres.</summary>
    public (double Least, double Most) Reach { get; init; }

    /// <summary>Height of the belly above the ground of one that stands, metres.</summary>
    public (double Least, double Most) Height { get; init; }

    /// <summary>Radius of the root, metres.</summary>
    public double Thickness { get; init; }

    /// <summary>Factor on the height of the knees.</summary>
    public double KneeRise { get; init; } = 1;

    /// <summary>Length of the claws in radii of the tip.</summary>
    public double Claw { get; init; } = 1.2;

    /// <summary>Fewest and most toes where there are any.</summary>
    public (int Least, int Most) Toes { get; init; } = (4, 4);

    /// <summary>Length of a hanging leg, metres.</summary>
    public double HangingLength { get; init; } = 0.26;
}
