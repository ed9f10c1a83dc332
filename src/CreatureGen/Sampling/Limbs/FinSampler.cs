using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Gives swimmers, and fish out of water, their fins where the attachment rules put them.</summary>
internal static class FinSampler
{
    /// <summary>Greatest depth of a fin, relative to its length.</summary>
    private const double MaxWidth = 1.6;

    /// <summary>Longest paired fin that is drawn, metres at scale 1: that of turtles; a longer one is a stilt from the side.</summary>
    private const double MaxPairLength = 0.75;

    /// <summary>Deepest paired fin that is drawn, metres at scale 1: a long one that is deeper is a slab with a corner before the shoulder, and a racket from the front.</summary>
    private const double MaxPairDepth = 0.35;

    /// <summary>Deepest paddle, relative to its length: a deeper one is a mitten.</summary>
    private const double MaxPaddle = 0.56;

    /// <summary>Depth of a paddle that is as deep as the plan says, relative to its length.</summary>
    private const double PaddleWidth = 0.5;

    /// <summary>Probability at full strangeness that a species with fins of its own has others that its plan allows.</summary>
    private const double OtherFins = 0.6;

    /// <summary>Index of the tail fin among the fins whose sizes are drawn.</summary>
    private const int TailFin = -1;

    // Hang of paired fins at full strangeness, as factors on that of the species or plan: most lie flatter.
    private const double FlattestDrop = 0.3;
    private const double SteepestDrop = 1.1;

    // How far the paired fins of a strange swimmer hang down, for each unit that they stand out: level ones are edges from the front and behind, steep ones legs from the side; and the hang of an animal's that makes them steepest.
    private const double LeastFall = 0.4;
    private const double SteepestFall = 0.75;
    private const double FullHang = 0.6;

    /// <summary>Longest paired fin of a fish in lengths of its body, and how much of what is longer is left: fins of half a body are arms.</summary>
    private const double LongestOnFish = 0.2;
    private const double Beyond = 0.4;

    /// <summary>Highest half of an upright tail fin in half heights of the body: edge on, a higher one is a needle.</summary>
    private const double HighestTail = 1.05;

    /// <summary>How far the paired fins of a mixed swimmer are swept otherwise than those of its species, and from where to where: with the same flippers seals of any body are twins from above.</summary>
    private const double OtherSweep = 0.5;
    private const double LeastSweep = 0.15;
    private const double MostSweep = 1;

    /// <summary>Width of a body, of its greatest, from which on a disc beats there, and length of fins behind it relative to those of bodies without.</summary>
    private const double DiscWidth = 0.4;
    private const double ShortBehindDisc = 0.5;

    /// <summary>Rings behind a leg's socket over which the leg lies in the water.</summary>
    private const int UnderLegs = 13;

    /// <summary>Fills in the fins and the tail fin of the creature.</summary>
    public static void Sample(CreatureBuilder builder)
    {
        if (builder.Kind == LocomotionKind.Swimming)
        {
            Swim(builder);
            FitPlan(builder);
        }
        else if (builder.Parents.Fins.Class == AnimalClass.Fish)
        {
            Crest(builder, builder.Stream("fins"));
        }
    }

    /// <summary>Whether a swimmer will have an upright tail fin or a fluke to swim by, and not only a fringe or a plain tail.</summary>
    public static bool IsDrivenByTailFin(CreatureBuilder builder) =>
        PresetOf(builder) is FinPreset preset ? preset.Tail != TailStyle.Plain : builder.Plan is BodyPlan.Fish or BodyPlan.Whale;

    /// <summary>The fins that a swimmer's species always has; null when it has those that its plan allows.</summary>
    private static FinPreset? PresetOf(CreatureBuilder builder)
    {
        bool others = builder.Stream("other fins").Chance(OtherFins * builder.Strangeness) && builder.Parents.First.Disc.Sweep == 0;
        return others ? null : builder.Parents.Fins.Fins;
    }

