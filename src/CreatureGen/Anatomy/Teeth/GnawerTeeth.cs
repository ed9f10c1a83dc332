namespace CreatureGen.Anatomy.Teeth;

/// <summary>Mammals that gnaw: two chisels in either jaw, a gap, and small grinders behind it.</summary>
internal static class GnawerTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0f, 0.15f), Height = (1f, 1f), Fill = 0.95f, Stoutest = 0.5f, Depth = 0.6f, Edge = 0.9f, Curve = 0.1f },
            new ToothSet { Stretch = (0.5f, 0.85f), Count = 3, Height = (0.28f, 0.28f), Fill = 0.95f, Stoutest = 1.4f, Depth = 0.7f, Edge = 0.9f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.13f), Height = (0.9f, 0.9f), Fill = 0.95f, Stoutest = 0.45f, Depth = 0.6f, Edge = 0.9f, Curve = 0.1f },
            new ToothSet { Stretch = (0.5f, 0.85f), Count = 3, Height = (0.26f, 0.26f), Fill = 0.95f, Stoutest = 1.4f, Depth = 0.7f, Edge = 0.9f },
        },
    };
}
