using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling.Placement;

/// <summary>How wings beat.</summary>
internal enum WingMotion
{
    /// <summary>Large wings left and right of the middle of the body.</summary>
    Flapping,

    /// <summary>Thin fast wings on top of the front half of the body.</summary>
    Buzzing,
}

/// <summary>How a flier's legs stand along its body.</summary>
internal enum LegArrangement
{
    /// <summary>Close together.</summary>
    Clustered,

    /// <summary>Evenly spaced along the body.</summary>
    Spread,
}

/// <summary>What legs a flier asks for.</summary>
/// <param name="Pairs">Number of pairs, 0..8.</param>
/// <param name="Arrangement">How they stand along the body.</param>
internal readonly record struct FlyingLegs(int Pairs, LegArrangement Arrangement);

/// <summary>Where legs of a flier may grow, and how long one is when it is the only pair.</summary>
/// <param name="Sockets">Places, front to rear.</param>
/// <param name="Length">Length of the legs of a creature with one pair, relative to the body's length.</param>
/// <param name="Size">Size of the legs beside that.</param>
internal sealed record FlierLegAnatomy(IReadOnlyList<LimbSocket> Sockets, double Length, LegSize Size)
{
    /// <summary>One pair of a bird's legs.</summary>
    public static FlierLegAnatomy Bird { get; } = new(SocketSets.BirdLegs(), 0.58, LegSize.Nominal);

    /// <summary>Three or four pairs.</summary>
    public static FlierLegAnatomy Beast { get; } = new(SocketSets.WingedBeastLegs(), 0.72, LegSize.Nominal);

    /// <summary>Fore and hind legs of a winged quadruped.</summary>
    public static FlierLegAnatomy Dragon { get; } = new(SocketSets.DragonLegs(), 0.72, LegSize.Nominal);

    /// <summary>Legs of a winged insect.</summary>
    public static FlierLegAnatomy Insect { get; } = new(SocketSets.WingedInsectLegs(), 0.55, LegSize.Nominal with { Foot = 1, Toes = 0 });
}

/// <summary>A pair of wings where the rules put it.</summary>
/// <param name="Bone">Index of the measured bone that carries it.</param>
/// <param name="Ring">Ring of the root's middle.</param>
/// <param name="Socket">The cells it grows out of; null for thin wings, which are set on the back.</param>
/// <param name="Scale">Its size.</param>
internal sealed record WingPlacement(int Bone, double Ring, SocketBlueprint? Socket, PartScale Scale);

/// <summary>Where a flier's limbs are.</summary>
/// <param name="Motion">How its wings beat.</param>
/// <param name="Wings">Pairs of wings, front to rear.</param>
/// <param name="Legs">Pairs of legs, front to rear; fewer than asked for when no more find a free bone.</param>
/// <param name="LegFactor">Factor on the size of every leg, already in the placements: the more legs, the smaller.</param>
internal sealed record FlyingPlacement(WingMotion Motion, IReadOnlyList<WingPlacement> Wings, IReadOnlyList<LegPlacement> Legs, double LegFactor);
