namespace CreatureGen.Anatomy.Teeth;

/// <summary>Sharks: a saw of flat triangles, edge to edge.</summary>
internal static class SawTeeth
{
    /// <summary>Its teeth.</summary>
    public static readonly Dentition Teeth = new()
    {
        Upper = new[]
        {
            new ToothSet { Stretch = (0f, 0.94f), Count = 9, Height = (1f, 0.5f), Fill = 1f, Stoutest = 1.15f, Depth = 0.3f, Curve = 0.2f },
        },
        Lower = new[]
        {
            new ToothSet { Stretch = (0f, 0.92f), Count = 9, Height = (0.85f, 0.45f), Fill = 0.95f, Stoutest = 0.95f, Depth = 0.3f, Curve = 0.2f },
        },
        Gum = 0.36f,
    };
}
