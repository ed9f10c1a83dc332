namespace CreatureGen.Anatomy.Teeth;

/// <summary>Fish, dolphins and others that hold what is slippery: many thin needles that lean into the mouth.</summary>
internal static class NeedleTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0.02f, 0.9f), Count = 10, Height = (1f, 0.6f), Second = 0.62f, Fill = 0.6f, Stoutest = 0.3f, Depth = 1f, Curve = 0.22f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.88f), Count = 10, Height = (1f, 0.55f), Second = 0.66f, Fill = 0.6f, Stoutest = 0.3f, Depth = 1f, Curve = 0.22f },
        },
        Gum = 0.2f,
    };
}
