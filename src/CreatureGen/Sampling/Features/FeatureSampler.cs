using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>Draws ornaments, at most one kind on the head and one on the back, so that a creature looks designed.</summary>
internal static class FeatureSampler
{
    /// <summary>Metres between the tip of a part and the ground.</summary>
    private const double Clearance = 0.045;

    /// <summary>By which share of its length the tip of a part may be lower than its body's sections tell: the skin of a face leans as it will.</summary>
    private const double Uncertain = 0.08;

    // How a part that dips into the ground on its way to the tip is cut.
    private const double Shortening = 0.85;
    private const int MaxCuts = 12;

    // Length of a sting and radius of its root in half widths of the tail's tip, which it goes on from, and its length at most relative to the tail: on the stub of a thick one it is a blade.
    private const double StingLength = 3.2;
    private const double StingRoot = 0.8;
    private const double LongestSting = 0.22;

    /// <summary>Probability that what does not swim wears the lure of its family: there is nothing in the dark for it to draw.</summary>
    private const double LuredOnLand = 0.2;

    /// <summary>Fills in the features of the creature, as many as are asked for.</summary>
    public static void Sample(CreatureBuilder builder, OrnamentLevel level)
    {
        double plenty = level switch { OrnamentLevel.None => 0, OrnamentLevel.Sparse => 0.4, OrnamentLevel.Rich => 2, _ => 1 };
        Ornaments(builder, plenty);
        NeckSampler.Tail(builder, builder.Stream("tail hair"));
        FaceRule.Clear(builder);
        Mouthparts.Add(builder);
        Sting(builder);
        StrangeParts.Add(builder);
    }

    private static void Ornaments(CreatureBuilder builder, double plenty)
    {
        double head = builder.Shape.Width[StationRing.Cranium];
        if (builder.Parents.Ornaments.Parts is PartSlot[] slots)
        {
            OwnParts(builder, slots, plenty, builder.Stream("own parts"));
            return;
        }

        if (builder.Parents.Ornaments.Class == AnimalClass.Arthropod)
        {
            InsectHead(builder, builder.Stream("insect head"));
            return;
        }

        bool horned = Horns(builder, head, plenty, builder.Stream("horns"));
        horned |= !horned && NeckSampler.Collar(builder, plenty, builder.Stream("collar"));
        Tuft(builder, head, horned, plenty, builder.Stream("tuft"));
        if (!horned)
        {
            Tusks(builder, head, plenty, builder.Stream("tusks"));
        }

        if (!IsCrested(builder) && !NeckSampler.Hair(builder, plenty, builder.Stream("hair")))
        {
            Back(builder, horned, plenty, builder.Stream("back"));
        }

        TailEnd(builder, plenty, builder.Stream("tail end"));
    }

    /// <summary>From each slot of a species one choice.</summary>
    private static void OwnParts(CreatureBuilder builder, PartSlot[] slots, double plenty, RandomStream random)
    {
        double head = builder.Proportions.Head;
        foreach (PartSlot slot in slots)
        {
            double[] weights = new double[slot.Choices.Length];
            for (int i = 0; i < weights.Length; i++)
            {
                weights[i] = slot.Choices[i].Weight * (slot.Choices[i].IsEmpty ? 1 / Math.Max(plenty, 1e-6) : 1);
            }

            PartChoice choice = slot.Choices[random.Weighted(weights)];
            double size = random.Uniform();
            if (IsCrested(builder) && OnBack(choice))
            {
                continue;
            }

            if (choice.Mane is ManePreset mane)
            {
                NeckSampler.Add(builder, mane, size);
            }

            if (choice.Frill is FrillPreset frill)
            {
                NeckSampler.Add(builder, frill, size);
            }

            foreach (PartPreset preset in choice.Parts)
            {
                FeatureBlueprint part = preset.Part;
                if (part.Kind == FeatureKind.Lure && builder.Kind != LocomotionKind.Swimming && !builder.Stream("lure").Chance(LuredOnLand))
                {
                    continue;
                }

                double factor = Maths.Scalar.Lerp(preset.Min, preset.Max, size) * (part.Ring < StationRing.Nape ? head : 1);
                builder.Features.Add(OffGround(builder, part with { Length = part.Length * factor, Radius = part.Radius * Math.Sqrt(factor) }));
            }
        }
    }

    /// <summary>Whether a creature on land wears a fin along its back already.</summary>
    private static bool IsCrested(CreatureBuilder builder) => builder.Kind != LocomotionKind.Swimming && builder.Fins.Exists(fin => fin.Place == FinPlace.Dorsal);

