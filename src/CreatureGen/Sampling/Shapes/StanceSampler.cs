using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Decides how high the body is carried, and raises head and tail until they clear the ground.</summary>
internal static class StanceSampler
{
    private const int Attempts = 12;

    /// <summary>First ring that a raised tail takes with it: its root stays as low as the rump, however steep the rest.</summary>
    private const int FirstRaised = 47;

    /// <summary>Metres by which the feathers of a lowered tail reach below its spine.</summary>
    private const double FanDrop = 0.06;

    /// <summary>Metres between the head of one that crawls and the ground, without its face.</summary>
    private const double CrawlingHead = 0.03;

    /// <summary>Reach of a chin below the sections of its head, relative to the half depth of the brow.</summary>
    private const double Chin = 0.2;

    /// <summary>The same of a flier's tail that hangs steeply, relative to its fan.</summary>
    private const double HangingFan = 0.6;

    /// <summary>Least size of a head that is made smaller, and least length of a neck.</summary>
    private const double MinHead = 0.6;

    /// <summary>Least length and girth of a tail that is made smaller.</summary>
    private const double MinTail = 0.45;

    /// <summary>Factor on what is made lighter.</summary>
    private const double Lighter = 0.93;

    /// <summary>Metres between the ground and a body that was below it.</summary>
    private const double LiftedGap = 0.02;

    /// <summary>Radians by which a low head or tail is raised at a time.</summary>
    private static readonly double lift = Scalar.Radians(7);

    /// <summary>Radians. Steepest trunks of what swims or sprawls, also tails of what swims, and trunks of what stands on four legs: hyenas and giraffes slope by this.</summary>
    private static readonly double steepestProne = Scalar.Radians(10);
    private static readonly double steepestQuadruped = Scalar.Radians(14);

    /// <summary>A face does not change how a body stands: the shape is taken without one.</summary>
    private static readonly HeadBlueprint faceless = new(ValueList<HeadBump>.Empty, 2.2, new EyeBlueprint(EyeStyle.Round, Ring: 9, Segment: 5, Radius: 0.03, Sink: 0.5, Forward: 0.4, UpperLid: 1, LowerLid: 1, LidTilt: 0), new MouthBlueprint(CornerRing: 0, Opening: 0, Smile: 0, Teeth: 0), 0);

    /// <summary>Sets the elevation and the final posture.</summary>
    public static void Settle(CreatureBuilder builder)
    {
        if (SteepestTrunk(builder) is double steepest)
        {
            Level(builder, steepest);
        }

        double draw = Scalar.Clamp(builder.Stream("stance").Uniform() + builder.StanceShift, 0, 1);
        Measure(builder);
        Place(builder, draw);
        for (int attempt = 0; attempt < Attempts && Adjust(builder); attempt++)
        {
            Measure(builder);
            Place(builder, draw);
        }

        for (int attempt = 0; attempt < Attempts && builder.Plan == BodyPlan.Legless && IsFrontHeavy(builder.Shape); attempt++)
        {
            // No rearing carries this head: it is too large.
            builder.Proportions = builder.Proportions with { Head = Math.Max(0.94 * builder.Proportions.Head, MinHead) };
            Measure(builder);
            Place(builder, draw);
        }
    }

    /// <summary>Radians. Steepest trunk of what swims or goes on four legs and more; null for others.</summary>
    private static double? SteepestTrunk(CreatureBuilder builder) => builder.Plan switch
    {
        _ when builder.Kind == LocomotionKind.Swimming => steepestProne,
        BodyPlan.Sprawling or BodyPlan.ManyLegged when builder.Parents.Legs.Legs is null => steepestProne,
        BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar => steepestQuadruped,
        BodyPlan.Flapping or BodyPlan.Buzzing when builder.Parents.Legs.Legs is null && FlierLegs.PairsOf(builder) > 1 => steepestQuadruped,
        _ => null,
    };

