namespace CreatureGen.Motion;

/// <summary>Whether a movement goes on and on, or from one to another.</summary>
public enum ClipKind
{
    /// <summary>On and on.</summary>
    Lasting,

    /// <summary>From standing into the air.</summary>
    TakeOff,

    /// <summary>Out of the air onto the feet.</summary>
    Landing,

    /// <summary>Out of swimming round to one side, and on from there.</summary>
    Escape,

    /// <summary>An act, from standing to standing.</summary>
    Act,
}
