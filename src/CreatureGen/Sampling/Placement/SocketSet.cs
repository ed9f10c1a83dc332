using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>The places where the anatomy of one plan may carry legs and arms.</summary>
/// <param name="Plan">The plan.</param>
/// <param name="Legs">Places for legs, front to rear.</param>
/// <param name="MinimumPairs">Fewest pairs of legs: with fewer it would be another plan (a dog has two, a beetle three).</param>
/// <param name="Arms">Places and odds of arms; null where there are none.</param>
/// <param name="Stance">What may be done for length and balance.</param>
internal sealed record SocketSet(BodyPlan Plan, IReadOnlyList<LimbSocket> Legs, int MinimumPairs, ArmAnatomy? Arms, StanceLimits Stance)
{
    /// <summary>Whether legs grow at all of the places, however close, instead of where the rules choose.</summary>
    public bool TakesAll { get; init; }

    /// <summary>How thick legs are that grow at all of the places.</summary>
    public LegGirth Girth { get; init; }

    /// <summary>The same anatomy with legs at the given places and nowhere else.</summary>
    public SocketSet Pinned(IReadOnlyList<LimbSocket> places, LegGirth girth) =>
        this with { Legs = places, MinimumPairs = places.Count, Arms = null, TakesAll = true, Girth = girth };

    /// <summary>The same places with other girths: of the legs in front of the body's middle and of those behind it.</summary>
    public SocketSet WithGirth(double fore, double hind) =>
        this with { Legs = Scale(Legs, fore, hind), Arms = Arms is null ? null : Arms with { Legs = Scale(Arms.Legs, fore, hind) } };

    /// <summary>The same places with legs that grow from nearer to the belly: by so many segments in front of the body's middle and behind it.</summary>
    public SocketSet Lowered(double fore, double hind) =>
        this with { Legs = Lower(Legs, fore, hind), Arms = Arms is null ? null : Arms with { Legs = Lower(Arms.Legs, fore, hind) } };

    private static IReadOnlyList<LimbSocket> Lower(IReadOnlyList<LimbSocket> sockets, double fore, double hind)
    {
        var lowered = new LimbSocket[sockets.Count];
        for (int i = 0; i < lowered.Length; i++)
        {
            lowered[i] = sockets[i] with { Segment = sockets[i].Segment + (sockets[i].Ring < BodyGrid.AnchorRing ? fore : hind) };
        }

        return lowered;
    }

    private static IReadOnlyList<LimbSocket> Scale(IReadOnlyList<LimbSocket> sockets, double fore, double hind)
    {
        var scaled = new LimbSocket[sockets.Count];
        for (int i = 0; i < scaled.Length; i++)
        {
            scaled[i] = sockets[i] with { Girth = sockets[i].Girth * (sockets[i].Ring < BodyGrid.AnchorRing ? fore : hind) };
        }

        return scaled;
    }
}

/// <summary>Arms of a plan.</summary>
/// <param name="Sockets">Places for a pair of arms.</param>
/// <param name="Legs">Places for legs of a creature with arms, front to rear: forelegs make room.</param>
/// <param name="OddsNear">Probability of arms when the first legs sit at the head.</param>
/// <param name="OddsFar">Probability of arms when the first legs sit at the body's rear end.</param>
/// <param name="Length">Length of an arm relative to the body's length.</param>
internal sealed record ArmAnatomy(IReadOnlyList<LimbSocket> Sockets, IReadOnlyList<LimbSocket> Legs, double OddsNear, double OddsFar, double Length);