    /// <summary>Lays a trunk nearly level, whatever it is in the birds and reared up bodies that it is mixed of; the tail follows by half of it.</summary>
    private static void Level(CreatureBuilder builder, double steepest)
    {
        BodyShape s = ShapeOf(builder);
        double pitch = PortableMath.Atan2(s.Y[StationRing.TrunkFirst] - s.Y[StationRing.Pelvis], s.Z[StationRing.TrunkFirst] - s.Z[StationRing.Pelvis]);
        double excess = pitch - Scalar.Clamp(pitch, -steepest, steepest);
        builder.Posture = builder.Posture with { Trunk = builder.Posture.Trunk - excess, Tail = builder.Posture.Tail + (0.5 * excess) };
        if (builder.Kind == LocomotionKind.Swimming)
        {
            s = ShapeOf(builder);
            double fall = PortableMath.Atan2(s.Y[StationRing.TorsoLast] - s.Y[BodyGrid.Rings - 1], s.Z[StationRing.TorsoLast] - s.Z[BodyGrid.Rings - 1]);
            builder.Posture = builder.Posture with { Tail = builder.Posture.Tail - fall + Scalar.Clamp(fall, -steepestProne, steepestProne) };
        }
    }

    /// <summary>Lowers a body onto its legs, and raises its head and tail again until they clear the ground.</summary>
    public static void Lower(CreatureBuilder builder, double metres)
    {
        builder.Raised -= metres;
        builder.Elevation -= metres;
        builder.Shape = ShapeOf(builder);
        Clear(builder);
    }

    /// <summary>Whether some of a body that stands on legs is below the ground, the round end of its tail included.</summary>
    public static bool Sinks(CreatureBuilder builder) => builder.Plan != BodyPlan.Legless && builder.IsOnGround
        && (Lowest(builder.Shape, 0, BodyGrid.Rings) < 0 || Lowest(builder.Shape, StationRing.Nose, StationRing.TrunkFirst) < ChinReach(builder) || Lowest(builder.Shape, BodyGrid.Rings - 1, BodyGrid.Rings) < FanReach(builder) || builder.Shape.Y[^1] < builder.Shape.Bottom[^1] || LowestFeeler(builder) < 0);

    /// <summary>How far the chin of another species may reach below the sections of a head, metres.</summary>
    private static double ChinReach(CreatureBuilder builder) => builder.Parents.Head == builder.Parents.First ? 0 : Chin * builder.HalfDepth(StationRing.Brow);

    /// <summary>How far the feathers of a tail reach below its end as it hangs, metres.</summary>
    private static double FanReach(CreatureBuilder builder)
    {
        BodyShape s = builder.Shape;
        const int End = BodyGrid.Rings - 1;
        double along = Math.Abs(s.Z[End] - s.Z[End - 6]);
        double down = Math.Max(0, s.Y[End - 6] - s.Y[End]);
        return builder.Tail.Style != TailStyle.Feathers || down == 0 ? 0 : builder.Tail.Size * (0.3 + (1.5 * down / Math.Sqrt((along * along) + (down * down))));
    }

    /// <summary>The lowest end of feelers on the head, metres, reckoned as if they bent down all the way.</summary>
    private static double LowestFeeler(CreatureBuilder builder)
    {
        BodyShape s = builder.Shape;
        double lowest = double.MaxValue;
        foreach (FeatureBlueprint feeler in builder.Features)
        {
            int ring = (int)Scalar.Clamp(Math.Round(feeler.Ring), 1, BodyGrid.Rings - 2);
            if (feeler.Kind != FeatureKind.Antenna || ring > StationRing.TrunkFirst)
            {
                continue;
            }

            double ahead = s.Z[ring - 1] - s.Z[ring + 1];
            double rise = s.Y[ring - 1] - s.Y[ring + 1];
            double length = Math.Sqrt((ahead * ahead) + (rise * rise));
            double up = ((feeler.Forward * rise) + (feeler.Upward * ahead)) / length;
            lowest = Math.Min(lowest, s.Y[ring] + (feeler.Length * (up + Math.Min(0, feeler.BendUp))));
        }

        return lowest;
    }

