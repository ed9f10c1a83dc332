using System;

namespace CreatureGen.Motion;

/// <summary>What a body must have for an act.</summary>
[Flags]
public enum ActNeeds
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>A head.</summary>
    Head = 1,

    /// <summary>A jaw that opens.</summary>
    Jaw = 2,

    /// <summary>Horns, antlers or tusks.</summary>
    Horns = 4,

    /// <summary>Legs that it stands on.</summary>
    Legs = 8,

    /// <summary>Two pairs of legs at least.</summary>
    FourLegs = 16,

    /// <summary>A tail of half its body's length at least.</summary>
    LongTail = 32,

    /// <summary>A tail of any length that is not the body itself.</summary>
    Tail = 64,

    /// <summary>Arms.</summary>
    Arms = 128,

    /// <summary>Lids that shut.</summary>
    Lids = 256,

    /// <summary>A tail that ends in a sting.</summary>
    Sting = 512,

    /// <summary>The abdomen of an insect.</summary>
    Abdomen = 1024,

    /// <summary>Flanks to lie on: a body on legs below it.</summary>
    Flanks = 2048,

    /// <summary>A back to lie on: a body with its legs out to the sides, without horns that would dig into the ground and without wings to roll over, which would carry it into the air.</summary>
    Back = 4096,

    /// <summary>Flanks without wings folded onto them: who has such wings dies on them, and sleeps on its belly.</summary>
    BareFlanks = 8192,

    /// <summary>Five pairs of legs or more, on a trunk that bends: its front can be raised with its feet.</summary>
    Front = 16384,
}
