using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What the end of the tail wears: a tip, a fin with rays, or a fan of feathers.</summary>
internal sealed class TailCoat
{
    // How much darker the skin between the rays of a fin is, and its rear edge, and the ring from which on it darkens.
    private const float BetweenRays = 0.5f;
    private const float Margin = 0.3f;
    private const float MarginFirst = 51.5f;

    // How much of the coat of the body the edges of a fin keep that lead in the water, and from which part of its half span on.
    private const float Leading = 0.7f;
    private const float LeadFrom = 0.7f;

    // Feathers from the middle of a fan to its side, as its outline has them, and how much darker it is where one lies over the next: of one colour a fan is an apron from behind.
    private const float FeathersOfHalf = 2.5f;
    private const float BetweenVanes = 0.5f;

    /// <summary>Part of the shade of the belly that a tail with a sting is without: it is carried over the back, and its lower side, pale, is a mast for who is behind it.</summary>
    private const float Unshaded = 0.6f;

    private readonly CoatPalette palette;
    private readonly CoatSubject subject;
    private readonly Vector3 finColour;
    private readonly Vector3 tipColour;
    private readonly float tipFraction;

    public TailCoat(CoatPalette palette, CoatSubject subject, int patternSeed)
    {
        this.palette = palette;
        this.subject = subject;
        finColour = BladeCoat.FinColour(palette, patternSeed);
        float tip = CoatChoice.Of(patternSeed, CoatChoice.TailTip);
        tipColour = tip < 0.45f || subject.Tail == TailStyle.Stinger ? palette.Limb : palette.Belly;
        tipFraction = tip < 0.70f ? 0.85f : 0f;
    }

    /// <summary>The colour of a place of the trunk with the tail's own colours laid over <paramref name="colour"/>.</summary>
    public Vector3 Over(Vector3 colour, in SkinPlace place)
    {
        if (place.Ring < StationRing.TorsoLast)
        {
            return colour;
        }

        switch (subject.Tail)
        {
            case TailStyle.Plain:
            case TailStyle.Whip:
            case TailStyle.Paddle:
            case TailStyle.Club:
            case TailStyle.Prehensile:
            case TailStyle.Stinger:
            case TailStyle.Saurian:
                return Vec.Lerp(colour, tipColour, tipFraction * Between(place, 50, 53));
            case TailStyle.Feathers:
                float vanes = BetweenVanes * Between(place, 47, 50) * BladeCoat.Border(FeathersOfHalf * (float)Math.Abs(PortableMath.Sin(place.Around)));
                return Vec.Lerp(colour, palette.Limb * 0.85f, 0.85f * Between(place, 49, 52)) * (1f - vanes);
            default:
                float rays = TailRays.Has(subject.Tail) ? 1f - (BetweenRays * (float)TailRays.Between(place.Ring, place.Around)) : 1f;
                float margin = 1f - (Margin * Scalar.Smooth((place.Ring - MarginFirst) / (BodyGrid.Rings - 1 - MarginFirst)));
                float edge = (float)Math.Abs(subject.Tail == TailStyle.Fluke ? PortableMath.Sin(place.Around) : PortableMath.Cos(place.Around));
                float lead = 1f - (Leading * Scalar.Smooth((edge - LeadFrom) / (1f - LeadFrom)));
                return Vec.Lerp(colour, finColour, 0.85f * lead * Between(place, 47, 52)) * (rays * margin);
        }
    }

    /// <summary>What is left of the shade of the belly at a place of the trunk.</summary>
    public float ShadeAt(in SkinPlace place) => subject.Tail == TailStyle.Stinger ? 1f - (Unshaded * Between(place, StationRing.TorsoLast, StationRing.TailFirst + 2)) : 1f;

    private float Between(in SkinPlace place, int from, int to)
    {
        double[] arc = subject.Body.Arc;
        return Scalar.Smooth((float)((place.Arc - arc[from]) / (arc[to] - arc[from])));
    }
}
