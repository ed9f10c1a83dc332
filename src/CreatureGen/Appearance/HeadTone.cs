using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>By how much the coat of a head is darker or paler than that of the trunk: in one tone the two are one mass from ahead and from behind.</summary>
internal sealed class HeadTone
{
    // Lightness of a coat, as OKLCH has it, below which its head is paler, for eyes and lips are not seen in a darker one, and above which it is darker; between them it is either.
    private const double Dark = 0.5;
    private const double Light = 0.68;

    // By how much it is lighter, and by which share of its lightness darker, as OKLCH has it.
    private const double Paler = 0.11;
    private const double Darker = 0.22;

    /// <summary>The ring of the head from which on the tone gives way; at the base of the neck it is gone.</summary>
    private const float Whole = 13.5f;

    private readonly float gain;

    /// <summary>The tone that goes with a coat.</summary>
    public HeadTone(CoatBlueprint coat)
    {
        double lightness = Math.Max(0.1, coat.Base.Lightness);
        bool darker = Scalar.Clamp((lightness - Dark) / (Light - Dark), 0, 1) > CoatChoice.Of(coat.PatternSeed, CoatChoice.HeadTone);
        Lightness = lightness + (darker ? -Darker * lightness : Paler);

        // Light goes with the third power of lightness.
        double ratio = Lightness / lightness;
        gain = (float)(ratio * ratio * ratio);
    }

    /// <summary>Lightness of the coat of the head, as OKLCH has it.</summary>
    public double Lightness { get; }

    /// <summary>The colour of a place of the trunk at a ring, linear RGB; its pattern stays, and black and white are what they were.</summary>
    public Vector3 Over(Vector3 colour, float ring)
    {
        float more = (gain - 1f) * Scalar.Smooth((StationRing.NeckBase - ring) / (StationRing.NeckBase - Whole));
        return new Vector3(Toned(colour.X), Toned(colour.Y), Toned(colour.Z));

        float Toned(float channel) => channel * (1f + more) / (1f + (more * channel));
    }
}
