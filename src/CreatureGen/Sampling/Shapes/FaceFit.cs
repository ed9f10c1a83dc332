using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Faces of strange creatures that look ahead, and in the water run out to the nose: another body carries them at an angle, and at a breadth, that was not made for them.</summary>
internal static class FaceFit
{
    // Most that a face falls away ahead of its brow, degrees: that of a swimmer, as those of swimming animals do, for one that hangs as on a neck over land turns its forehead to the water; that of another body on an insect, whose own looks down; and that of another body on any other.
    private const double SteepestFace = 11.5;
    private const double SteepestOnInsect = 20;
    private const double SteepestOfAnother = 30;

    /// <summary>Most that a face is held up, degrees: one that is raised on a neck shows its throat and no eyes.</summary>
    private const double HighestFace = 3;

    /// <summary>Least that the face of what stands over its legs falls away, degrees: its head is above the eye that it is seen by, which looks up at the chin of a level one.</summary>
    private const double LeastFall = 10;

    /// <summary>Most that a neck is laid down for it, degrees.</summary>
    private const double MostLaid = 18;

    // Shortest face of another body on a swimmer, from the nose to the brow in heights of the brow, and most that its snout is longer for it: a shorter one is the sawn end of a log.
    private const double Shortest = 0.85;
    private const double MostLonger = 1.6;

    // Flattest head of another body, in breadths for each height of its brow, the slices of the lattice that hold it, the power of the excess by which they are higher and narrower, for the slices behind them even it out, and most of it: a flatter one is a board with nostrils.
    private const double Flattest = 1.75;
    private const int HeadSlices = 2;
    private const double Rounded = 0.75;
    private const double MostRounded = 1.9;

    /// <summary>The posture with a face that looks ahead: neither down into the water or the ground nor up.</summary>
    public static BodyPosture Level(CreatureBuilder builder)
    {
        BodyPosture drawn = builder.Posture;
        if (builder.Parents.Head.Class == AnimalClass.Arthropod && builder.Kind != LocomotionKind.Swimming)
        {
            return drawn;
        }

        bool own = builder.Parents.Head == builder.Parents.First;
        double steepest = builder.Kind == LocomotionKind.Swimming ? SteepestFace
            : own ? double.PositiveInfinity
            : builder.Species.Class == AnimalClass.Arthropod ? SteepestOnInsect : SteepestOfAnother;
        double fall = Fall(builder);
        double raised = Math.Max(0, fall - Scalar.Radians(steepest));
        bool stands = builder.Kind == LocomotionKind.Walking && (PlanTraits.IsAboveLegs(builder.Plan) || builder.Plan is BodyPlan.Theropod or BodyPlan.Upright);
        double least = Scalar.Radians(stands ? LeastFall : -HighestFace);
        double lowered = Math.Max(0, least - fall);
        BodyPosture level = drawn with { Head = drawn.Head + (builder.Fitting * (raised - lowered)) };
        if (lowered == 0)
        {
            return level;
        }

        // On a steep neck the nape does not bend as far as that: the neck is laid down by the rest.
        builder.Posture = level;
        double still = Scalar.Clamp(least - Fall(builder), 0, Scalar.Radians(MostLaid));
        return level with { Neck = level.Neck - (builder.Fitting * still) };
    }

    /// <summary>How far the face falls away ahead of its brow, radians.</summary>
    private static double Fall(CreatureBuilder builder)
    {
        BodyShape shape = StanceSampler.ShapeOf(builder);
        return PortableMath.Atan2(shape.Y[StationRing.Brow] - shape.Y[StationRing.Nose], shape.Z[StationRing.Nose] - shape.Z[StationRing.Brow]);
    }

    /// <summary>The proportions of a swimmer with a longer snout where the face of another body is blunt.</summary>
    public static BodyProportions Lengthen(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (builder.Kind != LocomotionKind.Swimming || !IsFitted(builder))
        {
            return drawn;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        double length = (shape.Arc[StationRing.Brow] - shape.Arc[StationRing.Nose]) / (shape.Top[StationRing.Brow] + shape.Bottom[StationRing.Brow]);
        return drawn with { Snout = drawn.Snout * PortableMath.Pow(Scalar.Clamp(Shortest / length, 1, MostLonger), builder.Fitting) };
    }

    /// <summary>The slices with a higher and narrower head where that of another body is flat.</summary>
    public static ValueList<LatticeSlice> Round(CreatureBuilder builder)
    {
        if (!IsFitted(builder))
        {
            return builder.Slices;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        double flat = 2 * shape.Width[StationRing.Brow] / (shape.Top[StationRing.Brow] + shape.Bottom[StationRing.Brow]);
        double round = PortableMath.Pow(Scalar.Clamp(flat / Flattest, 1, MostRounded), Rounded * builder.Fitting);
        LatticeSlice[] slices = builder.Slices.ToArray();
        for (int k = 0; k < HeadSlices; k++)
        {
            slices[k] = slices[k] with { Width = slices[k].Width / round, Height = slices[k].Height * round };
        }

        return new ValueList<LatticeSlice>(slices);
    }

    /// <summary>Whether the face is that of another body, and of flesh: beaks and the faces of insects are as they are.</summary>
    private static bool IsFitted(CreatureBuilder builder)
    {
        SpeciesProfile face = builder.Parents.Head;
        return face != builder.Parents.First && face.Snout != SnoutKind.Beak && face.Class != AnimalClass.Arthropod && builder.Species.Disc.Sweep == 0;
    }
}
