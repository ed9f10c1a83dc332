using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Strokes.Swimming;

/// <summary>How a creature swims, worked out once from its build: its style, its wave, its fins and the tempo of its size. Immutable, and safe to share between threads.</summary>
public sealed class SwimProfile
{
    /// <summary>Share of a joint's range that the wave at its widest may take; the rest is for turns.</summary>
    private const double LimitShare = 0.84;

    /// <summary>Bodies longer than so many widths swim like eels when their plan does not say how they swim.</summary>
    private const double SlenderBody = 9;

    /// <summary>Area of paired fins, in squared body lengths, above which such a body flies on them.</summary>
    private const double LargeFins = 0.1;

    private readonly SwimFin[] fins;
    private readonly MedianFin[] medianFins;

    private SwimProfile(Creature creature, AxialChain chain, SwimStyle style)
    {
        Chain = chain;
        Skeleton = creature.Skeleton;
        Style = style;
        Kinematics = SwimKinematics.Of(style);
        BodyLength = (float)chain.Length;
        Wave = new SwimWave(chain, style, Kinematics);
        Wave.Scale(RoomForWave(creature.Skeleton, chain, Wave, style));
        Curl = RoomForCurl(creature.Skeleton, chain);
        double frequency = Kinematics.Frequency(chain.Length);
        CruiseFrequency = (float)frequency;
        Fitting(creature, out fins, out medianFins);
        TailBeat = (float)(2 * Wave.TailReach);
        if (style == SwimStyle.Flippers)
        {
            // Flippers do the work of the tail.
            foreach (SwimFin fin in fins)
            {
                TailBeat = Math.Max(TailBeat, (float)fin.TipWay);
            }
        }

        CruiseSpeed = (float)(frequency * TailBeat / Kinematics.Strouhal);
    }

    /// <summary>What drives it.</summary>
    public SwimStyle Style { get; }

    /// <summary>From nose to tail, metres.</summary>
    public float BodyLength { get; }

    /// <summary>Beats per second at cruise.</summary>
    public float CruiseFrequency { get; }

    /// <summary>Metres per second at cruise.</summary>
    public float CruiseSpeed { get; }

    /// <summary>From side to side of the tail's tip (of a flipper's, for swimmers that row) at cruise, metres.</summary>
    public float TailBeat { get; }

    internal Skeleton Skeleton { get; }

    internal AxialChain Chain { get; }

    /// <summary>Bend of the whole body at the height of a C-start, radians.</summary>
    internal double Curl { get; }

    internal SwimKinematics Kinematics { get; }

    internal SwimWave Wave { get; }

    internal ReadOnlySpan<SwimFin> Fins => fins;

    internal ReadOnlySpan<MedianFin> MedianFins => medianFins;

    /// <summary>Works out how a creature swims. Any creature can: those not built for it swim as their shape allows.</summary>
    /// <exception cref="ArgumentException">The skeleton lacks a body, a head or a tail.</exception>
    public static SwimProfile Of(Creature creature)
    {
        if (creature == null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        AxialChain chain = AxialChain.Of(creature);
        return new SwimProfile(creature, chain, StyleOf(creature, chain));
    }

    private static SwimStyle StyleOf(Creature creature, AxialChain chain)
    {
        switch (creature.Blueprint.Plan)
        {
            case BodyPlan.Fish:
                return SwimStyle.Carangiform;
            case BodyPlan.Eel:
            case BodyPlan.Legless:
                return SwimStyle.Anguilliform;
            case BodyPlan.Whale:
                return SwimStyle.Cetacean;
            case BodyPlan.Flipper:
                return SwimStyle.Flippers;
        }

        double fins = 0;
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Kind == LimbKind.Pectoral)
            {
                double span = Span(limb);
                fins += 0.4 * span * span;
            }
        }

        return creature.Blueprint.Tail.Style == TailStyle.Fluke ? SwimStyle.Cetacean
            : fins > LargeFins * chain.Length * chain.Length ? SwimStyle.Flippers
            : chain.Length > SlenderBody * 2 * creature.Body.Radius ? SwimStyle.Anguilliform
            : SwimStyle.Carangiform;
    }

    /// <summary>Factor by which the wave has to narrow for all joints to stay within their limits.</summary>
    private static double RoomForWave(Skeleton skeleton, AxialChain chain, SwimWave wave, SwimStyle style)
    {
        double factor = 1;
        for (int b = 0; b + 1 < chain.Count; b++)
        {
            // The joint between two bones is that of the one carried by the other.
            ReadOnlySpan<AxialBone> bones = chain.Bones;
            int child = bones[b + 1].Parent == b ? b + 1 : b;
            JointLimit limit = skeleton.Joints[bones[child].Turn.Joint].Limit;
            AngleRange range = style == SwimStyle.Cetacean ? limit.SwingX : limit.SwingZ;
            double most = Math.Min(range.Max, -range.Min);

            // The bend grows faster than the width: a few steps of the rule of three settle it.
            for (int pass = 0; pass < 4; pass++)
            {
                double bend = wave.Bend(b, factor * SwimMotion.WidestBeat);
                factor *= Math.Min(1, LimitShare * most / Math.Max(bend, 1e-9));
            }
        }

        for (int b = 0; b < chain.Count; b++)
        {
            factor = Math.Min(factor, SwimWave.Steepest / (SwimMotion.WidestBeat * wave.Steepness(b)));
        }

        return factor;
    }

    /// <summary>Deepest bend from nose to tail, spread evenly, that leaves all joints within their limits.</summary>
    private static double RoomForCurl(Skeleton skeleton, AxialChain chain)
    {
        double most = EscapeCurve.Curl;
        for (int b = 0; b + 1 < chain.Count; b++)
        {
            ReadOnlySpan<AxialBone> bones = chain.Bones;
            int child = bones[b + 1].Parent == b ? b + 1 : b;
            AngleRange range = skeleton.Joints[bones[child].Turn.Joint].Limit.SwingZ;
            double share = (bones[b].Middle.Z - bones[b + 1].Middle.Z) / chain.Length;
            most = Math.Min(most, LimitShare * Math.Min(range.Max, -range.Min) / Math.Max(share, 1e-6));
        }

        return most;
    }

    private static double Span(LimbChain limb)
    {
        double span = 0;
        foreach (float bone in limb.RestLengths)
        {
            span += bone;
        }

        return span;
    }

    private void Fitting(Creature creature, out SwimFin[] paired, out MedianFin[] median)
    {
        var pairs = new List<SwimFin>();
        var singles = new List<MedianFin>();
        foreach (LimbChain limb in creature.Limbs)
        {
            float at = (Chain.Nose.Z - creature.Skeleton.ModelPositions[limb.Joints[0]].Z) / BodyLength;
            if (limb.Kind == LimbKind.Pectoral && PairedChain.Of(creature, limb) is { } chain)
            {
                pairs.Add(new SwimFin(chain, at));
            }
            else if (limb.Kind is LimbKind.Dorsal or LimbKind.Ventral)
            {
                singles.Add(new MedianFin(creature.Skeleton, limb, at));
            }
        }

        paired = pairs.ToArray();
        median = singles.ToArray();
    }
}
