using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>A place of the skin as patterns see it: the same for both sides of the body.</summary>
internal readonly struct PatternPlace
{
    /// <summary>Folds a place onto the left side.</summary>
    /// <param name="position">Rest position, model space, metres at scale 1; either side.</param>
    /// <param name="run">Metres along the body from the nose, or down a limb: what stripes and bands count.</param>
    /// <param name="around">Angle around the body, radians, 0 dorsal to π ventral.</param>
    public PatternPlace(Vector3 position, float run, float around)
    {
        Position = new Vector3(Math.Abs(position.X), position.Y, position.Z);
        Run = run;
        Around = around;
    }

    /// <summary>Rest position with x ≥ 0.</summary>
    public Vector3 Position { get; }

    /// <summary>Metres along the body or down a limb.</summary>
    public float Run { get; }

    /// <summary>Radians, 0 dorsal to π ventral.</summary>
    public float Around { get; }
}

/// <summary>Where the pattern colour of a coat shows, from 0 to 1, as a function of the place alone.</summary>
internal sealed class PatternField
{
    // Waves per metre of torso, radians.
    private const float StripeFrequency = 26f;
    private const float BandFrequency = 15f;

    /// <summary>Pairs of ribbons of a labyrinth per metre of torso.</summary>
    private const float WavesPerMetre = 8.5f;

    /// <summary>Of a rosette, in cells.</summary>
    private const float RingRadius = 0.46f;

    /// <summary>Difference of the two nearest distances, in cells, across half a seam of plates, and across the whole of its soft edge.</summary>
    private const float SeamWidth = 0.09f, SeamEdge = 0.10f;

    /// <summary>Width of the edge of a saddle, as the cosine of the angle around the body: a hard one is a painted cloth.</summary>
    private const float SaddleEdge = 0.5f;

    /// <summary>Odd, so that the marks of no two individuals are those of another species' pattern a few steps on.</summary>
    private const int MarkStep = 0x2545F491;

    /// <summary>Shifts of stripes and bands along the body.</summary>
    private const int PhaseSteps = 1024;

    private readonly PatternKind kind;
    private readonly float scale;
    private readonly ValueNoise coarseClouds;
    private readonly ValueNoise fineClouds;
    private readonly ValueNoise waver;
    private readonly WorleyNoise scatter;
    private readonly float phase;
    private readonly RandomWaves? waves;

    /// <summary>Chooses the pattern.</summary>
    /// <param name="kind">What it looks like.</param>
    /// <param name="scale">Factor on its frequency.</param>
    /// <param name="seed">Which one of its kind.</param>
    /// <param name="marks">Which arrangement of its marks.</param>
    public PatternField(PatternKind kind, double scale, int seed, int marks)
    {
        this.kind = kind;
        this.scale = (float)scale;
        int salt = unchecked((seed * 16) + (marks * MarkStep));
        coarseClouds = new ValueNoise(salt);
        fineClouds = new ValueNoise(salt + 1);
        scatter = new WorleyNoise(salt + 2);
        waver = new ValueNoise(salt + (kind == PatternKind.Stripes ? 3 : 4));
        phase = (float)PortableMath.Tau * (marks % PhaseSteps) / PhaseSteps;
        waves = kind == PatternKind.Turing ? new RandomWaves(WavesPerMetre * this.scale, salt + 5) : null;
    }

    /// <summary>Share of the pattern colour at a place, 0..1.</summary>
    public float At(in PatternPlace place)
    {
        switch (kind)
        {
            case PatternKind.Plain:
                return 0.30f * Scalar.Smooth((Clouds(place, 4.5f, 11f, 0.65f) - 0.46f) / 0.30f);
            case PatternKind.Spots:
                return Spots(place);
            case PatternKind.Stripes:
                return Stripes(place);
            case PatternKind.Bands:
                return Bands(place);
            case PatternKind.Patches:
                return Scalar.Smooth((Clouds(place, 3.2f, 7f, 0.65f) - 0.505f) / 0.07f);
            case PatternKind.Mottle:
                return 0.85f * Scalar.Smooth((Clouds(place, 8f, 18f, 0.55f) - 0.42f) / 0.24f);
            case PatternKind.Saddle:
                return Saddle(place);
            case PatternKind.Rosettes:
                return Rosettes(place);
            case PatternKind.Giraffe:
                return Scalar.Smooth((scatter.Gap(place.Position * (4.2f * scale), SeamWidth + SeamEdge) - SeamWidth) / SeamEdge);
            case PatternKind.Turing:
                return Scalar.Smooth(0.5f + (1.6f * waves!.At(place.Position)));
            default:
                throw new InvalidOperationException("pattern kind " + kind + " is not known; expected one of " + nameof(PatternKind));
        }
    }

    private float Clouds(in PatternPlace place, float coarse, float fine, float fraction) =>
        (fraction * coarseClouds.At(place.Position * (coarse * scale))) + ((1f - fraction) * fineClouds.At(place.Position * (fine * scale)));

    private float Spots(in PatternPlace place)
    {
        NearestPoint point = scatter.Nearest(place.Position * (7.5f * scale));

        // A quarter of the cells stay empty; the others differ in size.
        if (point.Value < 0.25f)
        {
            return 0f;
        }

        float radius = 0.30f + (0.20f * point.Value);
        return Scalar.Smooth((radius + 0.03f - point.Distance) / 0.15f);
    }

    // A ring around each point, broken in up to four places, and in its middle a share of the pattern colour: warmer and darker than the coat.
    private float Rosettes(in PatternPlace place)
    {
        NearestPoint point = scatter.Nearest(place.Position * (5.5f * scale));
        float distance = point.Distance;
        float fraction = 0.36f * Scalar.Smooth((RingRadius - distance) / 0.08f);
        float ring = Scalar.Smooth((0.145f - Math.Abs(distance - RingRadius)) / 0.08f);
        if (ring > fraction)
        {
            fraction = Math.Max(fraction, ring * Scalar.Smooth((Math.Abs(point.Lobes) - 0.02f) / 0.08f));
        }

        return fraction * Scalar.Smooth(point.Margin / 0.07f);
    }

    private float Stripes(in PatternPlace place)
    {
        float bend = waver.At(place.Position * (4f * scale));
        float wave = (float)PortableMath.Sin((place.Run * StripeFrequency * scale) + (4.5f * bend) + (0.8f * (float)PortableMath.Sin(place.Around)) + phase);

        // Stripes narrow towards the belly, and some break off earlier than others.
        float taper = 0.55f * Scalar.Smooth((place.Around - 1.2f) / 1.3f) * (0.5f + bend);
        return Scalar.Smooth((wave - 0.15f - taper) / 0.40f);
    }

    private float Bands(in PatternPlace place)
    {
        float bend = waver.At(place.Position * (3f * scale));
        float wave = (float)PortableMath.Sin((place.Run * BandFrequency * scale) + (1.2f * bend) + phase);
        return Scalar.Smooth((wave - 0.10f) / 0.30f);
    }

    private float Saddle(in PatternPlace place)
    {
        float ragged = Clouds(place, 5f, 14f, 0.7f) - 0.5f;
        float tips = fineClouds.At(place.Position * (42f * scale)) - 0.5f;
        float height = (float)PortableMath.Cos(place.Around);
        return Scalar.Smooth((height - 0.05f + (0.75f * ragged) + (0.3f * tips)) / SaddleEdge);
    }
}
