namespace CreatureGen.Anatomy.Teeth;

/// <summary>Snakes: a long fang on each side that leans back, and small hooks behind it.</summary>
internal static class FangTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0.14f, 0.26f), Height = (1f, 1f), Fill = 0.7f, Stoutest = 0.26f, Depth = 1f, Curve = 0.3f },
            new ToothSet { Stretch = (0.34f, 0.86f), Count = 6, Height = (0.3f, 0.24f), Fill = 0.6f, Stoutest = 0.45f, Curve = 0.3f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0.05f, 0.82f), Count = 9, Height = (0.32f, 0.22f), Fill = 0.6f, Stoutest = 0.45f, Curve = 0.3f },
        },
        Gum = 0.2f,
    };
}
