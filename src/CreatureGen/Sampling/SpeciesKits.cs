using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>A place of a species' own for a pair of legs.</summary>
internal readonly struct LegSite
{
    public LegSite(LimbArchetype archetype, int ring, double segment, double azimuth, double reach, double thickness)
    {
        Archetype = archetype;
        Ring = ring;
        Segment = segment;
        Azimuth = azimuth;
        Reach = reach;
        Thickness = thickness;
    }

    public LimbArchetype Archetype { get; }

    /// <summary>Ring of its centre.</summary>
    public int Ring { get; }

    /// <summary>Segment of its centre.</summary>
    public double Segment { get; }

    /// <summary>Turn towards the front, radians.</summary>
    public double Azimuth { get; }

    /// <summary>Factor on the reach of the creature's legs.</summary>
    public double Reach { get; }

    /// <summary>Factor on their thickness.</summary>
    public double Thickness { get; }
}

/// <summary>Legs of a species' own, all of which it always has.</summary>
internal sealed record LegKit
{
    /// <summary>Legs that stand, or hang under a swimmer, front to rear.</summary>
    public LegSite[] Sites { get; init; } = Array.Empty<LegSite>();

    /// <summary>Limbs that hang in front of it too.</summary>
    public LegSite[] Arms { get; init; } = Array.Empty<LegSite>();

    /// <summary>Unit of the outward shape, metres.</summary>
    public (double Least, double Most) Reach { get; init; }

    /// <summary>Height of the belly above the ground of one that stands, metres.</summary>
    public (double Least, double Most) Height { get; init; }

    /// <summary>Radius of the root, metres.</summary>
    public double Thickness { get; init; }

    /// <summary>Factor on the height of the knees.</summary>
    public double KneeRise { get; init; } = 1;

    /// <summary>Length of the claws in radii of the tip.</summary>
    public double Claw { get; init; } = 1.2;

    /// <summary>Fewest and most toes where there are any.</summary>
    public (int Least, int Most) Toes { get; init; } = (4, 4);

    /// <summary>Length of a hanging leg, metres.</summary>
    public double HangingLength { get; init; } = 0.26;
}

/// <summary>Proportions of a bird.</summary>
internal sealed record BirdKit
{
    /// <summary>Height of the hip relative to the length of the torso.</summary>
    public (double Least, double Most) HipHeight { get; init; }

    /// <summary>Radius of the thigh relative to half the torso's depth.</summary>
    public (double Least, double Most) Thigh { get; init; }

    public int Toes { get; init; } = 3;

    /// <summary>Factor on the feet.</summary>
    public double Foot { get; init; } = 1;

    public double Claw { get; init; } = 0.8;

    /// <summary>Segment of the hips.</summary>
    public double HipSegment { get; init; } = 10.1;

    /// <summary>Ring that the tip of the folded wing reaches.</summary>
    public double FoldRing { get; init; } = 46;

    /// <summary>Half width of the tail's feathers, metres; 0 for a plain tail.</summary>
    public double Fan { get; init; } = 0.11;

    /// <summary>Tilt of the torso and the tail in flight, degrees.</summary>
    public (double Torso, double Tail) FlightPitch { get; init; }
}

/// <summary>A pair of thin wings.</summary>
internal readonly struct ThinWing
{
    public ThinWing(double ring, double length, double width, double azimuth, double elevation)
    {
        Ring = ring;
        Length = length;
        Width = width;
        Azimuth = azimuth;
        Elevation = elevation;
    }

    public double Ring { get; }

    /// <summary>Metres; varies by a tenth.</summary>
    public double Length { get; }

    /// <summary>Metres.</summary>
    public double Width { get; }

    /// <summary>Degrees towards the front from straight out.</summary>
    public double Azimuth { get; }

    /// <summary>Degrees above the level plane.</summary>
    public double Elevation { get; }
}

/// <summary>The thin wings of a species: as its fliers spread them and as its walkers carry them.</summary>
internal sealed record ThinWings
{
    public ThinWing[] Spread { get; init; } = Array.Empty<ThinWing>();

    public ThinWing[] Folded { get; init; } = Array.Empty<ThinWing>();
}

/// <summary>A fin or pair of fins of a species' own.</summary>
internal readonly struct FinSiteKit
{
    public FinSiteKit(FinPlace place, FinStyle style, int ring, double segment, int rows, (double Least, double Most) length, (double Least, double Most) width, double drop, double sweep)
    {
        Place = place;
        Style = style;
        Ring = ring;
        Segment = segment;
        Rows = rows;
        Length = length;
        Width = width;
        Drop = drop;
        Sweep = sweep;
    }

    public FinPlace Place { get; }

    public FinStyle Style { get; }

    /// <summary>First ring of a fin on the midline, middle ring of a pair.</summary>
    public int Ring { get; }

    /// <summary>Segment of the middle of a pair.</summary>
    public double Segment { get; }

    public int Rows { get; }

    /// <summary>Metres.</summary>
    public (double Least, double Most) Length { get; }

    /// <summary>Depth of a paired fin relative to its length.</summary>
    public (double Least, double Most) Width { get; }

    public double Drop { get; }

    public double Sweep { get; }
}

/// <summary>The fins and the tail of a species.</summary>
internal sealed record FinKit
{
    public FinSiteKit[] Fins { get; init; } = Array.Empty<FinSiteKit>();

    public TailStyle Tail { get; init; }

    /// <summary>Metres.</summary>
    public (double Least, double Most) TailSize { get; init; }

    public (double Least, double Most) TailFork { get; init; }

    public double TailLobe { get; init; }
}

/// <summary>One part and how much its size varies.</summary>
internal readonly struct PartKit
{
    public PartKit(FeatureBlueprint part, double least, double most)
    {
        Part = part;
        Least = least;
        Most = most;
    }

    /// <summary>The part in its mean size, metres on a head of the table's size.</summary>
    public FeatureBlueprint Part { get; }

    /// <summary>Least factor on its length.</summary>
    public double Least { get; }

    /// <summary>Most factor on its length.</summary>
    public double Most { get; }
}

/// <summary>One of the things that a slot may hold: some parts that belong together, or none.</summary>
internal readonly struct PartChoice
{
    public PartChoice(double weight, params PartKit[] parts)
    {
        Weight = weight;
        Parts = parts;
        Mane = null;
        Frill = null;
    }

    public double Weight { get; }

    public PartKit[] Parts { get; }

    /// <summary>Hair that belongs to them.</summary>
    public ManeKit? Mane { get; init; }

    /// <summary>A collar that belongs to them.</summary>
    public FrillKit? Frill { get; init; }

    /// <summary>Whether it leaves its slot empty.</summary>
    public bool IsEmpty => Parts.Length == 0 && Mane is null && Frill is null;
}

/// <summary>A place for at most one thing: a jaw, a pair of feelers, a crest. A choice without parts leaves it empty; how often depends on how many ornaments are asked for.</summary>
internal sealed class PartSlot
{
    public PartSlot(params PartChoice[] choices) => Choices = choices;

    public PartChoice[] Choices { get; }
}

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
