using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Legs out to the sides of a body that rolls over onto its back: drawn in from where they are folded, as little as they can out of the outline of its trunk, which would climb over them.</summary>
internal sealed class FoldToTrunk : FoldTrial
{
    /// <summary>What a leg costs that stands out of the trunk, for each leg length, and where that is looked at: where the ground is on the way from belly to back.</summary>
    private const float OutsideCost = 3f;
    private const float Diagonal = 0.70710678f;
    private static readonly Vector3[] turnedOver = { new(Diagonal, -Diagonal, 0f), Vector3.UnitX, new(Diagonal, Diagonal, 0f), Vector3.UnitY };

    /// <summary>In how many steps the ways there and from there are looked at, how far a bone turns in one before it whirls, radians, and what it costs beyond, for each radian.</summary>
    private const int WhirlSteps = 8;
    private const float EvenTurn = 0.4f;
    private const float WhirlCost = 4f;

    /// <summary>In which steps a leg that would whirl is drawn in less.</summary>
    private const float ShareStep = 0.25f;

    private readonly BonePoints trunk;
    private readonly float[] shown = new float[Act.ChannelCount];
    private readonly float[] tried = new float[FoldManner.Count];
    private readonly float[] whole = new float[FoldManner.Count];

    public FoldToTrunk(ActBody body, ActStage stage, FoldedLegs legs, (int Left, int Right) pair)
        : base(body, stage, legs.DrawnIn, pair, new float[Act.ChannelCount], Folded(body, body.Legs!.Legs[pair.Left], legs))
    {
        trunk = body.Skin.Of(joint => Array.IndexOf(body.Legs.Trunk, joint) >= 0);
        Turn(1f, 0f, Values);
    }

    /// <summary>Where a leg is folded, by the numbers of the search.</summary>
    public static float[] Folded(ActBody body, LegRig leg, FoldedLegs legs) => NumbersOf(legs.Folded, leg, Array.IndexOf(body.Legs!.Legs, leg));

    protected override float CostThere(Vector3 asked)
    {
        float sum = 0f;
        foreach (Vector3 direction in turnedOver)
        {
            sum += Math.Max(0f, Skin.Farthest(direction, Stage.Model) - trunk.Farthest(direction, Stage.Model));
        }

        return OutsideCost * sum / Leg.Length;
    }

    /// <summary>Draws a leg that would whirl on its way in less far.</summary>
    public override float Settle(float[] found, float cost)
    {
        float min = float.MaxValue;
        found.CopyTo(whole, 0);
        for (float share = 1f; share >= 0f; share -= ShareStep)
        {
            for (int number = 0; number < tried.Length; number++)
            {
                tried[number] = Scalar.Lerp(From[number], whole[number], share);
            }

            float all = Cost(tried) + (WhirlCost * Whirl());
            if (all < min)
            {
                min = all;
                tried.CopyTo(found, 0);
            }
        }

        return min;
    }

    /// <summary>How abruptly the leg turns on its way from where it is folded to where it is drawn in, and from there to where it hangs over a body on its back, radians.</summary>
    private float Whirl()
    {
        float sum = 0f;
        Quaternion thigh = default;
        Quaternion shank = default;
        for (int step = 0; step <= 2 * WhirlSteps; step++)
        {
            float way = (float)step / WhirlSteps;
            Turn(Math.Min(way, 1f), Math.Max(way - 1f, 0f), shown);
            Stage.Show(shown);
            (Quaternion thighBefore, Quaternion shankBefore) = (thigh, shank);
            (thigh, shank) = (Stage.Model.Rotations[Leg.Hip], Stage.Model.Rotations[Leg.Knee]);
            sum += step == 0 ? 0f : Math.Max(0f, Math.Max((float)Rotation.AngleBetween(thighBefore, thigh), (float)Rotation.AngleBetween(shankBefore, shank)) - EvenTurn);
        }

        return sum;
    }

    /// <summary>Fills the channels of a body that tips over.</summary>
    /// <param name="tipped">How far its legs are drawn in, 0..1.</param>
    /// <param name="unfolded">How far they come up from there, 0..1.</param>
    /// <param name="values">Of the channels.</param>
    private static void Turn(float tipped, float unfolded, float[] values)
    {
        values[(int)ActChannel.OnFlank] = ActLayer.DrawnIn * tipped;
        values[(int)ActChannel.ForeFold] = values[(int)ActChannel.HindFold] = 1f - unfolded;
        values[(int)ActChannel.ForeDown] = values[(int)ActChannel.HindDown] = LyingSide.DownAsItTurns * (1f - unfolded);
    }
}