    /// <summary>Whether a body that lies on the ground is tipped over by its head.</summary>
    public static bool TipsOver(CreatureBuilder builder) => builder.Plan == BodyPlan.Legless && IsFrontHeavy(builder.Shape);

    /// <summary>Raises a body that is below the ground.</summary>
    public static void Lift(CreatureBuilder builder)
    {
        double missing = LiftedGap - Lowest(builder.Shape, 0, BodyGrid.Rings);
        if (missing > LiftedGap)
        {
            builder.Raised += missing;
            builder.Elevation += missing;
            builder.Shape = ShapeOf(builder);
        }
    }

    /// <summary>Makes lighter what hangs over the feet, and stands the body anew.</summary>
    /// <param name="builder">The creature.</param>
    /// <param name="overhang">How far its centre of mass lies too far to the front, metres; to the rear where negative.</param>
    public static void Lighten(CreatureBuilder builder, double overhang)
    {
        BodyProportions p = builder.Proportions;
        builder.Proportions = overhang > 0
            ? p with { Head = Math.Max(Lighter * p.Head, Math.Min(p.Head, MinHead)), Neck = Math.Max(Lighter * p.Neck, Math.Min(p.Neck, MinHead)) }
            : p with { Tail = Math.Max(Lighter * p.Tail, Math.Min(p.Tail, MinTail)), TailGirth = Math.Max(Lighter * p.TailGirth, Math.Min(p.TailGirth, MinTail)) };
        StandAnew(builder);
    }

    /// <summary>Sets elevation and posture as if no legs had been placed yet.</summary>
    public static void StandAnew(CreatureBuilder builder)
    {
        builder.Posture = builder.Drawn;
        builder.Raised = 0;
        Settle(builder);
    }

    /// <summary>Raises head and tail until they clear the ground.</summary>
    public static void Clear(CreatureBuilder builder)
    {
        for (int attempt = 0; attempt < Attempts && Adjust(builder); attempt++)
        {
            builder.Shape = ShapeOf(builder);
        }
    }

    /// <summary>The body's shape with the current posture and elevation. Most of what is asked for is the body that was shaped last, in many cases at another elevation: it is raised for a fortieth of the cost, which spares a blueprint a third of its time. A third of the rest differs in posture alone.</summary>
    public static BodyShape ShapeOf(CreatureBuilder builder)
    {
        BodyBlueprint body = builder.BodyAt(0);
        if (!(builder.Shaped is var (plan, shaped, tail, shape) && plan == builder.Plan && tail == builder.Tail && shaped == body))
        {
            shape = builder.Shaped is var (_, other, same, sections) && same == builder.Tail && other with { Posture = body.Posture } == body
                ? BodyShaper.Bent(sections, builder.Plan, body, builder.Tail) : BodyShaper.Shape(builder.Plan, body, faceless, builder.Tail);
            builder.Shaped = (builder.Plan, body, builder.Tail, shape);
        }

        return builder.Elevation == 0 ? shape : BodyShaper.Raised(shape, builder.Plan, builder.Elevation);
    }

    private static void Measure(CreatureBuilder builder)
    {
        builder.Elevation = 0;
        builder.Shape = ShapeOf(builder);
        double length = Math.Abs(builder.Shape.Z[StationRing.NeckBase] - builder.Shape.Z[StationRing.Pelvis]);
        double arc = builder.Shape.Arc[StationRing.Pelvis] - builder.Shape.Arc[StationRing.NeckBase];
        builder.TorsoLength = builder.Plan switch
        {
            BodyPlan.Flapping or BodyPlan.Theropod => Math.Max(length, arc * 0.92),
            BodyPlan.Upright => arc * 0.95,
            _ => length,
        };
    }

