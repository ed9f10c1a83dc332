using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>A place of a species' own for a pair of legs.</summary>
/// <param name="Archetype">What legs.</param>
internal sealed record LegSite(LimbArchetype Archetype)
{
    /// <summary>Ring of its centre.</summary>
    public int Ring { get; init; }

    /// <summary>Segment of its centre.</summary>
    public double Segment { get; init; }

    /// <summary>Turn towards the front, radians.</summary>
    public double Azimuth { get; init; }

    /// <summary>Factor on the reach of the creature's legs.</summary>
    public double Reach { get; init; } = 1;

    /// <summary>Factor on their thickness.</summary>
    public double Thickness { get; init; } = 1;
}

/// <summary>Legs in a row along the whole body, as many as there are to be.</summary>
/// <param name="First">Ring of the first pair.</param>
/// <param name="Last">Ring of the last pair.</param>
/// <param name="Segment">Segment of all.</param>
/// <param name="Front">Turn of the first towards the front, radians.</param>
/// <param name="Rear">Turn of the last.</param>
internal sealed record LegRow(int First, int Last, double Segment, double Front, double Rear)
{
    /// <summary>Fewest and most pairs that have room.</summary>
    public const int Fewest = 4;
    public const int Max = 16;

    /// <summary>The places of a number of pairs, evenly.</summary>
    public LegSite[] Sites(int pairs)
    {
        var sites = new LegSite[pairs];
        for (int k = 0; k < pairs; k++)
        {
            int ring = (int)Math.Round(First + ((double)(Last - First) * k / (pairs - 1)));
            sites[k] = new LegSite(LimbArchetype.Insect) { Ring = ring, Segment = Segment, Azimuth = Front + ((Rear - Front) * k / (pairs - 1)) };
        }

        return sites;
    }
}

/// <summary>Legs of a species' own, all of which it always has.</summary>
internal sealed record LegPreset
{
    /// <summary>Legs that stand, or hang under a swimmer, front to rear.</summary>
    public LegSite[] Sites { get; init; } = Array.Empty<LegSite>();

    /// <summary>The same legs in any other number, where they stand in a row; null where the number is the species' own.</summary>
    public LegRow? Row { get; init; }

    /// <summary>Limbs that hang in front of it too.</summary>
    public LegSite[] Arms { get; init; } = Array.Empty<LegSite>();

    /// <summary>Unit of the outward shape, metres.</summary>
    public (double Min, double Max) Reach { get; init; }

    /// <summary>Height of the belly above the ground of one that stands, metres.</summary>
    public (double Min, double Max) Height { get; init; }

    /// <summary>Radius of the root, metres.</summary>
    public double Thickness { get; init; }

    /// <summary>Factor on the height of the knees.</summary>
    public double KneeRise { get; init; } = 1;

    /// <summary>Length of the claws in radii of the tip.</summary>
    public double Claw { get; init; } = 1.2;

    /// <summary>Fewest and most toes where there are any.</summary>
    public (int Min, int Max) Toes { get; init; } = (4, 4);

    /// <summary>Length of a hanging leg, metres.</summary>
    public double HangingLength { get; init; } = 0.26;

    /// <summary>Its places for at least and at most so many pairs: its own where they will do, else the nearest number that its row has room for.</summary>
    public LegSite[] SitesWithin(int min, int max)
    {
        if (Row == null || (Sites.Length >= min && Sites.Length <= max))
        {
            return Sites;
        }

        int nearest = Sites.Length < min ? min : max;
        return Row.Sites(Math.Min(Math.Max(nearest, LegRow.Fewest), LegRow.Max));
    }
}
