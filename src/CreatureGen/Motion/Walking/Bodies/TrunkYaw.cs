using System;
using System.Collections.Generic;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>What bounds how a trunk yaws with its feet, so that it does not take its hips off them.</summary>
/// <param name="Fraction">Share of its yaw with the feet that a body has, 0..1: on hips far from the middle a turn takes the feet farther than the legs step.</param>
/// <param name="MaxTogether">How far the whole trunk yaws from side to side with its feet at most, radians: what takes its ends a little way aside.</param>
internal readonly record struct TrunkYaw(float Fraction, float MaxTogether)
{
    /// <summary>How far the ends of a trunk that yaws with its feet go aside at most, leg lengths.</summary>
    private const float MaxEndSway = 0.1f;

    /// <summary>Distance of the hips from the middle, leg lengths, beyond which the body yaws less.</summary>
    private const float WideHips = 0.55f;

    /// <summary>The bounds of a body.</summary>
    /// <param name="legs">Its legs.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="trunkLength">Metres.</param>
    public static TrunkYaw Of(IEnumerable<LegRig> legs, float legLength, float trunkLength)
    {
        float widest = 0f;
        foreach (LegRig leg in legs)
        {
            widest = Math.Max(widest, Math.Abs(leg.HipRest.X));
        }

        return new TrunkYaw(Math.Min(1f, WideHips * legLength / Math.Max(widest, 1e-6f)), 2f * MaxEndSway * legLength / Math.Max(trunkLength, legLength));
    }

    /// <summary>Traits of a trunk that yaws by no more than its share.</summary>
    public TrunkTraits Of(TrunkTraits traits) => traits with { PelvisYaw = traits.PelvisYaw * Fraction, ChestYaw = traits.ChestYaw * Fraction };

    /// <summary>By how much both ends of a trunk together yaw too far, radians.</summary>
    /// <param name="together">The yaw that they have in common, radians.</param>
    public float Excess(float together) => together - Scalar.ClampSoftly(together, MaxTogether);
}