    private static void Swim(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("fins");
        if (PresetOf(builder) is FinPreset preset)
        {
            Own(builder, random, preset);
            return;
        }

        // A mixed body without a fin on its back is a sausage from the side.
        FinAnatomy anatomy = FinAnatomy.Of(builder.Plan);
        SwimmingPlacement placement = SwimmingRules.Place(LegSampler.Measure(builder), builder.Fitting > 0 ? anatomy.WithDorsal() : anatomy, builder.Sockets, builder.Seed.Child("swimmer"));
        double hang = random.Uniform(0.25, 0.6);
        double sweep = random.Uniform(0.4, 0.8);
        foreach (FinPlacement fin in placement.Fins)
        {
            if ((fin.Place == FinPlace.Pectoral && IsBesideLeg(builder, fin.Socket)) || !builder.Sockets.TryReserve(fin.Socket, 0))
            {
                continue;
            }

            double size = Stature.Fin(builder, builder.Fins.Count);
            if (fin.Place == FinPlace.Pectoral)
            {
                bool front = fin.Socket.Ring < BodyGrid.AnchorRing - 2;
                (double length, double width) = builder.Plan switch
                {
                    BodyPlan.Flipper => front ? (0.65, 0.41) : (0.46, 0.42),
                    BodyPlan.Whale => (0.42, 0.45),
                    BodyPlan.Eel => (0.28, 0.55),
                    _ => front ? (0.34, 0.55) : (0.2, 0.55),
                };
                double slender = FlankFin.Of(fin.Style) is FlankFin form ? form.Depth / PaddleWidth : 1;
                double drawn = Shortened(builder, size * length * LengthOf(fin.Style) * fin.Scale.X);
                double shorter = Scalar.Lerp(1, Math.Min(1, MaxPairLength / drawn), builder.Fitting);
                double depth = Math.Min(MaxWidth, width * slender * fin.Scale.Z / shorter);
                depth = DepthOf(builder, depth, shorter * drawn, fin.Style);
                builder.Fins.Add(new FinBlueprint(fin.Place, fin.Style, fin.Socket, shorter * drawn, depth, DropOf(builder, hang), sweep));
            }
            else
            {
                double height = builder.Plan == BodyPlan.Eel ? 0.13 : fin.Place == FinPlace.Ventral ? 0.12 : builder.Plan == BodyPlan.Whale ? 0.16 : 0.2;
                (double outlined, double swept) = FinOutlines.Vary(builder, size * height * fin.Scale.Y, SweepOf(fin.Style));
                builder.Fins.Add(new FinBlueprint(fin.Place, fin.Style, fin.Socket, outlined, 0, 0, swept));
            }
        }

        double fork = placement.Tail.Style switch
        {
            TailStyle.Fork => random.Uniform(1.2, 2.2),
            TailStyle.Fan => TailSampler.FanFork(builder, random),
            TailStyle.Lance => -1,
            TailStyle.Fluke => 1,
            _ => 0,
        };
        double spread = FinOutlines.SpreadOf(placement.Tail.Style) * (placement.Tail.Style == TailStyle.Fluke ? placement.Tail.Scale.X : placement.Tail.Scale.Y);
        builder.Tail = FinOutlines.Vary(builder, new TailBlueprint(placement.Tail.Style, Lowered(builder, placement.Tail.Style, Stature.Fin(builder, TailFin) * spread), fork));
        TailFit.Sink(builder);
        builder.Shape = StanceSampler.ShapeOf(builder);
    }

    /// <summary>Legs of one species may leave no room for the paired fins of another: a swimmer without those its plan moves by swims by its body, as newts do.</summary>
    private static void FitPlan(CreatureBuilder builder)
    {
        int pairs = 0;
        foreach (FinBlueprint fin in builder.Fins)
        {
            pairs += fin.Place == FinPlace.Pectoral ? 1 : 0;
        }

        int need = builder.Plan switch { BodyPlan.Flipper => 2, BodyPlan.Fish or BodyPlan.Whale => 1, _ => 0 };
        builder.Plan = pairs >= need ? builder.Plan : pairs > 0 ? BodyPlan.Fish : BodyPlan.Eel;
    }

