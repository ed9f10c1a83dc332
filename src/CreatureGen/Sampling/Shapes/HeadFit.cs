using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Heads of strange creatures in proportion to their trunks: a head on a trunk that is thinner than itself is a wedge on a tube from every side.</summary>
internal static class HeadFit
{
    /// <summary>By how much the thickest necks for a head differ from snake to snake: all alike, those of one build are doubles of one another.</summary>
    private const double SlimmestNeck = 0.95;
    private const double StoutestNeck = 1.12;

    // Largest head against its trunk, each at its largest: by breadth, by height, and by the mean of both.
    private const double Breadth = 1.15;
    private const double Height = 1.2;
    private const double Size = 1;

    // What swimmers, bodies that lie and those on two legs have of these: they come head first, and a head as large as the trunk hides all of it; a bird behind a broader head is a stalk.
    private const double Swimmers = 0.73;
    private const double Lying = 0.9;
    private const double OnTwoLegs = 0.83;

    /// <summary>The same of the head of another body on all other legs: as large as the trunk it is the end of a log.</summary>
    private const double OfAnother = 0.8;

    // Thickest neck behind the head of another body against that head, on land and in the air, and most that it gives way: behind a thicker one the head is the end of a log.
    private const double Neck = 0.82;
    private const double LeastNeck = 0.6;

    /// <summary>Smallest head of another body against its trunk, and most that it grows by: a smaller one is a knob without a face.</summary>
    private const double Smallest = 0.42;
    private const double MostGrown = 1.4;

    /// <summary>Thinnest neck that this leaves, against the trunk: on a thinner one the withers are a knob. Insects have no withers.</summary>
    private const double NeckOfTrunk = 0.38;

    // The same on bodies of fish, snakes and insects, which have no neck of their own.
    private const double NeckOfNeckless = 0.78;
    private const double LeastOfNeckless = 0.6;

    /// <summary>The part of what is too much that the head gives way; the trunk grows by the rest.</summary>
    private const double HeadsPart = 0.7;

    /// <summary>Most that a trunk grows by.</summary>
    private const double MaxGirth = 1.2;

    // Flatness from which on a head is a plate, and the largest breadth of one against its trunk: it may not overhang what carries it.
    private const double Plate = 2.2;
    private const double PlateBreadth = 0.75;

    // Rings of the head behind its lips, of the middle of the neck, and of the trunk between the girdles.
    private const int FirstOfHead = 3;
    private const int LastOfHead = 14;
    private const int FirstOfNeck = 18;
    private const int LastOfNeck = 20;
    private const int FirstOfTrunk = 23;
    private const int LastOfTrunk = 42;

    /// <summary>The proportions with a smaller head and a thicker trunk where the head is too large; those of animals stay as they are, and those of insects' own heads.</summary>
    public static BodyProportions Fit(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (builder.Parents.Head.Class == AnimalClass.Arthropod)
        {
            return drawn;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        (double headWidth, double headHeight) = Largest(shape, FirstOfHead, LastOfHead);
        (double width, double height) = Largest(shape, FirstOfTrunk, LastOfTrunk);
        double size = Math.Sqrt(headWidth * headHeight / (width * height)) / Size;
        double breadth = headWidth / (width * Scalar.Lerp(Breadth, PlateBreadth, Scalar.Smooth((headWidth / headHeight) - (Plate - 0.5))));
        double largest = builder.Kind == LocomotionKind.Swimming ? Swimmers : builder.Plan switch
        {
            BodyPlan.Legless => Lying,
            BodyPlan.Theropod or BodyPlan.Flapping => OnTwoLegs,
            _ => builder.Parents.Head == builder.Parents.First ? 1 : OfAnother,
        };
        double excess = Math.Max(1, Math.Max(size, Math.Max(breadth, headHeight / (height * Height))) / largest);
        double strange = builder.Fitting;

        // What lies is a rope, and stays one.
        double part = builder.Plan == BodyPlan.Legless ? 1 : HeadsPart;
        double grown = builder.Parents.Head == builder.Parents.First ? 1 : Scalar.Clamp(Smallest / (Size * size), 1, MostGrown);
        double head = PortableMath.Pow(excess, -part * strange) * PortableMath.Pow(excess > 1 ? 1 : grown, strange);
        bool neckless = builder.Species.Class is AnimalClass.Fish or AnimalClass.Arthropod || Array.Exists(builder.Species.WalkingPlans, plan => plan.Value == BodyPlan.Legless);
        bool necked = builder.Plan == BodyPlan.Legless || ((neckless || builder.Parents.Head != builder.Parents.First) && builder.Kind != LocomotionKind.Swimming && builder.Plan != BodyPlan.ManyLegged);
        (double neckWidth, double neckHeight) = Largest(shape, FirstOfNeck, LastOfNeck);
        (double thickest, double least) = neckless ? (NeckOfNeckless, LeastOfNeckless) : (Neck, LeastNeck);
        least = builder.Species.Class == AnimalClass.Arthropod ? least : Math.Max(least, Math.Min(1, NeckOfTrunk * Math.Sqrt(width * height / (neckWidth * neckHeight))));
        double own = builder.Plan == BodyPlan.Legless ? builder.Stream("neck of a head").Uniform(SlimmestNeck, StoutestNeck) : 1;
        double neck = necked ? Scalar.Clamp(thickest * own * head * Math.Sqrt(headWidth * headHeight / (neckWidth * neckHeight)), least, 1) : 1;
        return drawn with
        {
            NeckGirth = drawn.NeckGirth * PortableMath.Pow(neck, strange),
            Head = drawn.Head * head,
            Girth = drawn.Girth * Math.Min(MaxGirth, PortableMath.Pow(excess, (1 - part) * strange)),
        };
    }

    /// <summary>Half the width and half the height of the largest sections, metres.</summary>
    private static (double Width, double Height) Largest(BodyShape shape, int first, int last)
    {
        double width = 0;
        double height = 0;
        for (int ring = first; ring <= last; ring++)
        {
            width = Math.Max(width, shape.Width[ring]);
            height = Math.Max(height, 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
        }

        return (width, height);
    }
}
