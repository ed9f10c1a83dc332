using System;

namespace CreatureGen.Motion;

/// <summary>How bodies carry themselves, as acts tell them apart.</summary>
[Flags]
public enum BodyBuild
{
    /// <summary>On four paws under the body.</summary>
    Pawed = 1,

    /// <summary>On four hooves.</summary>
    Hoofed = 2,

    /// <summary>On pillars.</summary>
    Columnar = 4,

    /// <summary>On legs out to the side, two or more pairs.</summary>
    Sprawling = 8,

    /// <summary>On six legs or more.</summary>
    ManyLegged = 16,

    /// <summary>On two legs, trunk level: theropods and birds.</summary>
    TwoLegged = 32,

    /// <summary>On two legs, trunk upright.</summary>
    Upright = 64,

    /// <summary>On the belly, without legs.</summary>
    Legless = 128,

    /// <summary>In water.</summary>
    Swimming = 256,

    /// <summary>A flier without legs to stand on.</summary>
    Airborne = 512,

    /// <summary>All that stand on legs.</summary>
    Standing = Pawed | Hoofed | Columnar | Sprawling | ManyLegged | TwoLegged | Upright,

    /// <summary>All of them.</summary>
    Any = Standing | Legless | Swimming | Airborne,
}
