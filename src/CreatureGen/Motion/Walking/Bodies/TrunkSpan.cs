using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>Where the joints at the ends of a trunk are seen from the feet: 0 over the middle of the hind feet, 1 over that of the fore feet. The trunk goes with the slope under its feet.</summary>
internal readonly struct TrunkSpan
{
    /// <summary>Part of the way from the middle of the feet to the hips that the root of a body on two legs goes on a slope: wholly over its hips it falls behind on stairs, over its feet these come deeper into the risers.</summary>
    private const float HipsOfTwoLegs = 0.4f;

    private TrunkSpan(float rear, float front, float hips, float hind, float fore)
    {
        Rear = rear;
        Front = front;
        Hips = hips;
        Hind = hind;
        Fore = fore;
    }

    /// <summary>Middle of the hind feet under a body that goes, metres ahead of the root.</summary>
    public float Rear { get; }

    /// <summary>The same of the fore feet.</summary>
    public float Front { get; }

    /// <summary>How far the middle of all hips is ahead of half way between the two, or of the hind feet where there are no others, metres.</summary>
    public float Hips { get; }

    /// <summary>Of the pelvis; below 0 where several rows count as hind feet.</summary>
    public float Hind { get; }

    /// <summary>Of the joint of the foremost legs.</summary>
    public float Fore { get; }

    /// <summary>Share of a difference in height between hind and fore feet that the joints take up.</summary>
    public float Fraction => Fore - Hind;

    /// <summary>The span of a trunk.</summary>
    /// <param name="legs">That carry it.</param>
    /// <param name="homes">Where their feet belong under a body that goes.</param>
    /// <param name="rows">Number of pairs.</param>
    /// <param name="pelvis">Place at rest, model space.</param>
    /// <param name="chest">Place of the joint of the foremost legs.</param>
    /// <param name="length">Of the trunk from the one to the other, metres.</param>
    public static TrunkSpan Of(LegRig[] legs, Vector3[] homes, int rows, Vector3 pelvis, Vector3 chest, float length)
    {
        float rear = MiddleOf(true, i => homes[i].Z);
        float front = MiddleOf(false, i => homes[i].Z);
        float hips = (rows == 1 ? HipsOfTwoLegs : 1f) * (Mean(legs, leg => leg.HipRest.Z) - (rows == 1 ? rear : 0.5f * (rear + front)));
        if (rows > 2)
        {
            float wide = Math.Max(front - rear, 0.1f * length);
            return new TrunkSpan(rear, front, hips, (pelvis.Z - rear) / wide, (chest.Z - rear) / wide);
        }

        // Of two rows, whose feet may be farther apart than the joints, each has its own half.
        float wheelbase = rows == 2 ? MiddleOf(false, i => legs[i].Home.Z) - MiddleOf(true, i => legs[i].Home.Z) : 0f;
        float fraction = Math.Min(1f, length / Math.Max(wheelbase, 1e-3f));
        return new TrunkSpan(rear, front, hips, 0.5f * (1f - fraction), 0.5f * (1f + fraction));

        float MiddleOf(bool hind, Func<int, float> place)
        {
            float sum = 0f;
            int count = 0;
            for (int i = 0; i < legs.Length; i++)
            {
                sum += legs[i].IsHind(rows) == hind ? place(i) : 0f;
                count += legs[i].IsHind(rows) == hind ? 1 : 0;
            }

            return sum / Math.Max(count, 1);
        }
    }

    private static float Mean(LegRig[] legs, Func<LegRig, float> place)
    {
        float sum = 0f;
        foreach (LegRig leg in legs)
        {
            sum += place(leg);
        }

        return sum / Math.Max(legs.Length, 1);
    }
}
