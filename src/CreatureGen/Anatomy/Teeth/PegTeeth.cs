namespace CreatureGen.Anatomy.Teeth;

/// <summary>Lizards, newts of old and their kin: one row of small pointed pegs of one kind, lower towards the corner.</summary>
internal static class PegTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0f, 0.9f), Count = 11, Height = (1f, 0.5f), Second = 0.85f, Fill = 0.9f, Stoutest = 0.62f, Curve = 0.1f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.88f), Count = 11, Height = (0.9f, 0.45f), Second = 0.85f, Fill = 0.9f, Stoutest = 0.62f, Curve = 0.1f },
        },
    };
}
