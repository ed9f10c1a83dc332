using System.Numerics;

namespace CreatureGen.Lab.Runtime;

/// <summary>What can be heard or seen of a moment.</summary>
internal enum MomentKind
{
    /// <summary>A foot came down.</summary>
    Footfall,

    /// <summary>A beat of wings.</summary>
    WingBeat,

    /// <summary>It begins to call.</summary>
    Call,

    /// <summary>It ends its call.</summary>
    CallEnd,

    /// <summary>It bites, drinks or claws.</summary>
    Contact,

    /// <summary>An act is over.</summary>
    Done,

    /// <summary>It was knocked over.</summary>
    Fell,

    /// <summary>It stands again.</summary>
    Rose,
}

/// <summary>Something that happened to a creature in its last move.</summary>
/// <param name="Kind">What.</param>
/// <param name="Place">Where.</param>
/// <param name="Strength">How hard.</param>
internal readonly record struct Moment(MomentKind Kind, Vector3 Place, float Strength);