    /// <summary>Raises a body that has just been measured.</summary>
    private static void Place(CreatureBuilder builder, double draw)
    {
        BodyShape s = builder.Shape;
        double torso = builder.TorsoLength;
        double lowest = Lowest(s, StationRing.TrunkFirst, StationRing.TorsoLast);
        (double min, double max) = builder.Plan switch
        {
            BodyPlan.Digitigrade => (0.62, 0.92),
            BodyPlan.Centaur => (0.66, 0.92),
            BodyPlan.Unguligrade => (0.72, 1.12),
            BodyPlan.Plantigrade => (0.50, 0.70),
            BodyPlan.Columnar => (0.58, 0.85),
            BodyPlan.Upright => (0.46, 0.68),
            BodyPlan.Theropod => builder.Parents.Legs.BipedHipHeight,
            _ => (0.0, 0.0),
        };
        if (builder.Parents.Legs.Bird is BirdPreset bird)
        {
            (min, max) = bird.HipHeight;
        }
        else if (builder.Parents.Legs.HipHeight is (double Min, double Max) own)
        {
            (min, max) = own;
        }

        double hip = Scalar.Lerp(min, max, draw) * torso / 0.92;
        double lower = HipFit.Lower(builder, TrunkOutline.Of(s), hip);
        (hip, torso) = (lower * hip, lower * torso);
        if (builder.Kind != LocomotionKind.Swimming && builder.Parents.Legs.Legs is LegPreset preset)
        {
            builder.HipHeight = hip;
            double height = Scalar.Lerp(preset.Height.Min, preset.Height.Max, draw);
            builder.Elevation = Math.Max(height - lowest, 0.03 - Lowest(s, StationRing.NeckBase + 1, BodyGrid.Rings));
            builder.Shape = BodyShaper.Raised(s, builder.Plan, builder.Elevation);
            return;
        }

        builder.HipHeight = hip;
        double elevation;
        switch (builder.Plan)
        {
            case BodyPlan.Digitigrade:
            case BodyPlan.Centaur:
                elevation = Math.Max(hip - s.Y[StationRing.Pelvis], (0.30 * torso) - lowest);
                break;
            case BodyPlan.Unguligrade:
                elevation = Math.Max(hip - s.Y[StationRing.Pelvis], (0.42 * torso) - lowest);
                break;
            case BodyPlan.Plantigrade:
            case BodyPlan.Columnar:
                elevation = Math.Max(hip - s.Y[StationRing.Pelvis], (0.20 * torso) - lowest);
                break;
            case BodyPlan.Upright:
                elevation = Math.Max(hip - s.Y[StationRing.Pelvis], (0.22 * torso) - lowest);
                break;
            case BodyPlan.Theropod:
                elevation = Math.Max(hip - s.Y[StationRing.BipedHip], ((builder.Parents.Legs.Bird != null ? 0.1 : 0.3) * torso) - lowest);
                break;
            case BodyPlan.Sprawling:
                elevation = (Scalar.Lerp(0.07, 0.16, draw) * torso) - lowest;
                break;
            case BodyPlan.ManyLegged:
                elevation = 0.10 - lowest;
                break;
            case BodyPlan.Legless:
                elevation = LyingElevation(s);
                break;
            case BodyPlan.Hexapod:
                elevation = Math.Max(Scalar.Lerp(0.16, 0.34, draw) - lowest, 0.035 - Lowest(s, StationRing.NeckBase + 1, BodyGrid.Rings));
                break;
            case BodyPlan.Flapping:
            case BodyPlan.Buzzing:
                elevation = (0.55 * torso) + 0.3 - lowest;
                break;
            default:
                elevation = 0.35 - lowest;
                break;
        }

        builder.Elevation = elevation;
        builder.Shape = BodyShaper.Raised(s, builder.Plan, builder.Elevation);
    }

    /// <summary>Whether the raised front of a legless body nearly tips it over the front end of the trunk that lies on the ground.</summary>
    private static bool IsFrontHeavy(BodyShape s)
    {
        double front = s.Z[StationRing.Shoulder];
        return CentreOfMass(s) > front - (0.15 * (front - s.Z[BodyGrid.Rings - 1]));
    }

