namespace CreatureGen.Motion.Metrics;

/// <summary>What is done to the body as a command of a course begins, besides what the creature is asked.</summary>
public enum BodyCommand
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It goes limp.</summary>
    GoLimp,

    /// <summary>It gets up as soon as it lies still.</summary>
    GetUp,

    /// <summary>It jumps straight ahead, as far as seven tenths of its reach.</summary>
    Jump,

    /// <summary>A blow to its head from the left, of 0.4 of what would throw its body at √(gℓ).</summary>
    HitLeft,

    /// <summary>The same from the right.</summary>
    HitRight,

    /// <summary>The same from the front.</summary>
    HitFront,

    /// <summary>The same from behind.</summary>
    HitBehind,

    /// <summary>A blow from the left of twice as much, which knocks it down.</summary>
    KnockDown,
}