    /// <summary>Whether a choice stands along the midline of the back.</summary>
    private static bool OnBack(PartChoice choice) =>
        choice.Mane != null || Array.Exists(choice.Parts, part => part.Part.Segment < 3 && part.Part.Ring is > StationRing.Nape and < StationRing.TailFirst);

    /// <summary>The sting at the end of a scorpion's tail.</summary>
    private static void Sting(CreatureBuilder builder)
    {
        if (builder.Tail.Style == TailStyle.Stinger)
        {
            BodyShape s = builder.Shape;
            double tail = s.Arc[BodyGrid.Rings - 1] - s.Arc[StationRing.TorsoLast];
            double radius = Math.Min(s.Width[BodyGrid.Rings - 2], LongestSting * tail / StingLength);
            builder.Features.Add(new FeatureBlueprint(FeatureKind.Horn, BodyGrid.Rings - 1, Segment: 0, Length: StingLength * radius, Radius: StingRoot * radius, Outward: 0.1, Upward: 0, Forward: -1, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1));
        }
    }

    /// <summary>The part of a walker, bent up until its tip clears the ground, and shortened if it dips into it on the way.</summary>
    public static FeatureBlueprint OffGround(CreatureBuilder builder, FeatureBlueprint part)
    {
        if (!builder.IsOnGround)
        {
            return part;
        }

        BodyShape s = builder.Shape;
        int ring = (int)part.Ring;
        double pitch = s.Pitch[ring];
        double around = Maths.PortableMath.Cos(Maths.PortableMath.Tau * part.Segment / BodyGrid.Segments);
        double root = s.Y[ring] + (around * Maths.PortableMath.Cos(pitch) * (around > 0 ? s.Top[ring] : s.Bottom[ring]));
        double rise = (part.Outward * around) + part.Upward + (part.Forward * Maths.PortableMath.Sin(pitch));
        double size = Math.Sqrt((part.Outward * part.Outward) + (part.Upward * part.Upward) + (part.Forward * part.Forward) + (part.Sideward * part.Sideward));
        double min = Clearance + (2 * part.Radius) + (Uncertain * part.Length);
        double missing = min - root - (part.Length * ((rise / size) + part.BendUp));
        part = missing > 0 ? part with { BendUp = Math.Min(3, part.BendUp + (missing / part.Length)) } : part;
        for (int cut = 0; cut < MaxCuts && root + (part.Length * Dip(rise / size, part.BendUp)) < min; cut++)
        {
            part = part with { Length = Shortening * part.Length };
        }

        return part;
    }

    /// <summary>The lowest that a part of length 1 reaches, which leaves the skin with a slope and is bent up with the square of the way.</summary>
    private static double Dip(double slope, double bend) =>
        slope < 0 && bend > 0 && -slope < 2 * bend ? -slope * slope / (4 * bend) : Math.Min(0, slope + bend);

    private static bool Horns(CreatureBuilder builder, double head, double plenty, RandomStream random)
    {
        double chance = builder.Parents.Ornaments.HeadOrnament.Horns * plenty;
        chance *= builder.Signature == Signature.BigEyes ? 0.4 : 1;
        chance *= builder.Kind == LocomotionKind.Swimming ? 0.25 : 1;
        bool eared = builder.Ears.Count > 0 && !builder.Parents.Ornaments.HornsBesideEars;
        bool nose = builder.Plan is BodyPlan.Columnar or BodyPlan.Plantigrade or BodyPlan.Unguligrade;
        if (eared || !random.Chance(chance))
        {
            return false;
        }

        double length = head * random.Uniform(0.9, 2.0);
        double radius = head * random.Uniform(0.16, 0.25);
        bool deer = builder.Plan is BodyPlan.Unguligrade or BodyPlan.Digitigrade && builder.Parents.Ornaments.Antlered;
        int style = random.Weighted(stackalloc double[] { 1, 1, 0.7, nose ? 0.35 : 0, deer ? 1.1 : 0 });
        builder.Features.Add(style switch
        {
            0 => new FeatureBlueprint(FeatureKind.Horn, Ring: 13, Segment: 2.6, Length: length, Radius: radius, Outward: 0, Upward: 0.87, Forward: -0.09, Sideward: 0.48, BendUp: 0.15, BendForward: 0.25, BendSide: -0.25, Flatness: 1, Taper: 1),
            1 => new FeatureBlueprint(FeatureKind.Horn, Ring: 13, Segment: 2.6, Length: length, Radius: radius, Outward: 0, Upward: 0.50, Forward: -0.81, Sideward: 0.32, BendUp: -0.35, BendForward: -0.10, BendSide: 0.10, Flatness: 1, Taper: 1),
            2 => new FeatureBlueprint(FeatureKind.Horn, Ring: 13, Segment: 2.6, Length: length, Radius: radius, Outward: 0, Upward: 0.24, Forward: -0.24, Sideward: 0.94, BendUp: 0.65, BendForward: 0.45, BendSide: -0.20, Flatness: 1, Taper: 1),
            4 => new FeatureBlueprint(FeatureKind.Antler, Ring: 13, Segment: 2.6, Length: length * 1.5, Radius: radius * 0.62, Outward: 0, Upward: 0.80, Forward: -0.35, Sideward: 0.55, BendUp: 0.2, BendForward: 0.1, BendSide: 0.15, Flatness: 1, Taper: 1),
            _ => new FeatureBlueprint(FeatureKind.Horn, Ring: 3, Segment: 0, Length: length, Radius: radius * 1.2, Outward: 0.87, Upward: 0, Forward: 0.48, Sideward: 0, BendUp: 0, BendForward: -0.35, BendSide: 0, Flatness: 1, Taper: 1),
        });
        return true;
    }