    /// <summary>Whether a place for a fin is close behind a leg, which lies back over it in the water, or close before one of what swims by winding, which has the leg in its stead.</summary>
    private static bool IsBesideLeg(CreatureBuilder builder, SocketBlueprint socket) =>
        builder.Legs.Exists(leg => (builder.Plan == BodyPlan.Eel || leg.Socket.Ring < socket.Ring) && Math.Abs(socket.Ring - leg.Socket.Ring) < UnderLegs);

    /// <summary>The ring of a paired fin: behind a disc, which is a pair of fins itself. One that held on to the trunk stayed where it was as the disc beat, and drew its edge down to a table's legs.</summary>
    private static int BehindDisc(CreatureBuilder builder, int ring)
    {
        if (builder.Species.Disc.Sweep == 0)
        {
            return ring;
        }

        double widest = 0;
        for (int i = 0; i < StationRing.TailFirst; i++)
        {
            widest = Math.Max(widest, builder.Shape.Width[i]);
        }

        while (ring < StationRing.TailFirst && builder.Shape.Width[ring] > DiscWidth * widest)
        {
            ring++;
        }

        return ring;
    }

    /// <summary>The fins that a species always has.</summary>
    private static void Own(CreatureBuilder builder, RandomStream random, FinPreset preset)
    {
        double back = builder.Fitting * builder.Stream("sweep of fins").Uniform(-OtherSweep, OtherSweep);
        foreach (FinSitePreset own in preset.Fins)
        {
            FinSitePreset fin = FinOutlines.Vary(builder, own);
            if (fin.Place != FinPlace.Pectoral && !builder.Sockets.IsFree(MidlineSocket(fin), 0))
            {
                fin = own;
            }

            double length = CreatureBuilder.Between(random, fin.Length) * Stature.Fin(builder, builder.Fins.Count);
            length = fin.Place == FinPlace.Pectoral ? Shortened(builder, length) : length;
            double width = CreatureBuilder.Between(random, fin.Width);
            double sweep = fin.Place == FinPlace.Pectoral ? Scalar.Clamp(fin.Sweep + back, Math.Min(fin.Sweep, LeastSweep), Math.Max(fin.Sweep, MostSweep)) : fin.Sweep;
            int ring = fin.Place == FinPlace.Pectoral ? BehindDisc(builder, fin.Ring) : fin.Ring;
            length *= ring == fin.Ring ? 1 : ShortBehindDisc;
            SocketBlueprint socket = fin.Place switch
            {
                FinPlace.Pectoral => SocketSizing.Centre(ring, fin.Segment, fin.Rows, 2),
                _ => MidlineSocket(fin),
            };

            // Fins of one species and legs of another may want the same place: the legs were first.
            bool crowded = builder.Legs.Count > 0 && (!builder.Sockets.IsFree(socket, 0) || (fin.Place == FinPlace.Pectoral && IsBesideLeg(builder, socket)));
            if (!crowded && builder.Sockets.TryReserve(socket, 0))
            {
                builder.Fins.Add(new FinBlueprint(fin.Place, fin.Style, socket, length, fin.Place == FinPlace.Pectoral ? DepthOf(builder, width, length, fin.Style) : 0, DropOf(builder, fin.Drop), sweep));
            }
        }

        double size = CreatureBuilder.Between(random, preset.TailSize) * Stature.Fin(builder, TailFin);
        TailBlueprint tail = FinOutlines.Other(builder, new TailBlueprint(preset.Tail, size, CreatureBuilder.Between(random, preset.TailFork), preset.TailLobe));
        builder.Tail = FinOutlines.Vary(builder, tail with { Size = Lowered(builder, tail.Style, tail.Size) });
        TailFit.Sink(builder);
        builder.Shape = StanceSampler.ShapeOf(builder);
    }

