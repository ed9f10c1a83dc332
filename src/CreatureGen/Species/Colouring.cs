using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>A colour by lightness, chroma and hue in degrees.</summary>
internal readonly struct Tint
{
    public Tint(double lightness, double chroma, double hue)
    {
        Lightness = lightness;
        Chroma = chroma;
        Hue = hue;
    }

    public double Lightness { get; }

    public double Chroma { get; }

    public double Hue { get; }
}

/// <summary>A colouring that a species is known by. What is not set follows from the base.</summary>
internal sealed record Colouring(Tint Base)
{
    public Tint? Pattern { get; init; }

    /// <summary>Factor on the frequency of the pattern.</summary>
    public double Scale { get; init; } = 1;

    public PatternKind? Kind { get; init; }

    public Tint? Limb { get; init; }

    public Tint? Accent { get; init; }

    /// <summary>Whether an accent that is not set is drawn freely instead of following from the base.</summary>
    public bool KeepsAccent { get; init; }

    public Tint? Belly { get; init; }

    public Tint? Muzzle { get; init; }
}
