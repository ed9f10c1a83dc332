using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Falling;

/// <summary>How a creature gets up from its crouch, as data: how far its fore and its hind body are let down at the ends of the parts of the rise, in depths of the crouch. Immutable.</summary>
/// <remarks>Cattle get up hind first on flexed carpuses, horses, dogs, cats and pigs fore first, by way of sitting (WikiVet, "Locomotion"; EquiSearch, "Rolling and rising").</remarks>
internal sealed class RisingManner
{
    /// <summary>Kilograms from which on a body takes its time, and how much longer it takes.</summary>
    private const float HeavyMass = 200f;
    private const float HeavyTime = 1.5f;
    private const float PillarTime = 1.2f;

    private static readonly double[] all = { 0, 0.3, 0.55, 0.8, 1 };
    private static readonly double[] hindFirstFore = { 1, 0.95, 0.7, 0.3, 0 };
    private static readonly double[] hindFirstHind = { 1, 0.6, 0.05, 0, 0 };
    private static readonly double[] foreFirstFore = { 1, 0.5, 0.05, 0.03, 0 };
    private static readonly double[] foreFirstHind = { 1, 0.95, 0.75, 0.3, 0 };
    private static readonly double[] together = { 1, 0.85, 0.45, 0.1, 0 };

    private readonly double[] fore;
    private readonly double[] hind;
    private readonly double[] foreSlopes;
    private readonly double[] hindSlopes;

    private RisingManner(double[] fore, double[] hind, float tempo)
    {
        this.fore = fore;
        this.hind = hind;
        Tempo = tempo;
        foreSlopes = Slopes(fore);
        hindSlopes = Slopes(hind);
    }

    /// <summary>Factor on all times.</summary>
    public float Tempo { get; }

    /// <summary>How a creature gets up.</summary>
    public static RisingManner Of(MotionSubject subject)
    {
        BodyPlan plan = subject.Plan;
        float mass = subject.Mass.Mass;
        float tempo = (float)Scalar.Lerp(1, HeavyTime, Scalar.Smooth((mass - (0.5 * HeavyMass)) / HeavyMass)) * (plan == BodyPlan.Columnar ? PillarTime : 1f);
        bool under = plan is BodyPlan.Digitigrade or BodyPlan.Plantigrade or BodyPlan.Unguligrade or BodyPlan.Columnar or BodyPlan.Centaur;
        return !under ? new RisingManner(together, together, tempo)
            : subject.Manner.RisesHindFirst ? new RisingManner(hindFirstFore, hindFirstHind, tempo)
            : new RisingManner(foreFirstFore, foreFirstHind, tempo);
    }

    /// <summary>How far fore and hind body are let down, depths of the crouch.</summary>
    /// <param name="u">Part of the rise that has gone by, 0..1.</param>
    public (float Fore, float Hind) At(float u) => (Value(fore, foreSlopes, u), Value(hind, hindSlopes, u));

    private static double[] Slopes(double[] values)
    {
        var slopes = new double[values.Length];
        MonotoneCubic.Slopes(all, values, slopes);

        // It starts from rest and comes to rest.
        slopes[0] = 0;
        slopes[slopes.Length - 1] = 0;
        return slopes;
    }

    private static float Value(double[] values, double[] slopes, float u)
    {
        int i = 0;
        while (i < all.Length - 2 && u > all[i + 1])
        {
            i++;
        }

        double width = all[i + 1] - all[i];
        double t = Scalar.Clamp((u - all[i]) / width, 0, 1);
        double s = 1 - t;
        return (float)((values[i] * s * s * (1 + (2 * t))) + (values[i + 1] * t * t * (3 - (2 * t))) + (width * t * s * ((slopes[i] * s) - (slopes[i + 1] * t))));
    }
}