    /// <summary>Where a fin on back or belly stands.</summary>
    private static SocketBlueprint MidlineSocket(FinSitePreset fin) => new(fin.Ring, fin.Place == FinPlace.Dorsal ? 31 : 15, fin.Rows, 2);

    /// <summary>A fish that walks or flies keeps the fin on its back.</summary>
    private static void Crest(CreatureBuilder builder, RandomStream random)
    {
        FinStyle style = CreatureBuilder.Choose(random, (FinStyle.Sail, 1), (FinStyle.Spiny, 1), (FinStyle.Shark, 1), (FinStyle.Carp, 0.7), (FinStyle.Tuna, 0.7), (FinStyle.Ray, 0.6));
        var socket = new SocketBlueprint(random.Integer(24, 30), 31, 2 * random.Integer(4, 7), 2);
        double height = random.Uniform(0.14, 0.26);
        if (builder.Shell.Style == ShellStyle.None && builder.Sockets.IsFree(socket, 0) && builder.Sockets.TryReserve(socket, 0))
        {
            builder.Fins.Add(new FinBlueprint(FinPlace.Dorsal, style, socket, height, 0, 0, SweepOf(style)));
        }
    }

    /// <summary>Depth of a paired fin, relative to its length.</summary>
    private static double DepthOf(CreatureBuilder builder, double drawn, double length, FinStyle style) =>
        Scalar.Lerp(drawn, Math.Min(Math.Min(drawn, MaxPairDepth / length), style == FinStyle.Paddle ? MaxPaddle : MaxWidth), builder.Fitting);

    /// <summary>The length of a paired fin in proportion to the body of a fish.</summary>
    private static double Shortened(CreatureBuilder builder, double length)
    {
        double longest = LongestOnFish * builder.Shape.Arc[StationRing.TailFirst];
        bool shortens = builder.Plan == BodyPlan.Fish && builder.Species.Disc.Sweep == 0 && length > longest;
        return shortens ? Scalar.Lerp(length, longest + (Beyond * (length - longest)), builder.Fitting) : length;
    }

    /// <summary>The size of a tail fin in proportion to the height of the body; flukes lie level.</summary>
    private static double Lowered(CreatureBuilder builder, TailStyle style, double size)
    {
        double half = 0;
        for (int i = StationRing.TrunkFirst; i < StationRing.TailFirst; i++)
        {
            half = Math.Max(half, 0.5 * (builder.Shape.Top[i] + builder.Shape.Bottom[i]));
        }

        double highest = HighestTail * half;
        return style is TailStyle.Fluke or TailStyle.Plain || size < highest ? size : Scalar.Lerp(size, highest + (Beyond * (size - highest)), builder.Fitting);
    }

    /// <summary>How far paired fins hang down that hang so far on an animal.</summary>
    private static double DropOf(CreatureBuilder builder, double hang)
    {
        double drop = hang * Scalar.Lerp(1, builder.Stream("fin drop").Uniform(FlattestDrop, SteepestDrop), builder.Strangeness);
        if (builder.Species.Disc.Sweep != 0)
        {
            return drop;
        }

        return Scalar.Lerp(drop, Scalar.Lerp(LeastFall, SteepestFall, Scalar.Clamp(drop / FullHang, 0, 1)), builder.Fitting);
    }

    private static double SweepOf(FinStyle style) => style switch { FinStyle.Sail or FinStyle.Ray => 0.35, FinStyle.Shark => 0.9, _ => 0.6 };

    /// <summary>Length of a fin of a family relative to a paddle on the same body.</summary>
    public static double LengthOf(FinStyle style) => style switch
    {
        FinStyle.Shark => 1.15,
        FinStyle.Tuna => 1.25,
        FinStyle.Carp => 0.85,
        FinStyle.Veil => 1.3,
        FinStyle.Flying => 1.8,
        _ => 1,
    };
}