    /// <summary>A bird's crest.</summary>
    private static void Tuft(CreatureBuilder builder, double head, bool horned, double plenty, RandomStream random)
    {
        if (builder.Kind == LocomotionKind.Swimming || horned || !random.Chance(builder.Parents.Ornaments.Crest * plenty))
        {
            return;
        }

        const int count = 5;
        for (int q = 0; q < count; q++)
        {
            double ring = 12 + (q * 0.9);
            double length = head * 0.9 * (1 - (0.5 * Math.Abs((q / (count - 1.0)) - 0.35)));
            builder.Features.Add(new FeatureBlueprint(FeatureKind.Tuft, ring, Segment: 0, Length: length, Radius: head * 0.2, Outward: 0.73, Upward: 0, Forward: -0.68, Sideward: 0, BendUp: 0, BendForward: -0.3, BendSide: 0, Flatness: 0.5, Taper: 0.7));
        }
    }

    /// <summary>One thing along the back: spikes, plates, a sail or a shell.</summary>
    private static void Back(CreatureBuilder builder, bool horned, double plenty, RandomStream random)
    {
        bool plain = builder.Kind == LocomotionKind.Swimming;
        bool plated = builder.Parents.Ornaments.Plated;
        bool grounded = builder.Kind == LocomotionKind.Walking;
        double chance = (plain ? 0 : builder.Parents.Ornaments.BackRow) * plenty;
        bool shelled = grounded && builder.Parents.Ornaments.Shelled && builder.Plan is BodyPlan.Sprawling or BodyPlan.Plantigrade or BodyPlan.Columnar;
        int style = random.Weighted(stackalloc double[] { 1, plated ? 0.8 : 0, grounded && plated ? 0.9 : 0, shelled ? 0.6 : 0 });
        int count = random.Integer(7, 13);
        double height = random.Uniform(0.06, 0.13);
        double sail = random.Uniform(0.12, 0.26);
        bool spiny = random.Chance(0.4);
        if (!random.Chance(horned && style < 2 ? chance * 0.4 : chance))
        {
            return;
        }

        switch (style)
        {
            case 0:
                Row(builder, FeatureKind.Spike, count, height, 0.3, 1, 1);
                break;
            case 1:
                Row(builder, FeatureKind.Plate, count, 1.35 * height, 0.62, 0.22, 0.55);
                break;
            case 2:
                Sail(builder, sail, spiny, random.Integer(7, 10));
                break;
            default:
                builder.Shell = new ShellBlueprint(ShellStyle.Carapace, Ring: 24, Rows: 19, Columns: 5, Rise: 0.16);
                break;
        }
    }

    private static void Row(CreatureBuilder builder, FeatureKind kind, int count, double height, double breadth, double flatness, double taper)
    {
        BodyShape s = builder.Shape;
        for (int q = 0; q < count; q++)
        {
            double ring = 18 + (30.0 * q / (count - 1));
            double length = height * (0.35 + (0.65 * Maths.PortableMath.Sin(Maths.PortableMath.Pi * (q + 0.6) / (count + 0.2)))) * Maths.Scalar.Clamp(s.Top[(int)ring] / 0.12, 0.35, 1.2);
            double lean = kind == FeatureKind.Plate ? -0.2 : -0.48;
            builder.Features.Add(new FeatureBlueprint(kind, ring, Segment: 0, Length: length, Radius: length * breadth, Outward: 0.88, Upward: 0, Forward: lean, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: flatness, Taper: taper));
        }
    }

