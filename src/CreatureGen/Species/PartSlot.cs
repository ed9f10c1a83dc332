using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>One part and how much its size varies.</summary>
internal readonly struct PartPreset
{
    public PartPreset(FeatureBlueprint part, double min, double max)
    {
        Part = part;
        Min = min;
        Max = max;
    }

    /// <summary>The part in its mean size, metres on a head of the table's size.</summary>
    public FeatureBlueprint Part { get; }

    /// <summary>Least factor on its length.</summary>
    public double Min { get; }

    /// <summary>Most factor on its length.</summary>
    public double Max { get; }
}

/// <summary>One of the things that a slot may hold: some parts that belong together, or none.</summary>
internal readonly struct PartChoice
{
    public PartChoice(double weight, params PartPreset[] parts)
    {
        Weight = weight;
        Parts = parts;
        Mane = null;
        Frill = null;
    }

    public double Weight { get; }

    public PartPreset[] Parts { get; }

    /// <summary>Hair that belongs to them.</summary>
    public ManePreset? Mane { get; init; }

    /// <summary>A collar that belongs to them.</summary>
    public FrillPreset? Frill { get; init; }

    /// <summary>Whether it leaves its slot empty.</summary>
    public bool IsEmpty => Parts.Length == 0 && Mane is null && Frill is null;
}

/// <summary>A place for at most one thing: a jaw, a pair of feelers, a crest. A choice without parts leaves it empty; how often depends on how many ornaments are asked for.</summary>
internal sealed class PartSlot
{
    public PartSlot(params PartChoice[] choices) => Choices = choices;

    public PartChoice[] Choices { get; }
}
