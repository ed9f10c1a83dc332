using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>Draws hair and collars: those of the families, and any preset in the size of its wearer.</summary>
internal static class NeckSampler
{
    /// <summary>Metres between hanging hair and the ground.</summary>
    private const double Clearance = 0.05;

    /// <summary>Length of the longest lock of a row in lengths of its mane.</summary>
    private const double LongestLock = 1.2;

    /// <summary>Rise up to which hair lies on the skin, radians.</summary>
    private const double LyingHair = 0.25;

    // How far hair hangs down in the water, turns off the way to the tail and leaves the skin, in what it does on land: it trails behind what swims.
    private const double HangsInWater = 0.35;
    private const double FallsInWater = 0.4;
    private const double RisesInWater = 0.6;

    // How hair that is too long is cut.
    private const double Shortening = 0.88;
    private const int MaxCuts = 20;

    /// <summary>Hair that would have to be cut shorter than this is left out, metres.</summary>
    private const double MinHair = 0.02;

    /// <summary>First ring of a swimmer's tail that a fin sits on.</summary>
    private const double TailFinRing = 50;

    /// <summary>Places along a collar that are held against the ground.</summary>
    private const int FrillSteps = 12;

    // Least tilt of a collar in the water, radians, and its length there in that on land.
    private const double LaidBackTilt = 0.7;
    private const double LaidBackLength = 0.85;

    /// <summary>Half the width of a head relative to half its height beyond which a collar grows no further: on rays it would be larger than the body.</summary>
    private const double WidestCollared = 1.4;

    /// <summary>The hair that furred families wear now and then; whether there is any.</summary>
    public static bool Hair(CreatureBuilder builder, double plenty, RandomStream random)
    {
        bool hoofed = builder.Parents.Ornaments.FallingMane > 0 && builder.Plan is BodyPlan.Unguligrade or BodyPlan.Centaur;
        double chance = builder.Kind == LocomotionKind.Swimming ? 0 : hoofed ? builder.Parents.Ornaments.FallingMane : builder.Parents.Ornaments.Hair.Chance;
        double size = random.Uniform();
        bool ruffed = random.Chance(builder.Parents.Ornaments.Hair.Ruff);
        if (!random.Chance(chance * plenty))
        {
            return false;
        }

        Add(builder, hoofed ? NeckPresets.Falling : ruffed ? NeckPresets.Ruff : NeckPresets.Bristles, size);
        return true;
    }

    /// <summary>The collar that lizards wear now and then; whether there is one.</summary>
    public static bool Collar(CreatureBuilder builder, double plenty, RandomStream random)
    {
        bool fits = builder.Kind == LocomotionKind.Walking && builder.Ears.Count == 0;
        bool bony = random.Chance(builder.Plan is BodyPlan.Plantigrade ? 0.6 : 0.25);
        double size = random.Uniform();
        if (!random.Chance(builder.Parents.Ornaments.Collar * plenty) || !fits)
        {
            return false;
        }

        Add(builder, bony ? NeckPresets.Shield : NeckPresets.Fan, size);
        return true;
    }

    /// <summary>The hair of a furred tail that ends as its parent's does; none that stands off where wings fold onto its root.</summary>
    public static void Tail(CreatureBuilder builder, RandomStream random)
    {
        double size = random.Uniform();
        bool furred = builder.Parents.Skin.Cover == SkinCover.Fur || builder.Parents.Skin == builder.Parents.Tail;
        if (builder.Parents.Tail.TailHair is ManePreset hair && furred && builder.Tail.Style == TailStyle.Plain && !(builder.Wings.Count > 0 && Array.Exists(hair.Fields, StandsOff)))
        {
            Add(builder, hair, size, builder.Shape.Arc[StationRing.TailTip] - builder.Shape.Arc[StationRing.TorsoLast]);
        }
    }

    private static bool StandsOff(ManeBlueprint mane) => mane.Ring < StationRing.TailThird && mane.Rise > LyingHair;

    /// <summary>Adds hair of the neck; <paramref name="size"/> 0..1 goes from its least length to its most.</summary>
    public static void Add(CreatureBuilder builder, in ManePreset preset, double size) => Add(builder, preset, size, builder.HalfDepth(StationRing.NeckMiddle));

    private static void Add(CreatureBuilder builder, in ManePreset preset, double size, double unit)
    {
        double factor = Scalar.Lerp(preset.Min, preset.Max, size);
        foreach (ManeBlueprint mane in preset.Fields)
        {
            ManeBlueprint worn = builder.Kind == LocomotionKind.Swimming ? Trailing(mane) : mane;
            ManeBlueprint cut = OffGround(builder, worn with { Length = mane.Length * factor * unit, Width = mane.Width * Math.Sqrt(factor) * unit });
            if (cut.Length >= MinHair && !LiesUnder(builder, cut) && !HangsFromFin(builder, cut))
            {
                builder.Manes.Add(cut);
            }
        }
    }