    /// <summary>Raises a head or a tail that is too low, rears up a legless body that is heavy in front, and straightens an upright trunk that leans too far. True if anything changed.</summary>
    private static bool Adjust(CreatureBuilder builder)
    {
        BodyShape s = builder.Shape;
        (BodyPosture p, double torso) = (builder.Posture, builder.TorsoLength);
        bool crawls = builder.Plan is BodyPlan.Legless or BodyPlan.Hexapod || builder.Parents.Legs.Legs != null;
        double tailGap = crawls ? double.NegativeInfinity : (0.03 * torso) + (builder.Tail.Style == TailStyle.Feathers ? Math.Max(FanDrop, builder.Kind == LocomotionKind.Flying ? HangingFan * builder.Tail.Size : 0) : 0);
        double headGap = builder.Plan == BodyPlan.Legless ? 0.01 : crawls ? CrawlingHead : 0.06 * torso;
        double tail = p.Tail;
        double neck = p.Neck;
        double bend = p.TailBend;
        double torsoPitch = p.Torso;
        if (builder.Kind != LocomotionKind.Swimming)
        {
            if (Lowest(s, FirstRaised, BodyGrid.Rings) < tailGap)
            {
                tail -= lift;
                bend -= bend > 0 ? lift / 3 : 0;
            }

            if (TailFit.HangsBetweenLegs(builder))
            {
                tail -= lift;
            }

            if (Lowest(s, StationRing.Nose, StationRing.TrunkFirst) < headGap)
            {
                neck += lift;
            }
        }

        if (builder.Plan == BodyPlan.Legless && IsFrontHeavy(s))
        {
            neck += lift;
        }

        if (builder.Plan == BodyPlan.Upright && torsoPitch < Scalar.Radians(80))
        {
            double ahead = CentreOfMass(s) - s.Z[StationRing.UprightHip];
            if (ahead > 0.30 * s.Y[StationRing.UprightHip])
            {
                torsoPitch += Scalar.Radians(6);
            }
        }

        builder.Posture = p with { Tail = tail, Neck = neck, TailBend = bend, Torso = torsoPitch };
        return !builder.Posture.Equals(p);
    }

    /// <summary>The elevation at which the raised front of a legless body just clears the ground; its trunk lies on it anyway.</summary>
    private static double LyingElevation(BodyShape s)
    {
        double elevation = 0;
        for (int i = 12; i <= StationRing.Shoulder; i++)
        {
            double below = s.Bottom[i] - s.Y[i];
            elevation = Math.Max(elevation, below / (1 - BodyShaper.Lying(BodyPlan.Legless, i)));
        }

        return elevation;
    }

    /// <summary>The lowest point of the skin between two rings, the last excluded.</summary>
    public static double Lowest(BodyShape s, int first, int end)
    {
        double lowest = double.MaxValue;
        for (int i = first; i < end; i++)
        {
            lowest = Math.Min(lowest, s.Y[i] - (s.Bottom[i] * Math.Abs(s.Cosine[i])));
        }

        return lowest;
    }

    /// <summary>The place along z of the body's centre of mass, limbs left aside.</summary>
    public static double CentreOfMass(BodyShape s)
    {
        double mass = 0;
        double moment = 0;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            double m = Slice(s, i);
            mass += m;
            moment += m * s.Z[i];
        }

        return moment / mass;
    }

    /// <summary>Volume of the body, limbs left aside.</summary>
    public static double Volume(BodyShape s)
    {
        double sum = 0;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            sum += Slice(s, i);
        }

        return 0.5 * PortableMath.Pi * sum;
    }

    /// <summary>Volume of the body from the ring before, as a part of that of an elliptic slice: times π / 2.</summary>
    private static double Slice(BodyShape s, int ring) => s.Width[ring] * (s.Top[ring] + s.Bottom[ring]) * s.Step[ring];
}
