using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Necks of strange creatures that carry their heads: a thick one held up is a pillar with a face on it from the front, and a head that is carried below the back is not seen from behind.</summary>
internal static class NeckFit
{
    // How steeply a neck is held up at most, degrees, a thick one and a slender one, of a swimmer and of others, and the breadths between them, in breadths of the chest.
    private const double SteepestThickInWater = 5;
    private const double SteepestSlenderInWater = 40;

    /// <summary>The same of a slender neck of what is driven by its tail: held up higher its head is a knob before a bulge.</summary>
    private const double SteepestDriven = 14;
    private const double SteepestThick = 38;
    private const double SteepestSlender = 64;
    private const double ThickNeck = 0.8;
    private const double SlenderNeck = 0.42;

    // What of a head is seen over the back of what does not swim, in heights of the head, and most degrees that the neck is raised for it; that of an insect, which is short, turns the face down.
    private const double Seen = 0.9;
    private const double MostRaised = 34;
    private const double MostRaisedOfInsect = 22;

    /// <summary>The posture with a neck that is raised where its head would be hidden behind the back, and laid down where it is thick and steep.</summary>
    public static BodyPosture Carry(CreatureBuilder builder)
    {
        BodyPosture drawn = builder.Posture;
        bool necked = builder.Plan is not (BodyPlan.Legless or BodyPlan.ManyLegged or BodyPlan.Upright) && builder.Parents.Head.Class != AnimalClass.Arthropod && builder.Species.Disc.Sweep == 0;
        if (!necked)
        {
            return drawn;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        double slender = Scalar.Smooth((ThickNeck - (shape.Width[StationRing.NeckMiddle] / shape.Width[StationRing.Ribs])) / (ThickNeck - SlenderNeck));
        double steepest = builder.Kind == LocomotionKind.Swimming ? Scalar.Lerp(SteepestThickInWater, builder.Plan is BodyPlan.Fish or BodyPlan.Whale ? SteepestDriven : SteepestSlenderInWater, slender) : Scalar.Lerp(SteepestThick, SteepestSlender, slender);
        bool behind = builder.Kind != LocomotionKind.Swimming && !(builder.Plan == BodyPlan.Flapping && builder.Species.Class == AnimalClass.Bird);
        double rise = PortableMath.Atan2(shape.Y[StationRing.Cranium] - shape.Y[StationRing.NeckBase], shape.Z[StationRing.Cranium] - shape.Z[StationRing.NeckBase]);
        double carried = Math.Min(rise + (behind ? Hidden(shape, builder.Species.Class == AnimalClass.Arthropod ? MostRaisedOfInsect : MostRaised) : 0), Scalar.Radians(steepest));
        return drawn with { Neck = drawn.Neck + (builder.Fitting * (carried - rise)) };
    }

    /// <summary>By how much the neck is raised for the head to be seen over the back, radians.</summary>
    private static double Hidden(BodyShape shape, double most)
    {
        double back = double.MinValue;
        for (int ring = StationRing.Shoulder; ring <= StationRing.Pelvis; ring++)
        {
            back = Math.Max(back, shape.Y[ring] + shape.Top[ring]);
        }

        double head = shape.Top[StationRing.Cranium] + shape.Bottom[StationRing.Cranium];
        double lacks = back + (Seen * head) - shape.Y[StationRing.Cranium] - shape.Top[StationRing.Cranium];
        return Scalar.Clamp(lacks / (shape.Arc[StationRing.NeckBase] - shape.Arc[StationRing.Cranium]), 0, Scalar.Radians(most));
    }
}
