namespace CreatureGen.Motion.Clips;

/// <summary>What games call the events of a clip.</summary>
internal static class ClipEvents
{
    /// <summary>The name of an event; null for what a clip tells by being played.</summary>
    public static string? NameOf(MotionEventKind kind) => kind switch
    {
        MotionEventKind.FootDown => "footstep",
        MotionEventKind.FootUp => "liftoff",
        MotionEventKind.WingBeat => "flap",
        MotionEventKind.Landed => "land",
        _ => null,
    };

    /// <summary>The name of a moment of an act; null for those that nothing is to be heard of.</summary>
    public static string? NameOf(Act act, ActMark mark) => mark switch
    {
        ActMark.SoundBegin => "call",
        ActMark.Contact => act.Name == "Bite" ? "bite" : act.Name is "Eat" or "Drink" or "Groom" or "Scratch" ? "stuff" : "whoosh",
        _ => null,
    };
}
