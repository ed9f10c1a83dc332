using System;
using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>Swellings and hollows of a head beside brow and cheek, relative to the section.</summary>
internal sealed record SkullShape
{
    /// <summary>Swelling below the cheek, where the jaw hinges.</summary>
    public double Jowl { get; init; } = 0.08;

    /// <summary>Swelling of the lips.</summary>
    public double Lips { get; init; }

    /// <summary>Hollow between muzzle and cheek.</summary>
    public double Stop { get; init; } = 0.07;

    /// <summary>Swelling of the chin.</summary>
    public double Chin { get; init; } = 0.12;

    /// <summary>What else models the muzzle, the same in every head.</summary>
    public HeadBump[] Muzzle { get; init; } = Array.Empty<HeadBump>();
}
