using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The line from the neck over the withers of a mixed walker: where a chest and a neck of different bodies meet it is a knob, which is evened out on the skin alone.</summary>
internal static class WithersLine
{
    // The rings that are evened out, over how many of them that begins and ends, and those about them that count.
    private const int First = StationRing.Nape + 1;
    private const int End = StationRing.Belly;
    private const double Edge = 4;
    private const int Start = StationRing.Cranium;
    private const int Last = StationRing.Pelvis;

    // How often heights are evened out from ring to ring.
    private const int Rounds = 8;

    // Width of the bell over which the line is evened out, in lengths of the trunk, and rings to either side of a corner that its sides go through.
    private const double Width = 0.14;
    private const int Side = 2;

    // What the cosine of a corner has to gain by a quarter more of it, and that of one that is even enough.
    private const float Gain = 0.03f;
    private const float Even = 0.94f;

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

        double[] height = Heights(shape, mixed);
        Span<Vector3> line = stackalloc Vector3[Last + 1];
        Span<float> along = stackalloc float[Last + 1];
        for (int i = Start; i <= Last; i++)
        {
            line[i] = shape.Centre(i) + (shape.Up(i) * (float)height[i]);
            along[i] = i == Start ? 0f : along[i - 1] + Vec.Distance(line[i - 1], line[i]);
        }

        double width = Width * (shape.Arc[StationRing.TorsoLast] - shape.Arc[StationRing.TrunkFirst]);
        Span<float> rise = stackalloc float[Last + 1];
        for (int i = First; i < End; i++)
        {
            double share = mixed * Scalar.Smooth((i - First + 1) / Edge) * Scalar.Smooth((End - i) / Edge);
            rise[i] = (float)share * Vec.Dot(Evened(line, along, i, width) - line[i], shape.Up(i));
        }

        float part = Mildest(line, rise, shape);
        for (int i = First; i < End; i++)
        {
            factors[i] = (height[i] + (part * rise[i])) / shape.Top[i];
        }

        return factors;
    }

    /// <summary>Heights of the back above the spine, from ring to ring without steps.</summary>
    private static double[] Heights(BodyShape shape, double mixed)
    {
        double[] height = (double[])shape.Top.Clone();
        double[] next = (double[])shape.Top.Clone();
        for (int round = 0; round < Rounds; round++)
        {
            for (int i = StationRing.NeckMiddle; i < End; i++)
            {
                next[i] = (height[i - 1] + (2 * height[i]) + height[i + 1]) / 4;
            }

            (height, next) = (next, height);
        }

        for (int i = StationRing.NeckMiddle; i < End; i++)
        {
            height[i] = Scalar.Lerp(shape.Top[i], height[i], mixed);
        }

        return height;
    }

    /// <summary>Mean of the line about a ring, weighted by a bell of a width: rings lie close together where the back is hollow, and count by the length of the line that they stand for.</summary>
    private static Vector3 Evened(ReadOnlySpan<Vector3> line, ReadOnlySpan<float> along, int ring, double width)
    {
        Vector3 sum = Vector3.Zero;
        float weights = 0f;
        for (int i = Start + 1; i < Last; i++)
        {
            double away = (along[i] - along[ring]) / width;
            float weight = (along[i + 1] - along[i - 1]) * (float)PortableMath.Exp(-0.5 * away * away);
            sum += line[i] * weight;
            weights += weight;
        }

        return sum / weights;
    }

    /// <summary>How much of what evens the line out leaves it the least of a corner that stands out: sections that fan out from a bent spine come to lie before one another where the back is raised.</summary>
    private static float Mildest(ReadOnlySpan<Vector3> line, ReadOnlySpan<float> rise, BodyShape shape)
    {
        Span<Vector3> moved = stackalloc Vector3[Last + 1];
        float best = 0f;
        float mildest = -1f - Gain;
        for (int quarter = 0; quarter <= 4; quarter++)
        {
            float part = 0.25f * quarter;
            for (int i = Start; i <= Last; i++)
            {
                moved[i] = line[i] + (shape.Up(i) * (part * rise[i]));
            }

            float least = 1f;
            for (int i = First; i < End; i++)
            {
                Vector3 to = Vec.Normalize(moved[i] - moved[i - Side]);
                Vector3 on = Vec.Normalize(moved[i + Side] - moved[i]);
                least = Vec.Cross(to, on).X < 0f ? Math.Min(least, Vec.Dot(to, on)) : least;
            }

            (best, mildest) = mildest < Even && least > mildest + Gain ? (part, least) : (best, mildest);
        }

        return best;
    }

    /// <summary>Share of the line's factor that a segment from the middle of the back takes.</summary>
    public static double Share(int segment) => Scalar.Smooth((None - segment) / (None - Whole));

    private static bool IsOnLegs(BodyPlan plan) => plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur or BodyPlan.Theropod or BodyPlan.Upright or BodyPlan.Sprawling;
}
