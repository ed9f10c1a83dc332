using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The line from the neck over the withers of a mixed walker: where a chest and a neck of different bodies meet it is a knob, which is evened out on the skin alone.</summary>
internal static class WithersLine
{
    // The rings that are evened out, and how often.
    private const int First = StationRing.NeckMiddle;
    private const int End = StationRing.Belly;
    private const int Rounds = 8;

    // Share of the first body from which on a torso keeps its own withers, and at which it is mixed.
    private const double Pure = 0.88;
    private const double Mixed = 0.75;

    // Segments from the middle of the back up to which a section follows its line wholly, and from which on it does not: limbs grow there.
    private const double Whole = 3;
    private const double None = 8;

    /// <summary>Factors on how high the back of each ring is above its spine.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="shape">Its sections.</param>
    public static double[] Of(CreatureBlueprint creature, BodyShape shape)
    {
        double[] factors = new double[BodyGrid.Rings];
        Array.Fill(factors, 1);
        double mixed = Scalar.Smooth((Pure - creature.Body.Blend.TorsoFractions[0]) / (Pure - Mixed));

        // Where wings fold the back stays as they know it.
        if (mixed == 0 || creature.Wings.Count > 0 || creature.Body.Shell.Style != ShellStyle.None || !IsOnLegs(creature.Plan))
        {
            return factors;
        }

        double[] height = (double[])shape.Top.Clone();
        double[] next = (double[])shape.Top.Clone();
        for (int round = 0; round < Rounds; round++)
        {
            for (int i = First; i < End; i++)
            {
                next[i] = (height[i - 1] + (2 * height[i]) + height[i + 1]) / 4;
            }

            (height, next) = (next, height);
        }

        for (int i = First; i < End; i++)
        {
            factors[i] = Scalar.Lerp(1, height[i] / shape.Top[i], mixed);
        }

        return factors;
    }

    /// <summary>Share of the line's factor that a segment from the middle of the back takes.</summary>
    public static double Share(int segment) => Scalar.Smooth((None - segment) / (None - Whole));

    private static bool IsOnLegs(BodyPlan plan) => plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur or BodyPlan.Theropod or BodyPlan.Upright or BodyPlan.Sprawling;
}