    /// <summary>A fin on dry land.</summary>
    private static void Sail(CreatureBuilder builder, double height, bool spiny, int pairsOfRows)
    {
        var socket = new SocketBlueprint(23, 31, 2 * pairsOfRows, 2);
        if (builder.Sockets.TryReserve(socket, 0))
        {
            builder.Fins.Add(new FinBlueprint(FinPlace.Dorsal, spiny ? FinStyle.Spiny : FinStyle.Sail, socket, height, 0, 0, 0.35));
        }
    }

    /// <summary>A club or spikes at the end of a strong tail.</summary>
    private static void TailEnd(CreatureBuilder builder, double plenty, RandomStream random)
    {
        bool strong = builder.Kind == LocomotionKind.Walking
            && builder.Tail.Style == TailStyle.Plain
            && builder.Parents.Ornaments.ArmedTail
            && builder.Parents.Tail.Class != AnimalClass.Arthropod
            && builder.Plan is BodyPlan.Sprawling or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Theropod;
        bool club = random.Chance(0.5);
        if (!random.Chance(0.25 * plenty) || !strong)
        {
            return;
        }

        BodyShape s = builder.Shape;
        double radius = Math.Max(0.035, 1.5 * s.Width[StationRing.TailThird]);
        if (!TailClears(builder, radius))
        {
            return;
        }

        if (club)
        {
            builder.Features.Add(new FeatureBlueprint(FeatureKind.Club, Ring: 52, Segment: 0, Length: 2.1 * radius, Radius: 0.85 * radius, Outward: 0.1, Upward: 0, Forward: -1, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1.2, Taper: 0.4));
        }

        for (int k = 0; k < 3; k++)
        {
            builder.Features.Add(new FeatureBlueprint(FeatureKind.Spike, 46 + (2 * k), Segment: 4, Length: 1.4 * radius, Radius: 0.3 * radius, Outward: 0.9, Upward: 0.1, Forward: -0.4, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1));
        }
    }

    /// <summary>Whether the tail is high enough for a club, if there is one.</summary>
    public static bool TailClears(CreatureBuilder builder, ValueList<FeatureBlueprint> parts)
    {
        double radius = 0;
        foreach (FeatureBlueprint part in parts)
        {
            radius = part.Kind == FeatureKind.Club || (part.Kind == FeatureKind.Spike && part.Ring >= StationRing.TailFirst && part.Segment > 0) ? Math.Max(radius, part.Radius / 0.85) : radius;
        }

        return radius == 0 || TailClears(builder, radius);
    }

    private static bool TailClears(CreatureBuilder builder, double radius)
    {
        for (int ring = StationRing.TailFirst; ring < BodyGrid.Rings; ring++)
        {
            if (builder.Shape.Y[ring] < (1.2 * radius) + Clearance)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Tusks where there are no horns.</summary>
    private static void Tusks(CreatureBuilder builder, double head, double plenty, RandomStream random)
    {
        bool fits = builder.Kind == LocomotionKind.Walking
            && builder.Plan is BodyPlan.Columnar or BodyPlan.Plantigrade or BodyPlan.Unguligrade or BodyPlan.Upright
            && builder.Parents.Ornaments.Tusked;
        double length = head * random.Uniform(0.5, 1.1);
        if (random.Chance(0.25 * plenty) && fits)
        {
            builder.Features.Add(OffGround(builder, new FeatureBlueprint(FeatureKind.Tusk, Ring: 4, Segment: 10.6, Length: length, Radius: 0.15 * length, Outward: 0.2, Upward: -0.25, Forward: 0.7, Sideward: 0.3, BendUp: 0.45, BendForward: 0.1, BendSide: 0, Flatness: 1, Taper: 0.9)));
        }
    }

    private static void InsectHead(CreatureBuilder builder, RandomStream random)
    {
        double length = random.Uniform(0.25, 0.5);
        builder.Features.Add(new FeatureBlueprint(FeatureKind.Antenna, Ring: 6, Segment: 3, Length: length * 1.3, Radius: 0.012, Outward: 0, Upward: 0.76, Forward: 0.53, Sideward: 0.34, BendUp: -0.35, BendForward: 0.27, BendSide: 0.08, Flatness: 1, Taper: 0.6));
        builder.Features.Add(new FeatureBlueprint(FeatureKind.Mandible, Ring: 2, Segment: 10, Length: 0.11, Radius: 0.024, Outward: 0, Upward: -0.18, Forward: 0.95, Sideward: -0.1, BendUp: 0, BendForward: 0, BendSide: -0.27, Flatness: 1, Taper: 1));
    }
}