    /// <summary>Hair as water lays it back: falling down the flanks or over the face it is a row of stiff strips on what swims.</summary>
    private static ManeBlueprint Trailing(ManeBlueprint mane) =>
        mane with { Hang = HangsInWater * mane.Hang, Fall = FallsInWater * mane.Fall, Rise = RisesInWater * mane.Rise };

    /// <summary>Adds a collar; <paramref name="size"/> 0..1 goes from its least length to its most. The edge of a disc would cut through it, and in the water it is laid back.</summary>
    public static void Add(CreatureBuilder builder, in FrillPreset preset, double size)
    {
        if (builder.Species.Disc.Sweep != 0)
        {
            return;
        }

        bool swims = builder.Kind == LocomotionKind.Swimming;
        FrillBlueprint frill = swims ? preset.Frill with { Tilt = Math.Max(preset.Frill.Tilt, LaidBackTilt), Length = LaidBackLength * preset.Frill.Length } : preset.Frill;
        double unit = Math.Min(builder.Shape.Width[StationRing.Cranium], WidestCollared * builder.HalfDepth(StationRing.Cranium));
        builder.Frills.Add(OffGround(builder, frill with { Length = frill.Length * Scalar.Lerp(preset.Min, preset.Max, size) * unit, Thickness = frill.Thickness * unit }));
    }

    /// <summary>Hair of what stands, shortened until what hangs from its tail or its throat clears the ground.</summary>
    public static ManeBlueprint OffGround(CreatureBuilder builder, ManeBlueprint mane)
    {
        if (!builder.IsOnGround || mane.LastSegment <= BodyGrid.Segments / 4)
        {
            return mane;
        }

        for (int attempt = 0; attempt < MaxCuts && !Clears(builder.Shape, mane); attempt++)
        {
            mane = mane with { Length = Shortening * mane.Length };
        }

        return mane;
    }

    /// <summary>A collar of what stands, shortened until it clears the ground.</summary>
    public static FrillBlueprint OffGround(CreatureBuilder builder, FrillBlueprint frill)
    {
        if (!builder.IsOnGround)
        {
            return frill;
        }

        BodyShape s = builder.Shape;
        int ring = (int)frill.Ring;
        double sin = PortableMath.Sin(s.Pitch[ring]);
        double cos = PortableMath.Cos(s.Pitch[ring]);
        double longest = frill.Length;
        for (int k = 0; k <= FrillSteps; k++)
        {
            double across = (double)k / FrillSteps;
            double around = PortableMath.Cos(PortableMath.Tau * frill.Spread * across / BodyGrid.Segments);
            double root = s.Y[ring] + (around * cos * (around > 0 ? s.Top[ring] : s.Bottom[ring]));
            double fall = FrillOutline.HeightAt(across) * ((sin * PortableMath.Sin(frill.Tilt)) - (around * cos * PortableMath.Cos(frill.Tilt)));
            longest = fall > 0 ? Math.Min(longest, Math.Max(root - Clearance, 0.2 * s.Bottom[ring]) / fall) : longest;
        }

        return frill with { Length = longest };
    }

    /// <summary>Whether hair grows from below a body that lies on the ground.</summary>
    private static bool LiesUnder(CreatureBuilder builder, ManeBlueprint mane) =>
        builder.Plan == BodyPlan.Legless && mane.LastSegment > BodyGrid.Segments / 4 && BodyShaper.Lying(builder.Plan, (int)mane.LastRing) > 0;

    /// <summary>Whether hair grows where a tail fin does: it would hang over its edge like icicles.</summary>
    private static bool HangsFromFin(CreatureBuilder builder, ManeBlueprint mane) => builder.Kind == LocomotionKind.Swimming && mane.LastRing >= TailFinRing;

    /// <summary>Whether the lowest hair of every row ends above the ground: as far along the body as it is long, and below the body by what it stands off and hangs down.</summary>
    private static bool Clears(BodyShape s, ManeBlueprint mane)
    {
        const int end = BodyGrid.Rings - 1;
        for (int row = 0; row < mane.Rows; row++)
        {
            double along = mane.Rows > 1 ? row / (mane.Rows - 1.0) : 0;
            double length = LongestLock * mane.Length * Scalar.Lerp(1, mane.Growth, along);
            double below = length * (mane.Hang + (0.5 * PortableMath.Sin(mane.Rise)));
            int first = (int)Scalar.Lerp(mane.Ring, mane.LastRing, along);
            int ring = first;
            double lowest = double.MaxValue;
            for (; ring < end && s.Arc[ring] < s.Arc[first] + length; ring++)
            {
                lowest = Math.Min(lowest, s.Y[ring] - s.Bottom[ring]);
            }

            double beyond = Math.Max(0, s.Arc[first] + length - s.Arc[end]);
            lowest = Math.Min(lowest, s.Y[ring] - s.Bottom[ring] - beyond);
            if (lowest - below < Clearance)
            {
                return false;
            }
        }

        return true;
    }
}
