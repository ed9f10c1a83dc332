using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Genetics;

/// <summary>How far two creatures are from one another, told from their blueprints.</summary>
public static class SpeciesDistance
{
    /// <summary>
    /// The mean difference of twelve traits, each 0 for the same and 1 for as different as can be: size, bodies of torso, head and tail, proportions of torso, head and tail, plan, limbs, ornaments, cover and
    /// pattern, hue. 0 for equal creatures; brothers and sisters are about 0.1..0.25 apart, unrelated creatures 0.5 and more. It is the same both ways.
    /// </summary>
    public static double Between(CreatureBlueprint first, CreatureBlueprint second)
    {
        _ = first ?? throw new ArgumentNullException(nameof(first));
        _ = second ?? throw new ArgumentNullException(nameof(second));
        BodyBlueprint a = first.Body, b = second.Body;
        double[] traits =
        {
            Ratio(first.Scale, second.Scale),
            Bodies(a.Blend, b.Blend, blend => blend.TorsoFractions),
            Bodies(a.Blend, b.Blend, blend => blend.HeadFractions),
            Bodies(a.Blend, b.Blend, blend => blend.TailFractions),
            (Ratio(a.Proportions.Neck, b.Proportions.Neck) + Ratio(a.Proportions.Girth, b.Proportions.Girth) + Ratio(a.Proportions.Depth, b.Proportions.Depth)) / 3,
            (Ratio(a.Proportions.Head, b.Proportions.Head) + Ratio(a.Proportions.Snout, b.Proportions.Snout)) / 2,
            Ratio(a.Proportions.Tail, b.Proportions.Tail),
            first.Plan == second.Plan ? 0 : first.Kind == second.Kind ? 0.6 : 1,
            (Counts(first.Legs.Count, second.Legs.Count) + Counts(first.Wings.Count + first.InsectWings.Count, second.Wings.Count + second.InsectWings.Count) + Counts(first.Fins.Count, second.Fins.Count)) / 3,
            (Counts(first.Features.Count, second.Features.Count) + Counts(first.Manes.Count + first.Frills.Count, second.Manes.Count + second.Frills.Count) + Counts(first.Ears.Count, second.Ears.Count)) / 3,
            (a.Blend.Skin == b.Blend.Skin ? 0 : 0.5) + (first.Coat.PatternKind == second.Coat.PatternKind ? 0 : 0.5),
            Hue(first.Coat.Base, second.Coat.Base),
        };
        double sum = 0;
        foreach (double trait in traits)
        {
            sum += trait;
        }

        return sum / traits.Length;
    }

    /// <summary>1 for a factor of e and more.</summary>
    private static double Ratio(double a, double b) => Math.Min(1, PortableMath.Log(Math.Max(a, b) / Math.Min(a, b)));

    private static double Counts(int a, int b) => a == b ? 0 : Math.Abs(a - b) / (double)Math.Max(a, b);

    private static double Bodies(BodyBlend a, BodyBlend b, Func<BodyBlend, IReadOnlyList<double>> fractionsOf)
    {
        var shared = new List<double>();
        for (int i = 0; i < a.Bodies.Count; i++)
        {
            for (int k = 0; k < b.Bodies.Count; k++)
            {
                if (a.Bodies[i].Name == b.Bodies[k].Name)
                {
                    shared.Add(Math.Min(fractionsOf(a)[i], fractionsOf(b)[k]));
                }
            }
        }

        // Whoever comes first, they add up in one order: the sum is the same to the last bit.
        shared.Sort();
        double sum = 0;
        foreach (double one in shared)
        {
            sum += one;
        }

        return Math.Max(0, 1 - sum);
    }

    /// <summary>Distance in the plane of chroma and hue with lightness, 1 for opposite strong colours.</summary>
    private static double Hue(ColourBlueprint a, ColourBlueprint b)
    {
        double x = (a.Chroma * PortableMath.Cos(a.Hue)) - (b.Chroma * PortableMath.Cos(b.Hue));
        double y = (a.Chroma * PortableMath.Sin(a.Hue)) - (b.Chroma * PortableMath.Sin(b.Hue));
        double light = a.Lightness - b.Lightness;
        return Math.Min(1, Math.Sqrt((light * light) + (9 * ((x * x) + (y * y)))));
    }
}
