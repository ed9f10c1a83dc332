namespace CreatureGen.Anatomy.Teeth;

/// <summary>Mammals that eat meat: small incisors, a fang on each side, and blades behind it. The lower fang stands ahead of the upper one.</summary>
internal static class CarnivoreTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0f, 0.15f), Count = 3, Height = (0.3f, 0.36f), Fill = 0.95f, Stoutest = 1f, Depth = 0.7f, Edge = 0.7f },
            new ToothSet { Stretch = (0.18f, 0.28f), Height = (1f, 1f), Fill = 1f, Stoutest = 0.42f, Depth = 0.9f, Curve = 0.16f },
            new ToothSet { Stretch = (0.33f, 0.86f), Count = 5, Height = (0.34f, 0.5f), Fill = 0.98f, Stoutest = 1.3f, Depth = 0.4f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.09f), Count = 3, Height = (0.26f, 0.3f), Fill = 0.95f, Stoutest = 1f, Depth = 0.7f, Edge = 0.7f },
            new ToothSet { Stretch = (0.1f, 0.19f), Height = (0.85f, 0.85f), Fill = 1f, Stoutest = 0.42f, Depth = 0.9f, Curve = 0.12f },
            new ToothSet { Stretch = (0.3f, 0.84f), Count = 5, Height = (0.32f, 0.46f), Fill = 0.98f, Stoutest = 1.3f, Depth = 0.4f },
        },
    };
}
