namespace CreatureGen.Anatomy.Teeth;

/// <summary>Crocodiles and their kin: uneven cones along the whole jaw that stand outside of the lips, so that they are seen when it is shut.</summary>
internal static class CrocodileTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0.02f, 0.3f), Count = 4, Height = (0.65f, 1f), Second = 0.7f, Fill = 0.8f, Stoutest = 0.5f },
            new ToothSet { Stretch = (0.32f, 0.9f), Count = 8, Height = (0.9f, 0.5f), Second = 0.65f, Fill = 0.75f, Stoutest = 0.5f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0.05f, 0.33f), Count = 4, Height = (0.8f, 0.95f), Second = 0.65f, Fill = 0.75f, Stoutest = 0.48f },
            new ToothSet { Stretch = (0.36f, 0.88f), Count = 7, Height = (0.75f, 0.4f), Second = 0.7f, Fill = 0.7f, Stoutest = 0.5f },
        },
        Bared = true,
        Gum = 0.16f,
    };
}
