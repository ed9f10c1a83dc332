namespace CreatureGen.Anatomy.Teeth;

/// <summary>Mammals that graze: broad plates that bite at the front, a gap, and grinders behind it.</summary>
internal static class GrazerTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0f, 0.26f), Count = 3, Height = (0.95f, 0.75f), Fill = 0.97f, Stoutest = 0.9f, Depth = 0.5f, Edge = 1f },
            new ToothSet { Stretch = (0.45f, 0.88f), Count = 4, Height = (0.6f, 0.6f), Fill = 0.96f, Stoutest = 1.4f, Depth = 0.7f, Edge = 0.9f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.24f), Count = 3, Height = (1f, 0.8f), Fill = 0.97f, Stoutest = 0.9f, Depth = 0.5f, Edge = 1f },
            new ToothSet { Stretch = (0.45f, 0.86f), Count = 4, Height = (0.55f, 0.55f), Fill = 0.96f, Stoutest = 1.4f, Depth = 0.7f, Edge = 0.9f },
        },
    };
}
