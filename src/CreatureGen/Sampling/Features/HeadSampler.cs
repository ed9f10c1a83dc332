using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>Draws the face: bumps of the skull, eyes, mouth, nostrils, ears.</summary>
internal static class HeadSampler
{
    /// <summary>Metres between an open jaw and the ground, with room for the chin and the gap between closed lips.</summary>
    private const double JawClearance = 0.05;

    // Largest eyes of strange creatures, relative to those of the animal whose head it is: on a body of its own, and on one of another.
    private const double OwnEyes = 0.85;
    private const double MixedEyes = 0.62;

    /// <summary>Size of eyes on top of the head of a strange creature, relative to those of the animal that has them there: they stand clear of it, so that all of them is seen.</summary>
    private const double EyesOnTop = 0.84;

    // On a skull of another body: radius of the largest eyes in half heights of the head, and least depth of their centres below the skin in radii; larger and higher ones are goggles.
    private const double FlatEyes = 0.42;
    private const double MixedSink = 0.5;

    /// <summary>Greatest depth of the centres of a strange creature's eyes below the skin, in radii: those of horses and cattle are seen neither from the front nor from the side where they are deeper.</summary>
    private const double DeepestSink = 0.56;

    // On a skull of another body: radius of the smallest eyes in half heights of the head, of those on top of it, and the lowest segment that they are at: sharks' and dolphins' are not seen from the front.
    private const double SmallestEye = 0.36;
    private const double SmallestOnTop = 0.29;
    private const double LowestEye = 5.7;

    // The same of an insect's face, and how far its eyes look ahead at least: those of ants and beetles are specks at the rim of a plate. A part of what kinds differ by stays.
    private const double SmallestFaceted = 0.52;
    private const double LowestFaceted = 5.9;
    private const double FacetedAhead = 0.8;
    private const double FacetedShare = 0.75;

    /// <summary>The same of a strange creature's own head: a rhino's, a boar's or a bear's are specks from the front.</summary>
    private const double SmallestOwn = 0.29;

    /// <summary>Probability of a single eye at full strangeness.</summary>
    private const double SingleEyes = 0.05;

    // Widest that lids of another body's head, and of eyes on top of any, are open on a strange creature, degrees above and below the gaze: wider, a frog's eyes are goggles.
    private const double WidestUpper = 50;
    private const double WidestOnTop = 42;
    private const double WidestLower = 54;

    // A single eye: its largest radius in halves of the head, how deep it sits, in radii, and how far it looks ahead.
    private const double LargestSingle = 0.46;
    private const double SingleSink = 0.36;
    private const double SingleForward = 0.9;

    // A face below the beak of another body: how far the ridge along its top rises, and how far its sides are flat below it, in radii of the section: a round one is a disc from the front.
    private const double Ridge = 0.2;
    private const double Sides = 0.14;

    // An insect's face of a strange creature: depth of the grooves above and below the shield over its jaws, and how far that stands out, in radii of the section.
    private const double UpperGroove = 0.1;
    private const double LipGroove = 0.16;
    private const double FaceShield = 0.07;

    // Breadth of a head in heights from which on its top is a board, and what models it where it is twice that: a rise along the middle, and hollows to both sides of it and below the eyes.
    private const double Level = 0.9;
    private const double Bridge = 0.16;
    private const double Hollow = 0.14;

    // A strange face ashore: how far the bridge of the nose rises, and how deep the planes beside it are, in radii of the section; without them a muzzle is a blank plate from the front.
    private const double NoseBridge = 0.11;
    private const double BesideNose = 0.1;

    // How far the crown is above the eyes, in their radii, most that it rises for that, in radii of its section, and the part of it over eyes on top of the head.
    private const double AboveEyes = 0.8;
    private const double HighestCrown = 0.3;
    private const double OfFrogs = 0.4;

    // A nape and a throat behind the head of another body in the water, where necks are thick: how far they are drawn in, in radii of the section, and the breadth of the neck, in that of the head, from which on they are, and at which they wholly are.
    private const double Nape = 0.14;
    private const double NapeFrom = 0.6;
    private const double NapeWhole = 0.95;

    /// <summary>How far the middle of the skull rises where it is as broad as a board and more: flat between the eyes it is a lid.</summary>
    private const double Vault = 0.24;

    // By how much skulls ashore differ in how far they rise: all alike, those of one build are doubles of one another.
    private const double LowestSkull = 0.75;
    private const double HighestSkull = 1.3;

    // How far ahead eyes ashore are drawn to look, and by how much of what they lack.
    private const double LooksAhead = 0.95;
    private const double AheadShare = 0.75;

    /// <summary>The part of that on a swimmer's head that is no board: what comes head first is seen over its nose, and without a bridge that is a blank plate.</summary>
    private const double LeastBridge = 0.55;

    /// <summary>How far the eyes of a mixed swimmer look ahead at least: those that look aside are slits at the edge of a face without eyes.</summary>
    private const double Ahead = 0.6;

    /// <summary>Highest ridge of the brow on a strange head, relative to its section: a higher one is a corner of a box.</summary>
    private const double HighestBrow = 0.12;

    /// <summary>The same on a head that is as broad as a board: there it ends in a corner to both sides.</summary>
    private const double HighestOnBoard = 0.04;

    /// <summary>The part of the bones over the eyes that a strange swimmer lacks.</summary>
    private const double SoftenedBone = 0.6;

    /// <summary>Least bones around the eyes of a strange creature that does not swim: a face without brows, sockets and cheeks is a ball or a cone with eyes on it.</summary>
    private const double LeastBone = 0.7;

    /// <summary>The segment at which eyes are on top of the head, as frogs' are: they stand above it, and brows between them would level it.</summary>
    private const double OnTop = 4.2;

    // Broadest front of a muzzle against its head of what swims, or has the head of another body, and most that it is drawn in by: what comes head first is seen over its muzzle, and a broader one is all of its face.
    private const double Muzzle = 0.58;
    private const double DrawnIn = 0.3;

    // The same in the water, where the lens is before the nose.
    private const double MuzzleInWater = 0.5;
    private const double DrawnInWater = 0.38;

    /// <summary>Mean of half the width and half the height of a head at the eyes, metres.</summary>
    public static double HalfHeight(BodyShape shape) => 0.5 * (shape.Width[StationRing.Brow] + (0.5 * (shape.Top[StationRing.Brow] + shape.Bottom[StationRing.Brow])));

    /// <summary>Width of a head at the eyes in heights.</summary>
    private static double Breadth(BodyShape shape) => 2 * shape.Width[StationRing.Brow] / (shape.Top[StationRing.Brow] + shape.Bottom[StationRing.Brow]);

    /// <summary>Width of the front of the muzzle against the widest of the head.</summary>
    private static double MuzzleBreadth(BodyShape shape) =>
        Math.Max(shape.Width[StationRing.MuzzleFront], shape.Width[StationRing.MuzzleMiddle]) / Math.Max(shape.Width[StationRing.Brow], shape.Width[StationRing.Cranium]);

    /// <summary>Size of the neck behind the head against the largest of the head.</summary>
    private static double NeckBreadth(BodyShape shape) =>
        Math.Sqrt(shape.Width[StationRing.Nape] * (shape.Top[StationRing.Nape] + shape.Bottom[StationRing.Nape]) / (shape.Width[StationRing.Cranium] * (shape.Top[StationRing.Cranium] + shape.Bottom[StationRing.Cranium])));

    /// <summary>Radius of the largest eyes that a head has room for, metres.</summary>
    public static double LargestEye(CreatureBuilder builder)
    {
        // On a head that is mixed with larger ones, the eyes of an insect or a frog would be goggles.
        double mixed = builder.Parents.Head == builder.Parents.First ? Scalar.Lerp(1, OwnEyes, builder.Strangeness) : Scalar.Lerp(1, MixedEyes, builder.Fitting);
        BodyShape s = builder.Shape;
        double largest = mixed * builder.Parents.Head.LargestEye * HalfHeight(s);
        double flat = FlatEyes * 0.5 * (s.Top[StationRing.Brow] + s.Bottom[StationRing.Brow]);
        return Math.Min(largest, Scalar.Lerp(largest, flat, Mixed(builder)));
    }

    /// <summary>How far a face on the skull of another body is fitted to it, 0..1; insects' eyes are large on any.</summary>
    private static double Mixed(CreatureBuilder builder) => builder.Parents.Head != builder.Parents.First && builder.Parents.Head.Class != AnimalClass.Arthropod ? builder.Fitting : 0;

    /// <summary>The face of the creature.</summary>
    public static HeadBlueprint Sample(CreatureBuilder builder)
    {
        SpeciesProfile species = builder.Parents.Head;
        RandomStream random = builder.Stream("face");
        double mood = random.Normal(0, 0.5) + species.Mood;
        double smile = Scalar.Clamp(random.Normal(0.25, 0.4) - (0.35 * mood), -0.7, 1);
        EyeBlueprint eyes = Eyes(builder, mood);
        return new HeadBlueprint(Bumps(builder, mood, eyes), species.MuzzleSquareness, eyes, Mouth(builder, smile), species.Nostril, BeakSampler.Sample(builder));
    }

    /// <summary>Adds ears to the creature.</summary>
    public static void AddEars(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("ears");
        if (builder.Kind == LocomotionKind.Swimming || !random.Chance(builder.Parents.Ears.HeadOrnament.Ears))
        {
            return;
        }

        double head = builder.Parents.Ears.EarSize * builder.Shape.Width[StationRing.Cranium];
        double size = random.Uniform(0.85, 1.2) * head;
        EarShape shape = builder.Parents.Ears.Ears[random.Weighted(Array.ConvertAll(builder.Parents.Ears.Ears, ear => ear.Weight))].Value;
        var socket = new SocketBlueprint(13, shape == EarShape.Sideways ? 4 : 2, 2, 2);
        EarBlueprint ear = shape switch
        {
            EarShape.Drooping => new EarBlueprint(socket, 1.15 * size, 0.42 * head, Outward: 0.9, Upward: 0.45, Forward: -0.1, Droop: 0.9, Roundness: 0),
            EarShape.Big => new EarBlueprint(socket, 2.0 * size, 0.5 * head, Outward: 0.55, Upward: 1, Forward: -0.35, Droop: 0, Roundness: 0),
            EarShape.Round => new EarBlueprint(socket, 0.75 * size, 0.48 * head, Outward: 0.6, Upward: 0.9, Forward: -0.15, Droop: 0, Roundness: 1),
            EarShape.Sideways => new EarBlueprint(socket, 1.15 * size, 0.36 * head, Outward: 1, Upward: 0.12, Forward: -0.25, Droop: 0.35, Roundness: 0),
            EarShape.Long => new EarBlueprint(socket, 2.9 * size, 0.40 * head, Outward: 0.22, Upward: 1, Forward: -0.3, Droop: 0, Roundness: 0.4),
            _ => new EarBlueprint(socket, 1.15 * size, 0.42 * head, Outward: 0.38, Upward: 1, Forward: -0.25, Droop: 0, Roundness: 0),
        };
        if (builder.Sockets.TryReserve(socket, 0))
        {
            builder.Ears.Add(ear);
        }
    }

    private static ValueList<HeadBump> Bumps(CreatureBuilder builder, double mood, EyeBlueprint eyes)
    {
        SpeciesProfile species = builder.Parents.Head;
        RandomStream random = builder.Stream("skull");
        var bumps = new List<HeadBump>();

        // What goes on legs keeps its head: its gaits were tuned to where its weight lies.
        double fitting = builder.Kind == LocomotionKind.Swimming ? builder.Fitting : 0;
        double ashore = builder.Kind == LocomotionKind.Swimming ? 0 : builder.Fitting;
        double flat = Scalar.Clamp(Breadth(builder.Shape) - Level, 0, 1);
        double brow = Vary(species.Swelling.Brow);
        Add(9.2, 4.2, 1.6, 1.3, Math.Min(brow, Scalar.Lerp(brow, Scalar.Lerp(HighestBrow, HighestOnBoard, Math.Min(1, 2.5 * flat)), fitting)));
        Add(8.4, 1.0, 1.5, 1.6, -Vary(0.05));
        Add(12.8, 9.2, 2.2, 2.0, Vary(species.Swelling.Cheek));
        Add(13.2, 12.5, 1.8, 1.8, IfAny(species.Skull.Jowl));
        Add(1.2, 7.0, 1.6, 2.2, IfAny(species.Skull.Lips));
        Add(7.5, 7.5, 1.4, 2.2, -IfAny(species.Skull.Stop));
        Add(2.5, 15.5, 2.0, 2.5, IfAny(species.Skull.Chin));
        double sockets = builder.Kind == LocomotionKind.Swimming || species.Class == AnimalClass.Arthropod || species.Snout == SnoutKind.Beak ? species.Bone : Math.Max(species.Bone, LeastBone * builder.Fitting * Scalar.Clamp(species.Eye.Segment - OnTop, 0, 1));
        if (sockets > 0)
        {
            // Bones around the eyes of what comes head first are corners of its outline.
            double bone = sockets * (1 - (SoftenedBone * fitting));
            (double ring, double segment) = species.Eye;
            Add(ring - 0.6, segment + 0.2, 1.5, 1.25, -0.13 * sockets);
            Add(ring - 1.6, segment - 1.9, 1.2, 1.1, 0.11 * bone * (1 + (0.5 * mood)));
            Add(ring + 1.2, segment - 2.0, 1.4, 1.1, 0.11 * bone * (1 - (0.4 * mood)));
            Add(ring + 1.2, segment + 2.9, 1.9, 1.2, 0.10 * sockets);
        }

        if (species.Snout != SnoutKind.Beak && species.Class != AnimalClass.Arthropod)
        {
            // Between its eyes a broad head is a board without a bridge of the nose, hollows beside it, and cheekbones.
            double board = Math.Max(fitting * Math.Max(flat, LeastBridge), Mixed(builder) * flat);
            Add(6, 0, 3.2, 1.5, Bridge * board);
            Add(7, 3.2, 2.2, 1.3, -Hollow * board);
            Add(6.2, 7.6, 2, 1.3, -Hollow * board);
            Add(5.6, 0, 2.7, 1.1, NoseBridge * ashore);
            Add(6.6, 2.9, 2, 1.2, -BesideNose * ashore);
            Rise(ashore);
            (double broadest, double drawnIn) = builder.Kind == LocomotionKind.Swimming ? (MuzzleInWater, DrawnInWater) : (Muzzle, DrawnIn);
            Add(3, 8, 2.4, 16, -Math.Max(fitting, Mixed(builder)) * Scalar.Clamp(1 - (broadest / MuzzleBreadth(builder.Shape)), 0, drawnIn));
        }

        if (species.Snout == SnoutKind.Beak)
        {
            double mixed = Mixed(builder);
            Add(2, 0, 3.6, 1.2, Ridge * mixed);
            Add(2, 3.4, 3.2, 1.5, -Sides * mixed);
            Rise(ashore);
        }

        if (species.Class == AnimalClass.Arthropod)
        {
            Add(6, 0, 0.7, 3.4, -UpperGroove * builder.Fitting);
            Add(3.6, 0, 1.5, 3.2, FaceShield * builder.Fitting);
            Add(1.4, 0, 0.6, 4.6, -LipGroove * builder.Fitting);
        }

        if (builder.Kind == LocomotionKind.Swimming && species.Class != AnimalClass.Arthropod && builder.Parents.Head != builder.Parents.First && builder.Species.Disc.Sweep == 0)
        {
            Add(16.6, 8, 1.7, 16, -Nape * builder.Fitting * Scalar.Smooth((NeckBreadth(builder.Shape) - NapeFrom) / (NapeWhole - NapeFrom)));
        }

        bumps.AddRange(species.Skull.Muzzle);
        return new ValueList<HeadBump>(bumps);

        void Rise(double share)
        {
            double own = share * builder.Stream("crown").Uniform(LowestSkull, HighestSkull);
            Add(12, 0, 2.2, 4.2, own * Crown(builder.Shape, eyes, species.Snout == SnoutKind.Beak ? 1 : Scalar.Clamp(eyes.Segment - OnTop, OfFrogs, 1)));
            Add(11, 0, 3, 3, own * Vault * Scalar.Smooth(Breadth(builder.Shape) - Level));
        }

        double IfAny(double amount) => amount == 0 ? 0 : Vary(amount);

        double Vary(double amount) => amount * Scalar.Clamp(random.Normal(1, 0.45), 0.2, 2);

        void Add(double ring, double segment, double ringSpread, double segmentSpread, double amount)
        {
            if (amount != 0)
            {
                bumps.Add(new HeadBump(ring, segment, ringSpread, segmentSpread, amount));
            }
        }
    }

    /// <summary>How far the crown of the skull has to rise to be above the eyes, relative to its section: level with them it is sawn off from the front. Those of eyes on top of the head stay above it.</summary>
    private static double Crown(BodyShape shape, EyeBlueprint eyes, double share)
    {
        double height = PortableMath.Cos(eyes.Segment * PortableMath.Tau / BodyGrid.Segments);
        double top = (shape.Top[StationRing.Brow] * height) + (eyes.Radius * (1 + AboveEyes - (eyes.Sink * height)));
        double lacks = Math.Max(0, (top / shape.Top[StationRing.Cranium - 1]) - 1) * share;
        return HighestCrown * (1 - PortableMath.Exp(-lacks / HighestCrown));
    }

    private static EyeBlueprint Eyes(CreatureBuilder builder, double mood)
    {
        SpeciesProfile species = builder.Parents.Head;
        RandomStream random = builder.Stream("eyes");
        BodyShape s = builder.Shape;
        double half = HalfHeight(s);
        double radius = species.EyeSize * half * Scalar.Clamp(1 + (0.14 * builder.Style) + random.Normal(0, 0.06), 0.75, 1.5) * (builder.Signature == Signature.BigEyes ? 1.36 : 1);
        radius = Math.Min(radius, LargestEye(builder));
        double mixed = Mixed(builder);
        double onTop = builder.Fitting * Scalar.Clamp(1 + OnTop - species.Eye.Segment, 0, 1);
        double smallest = Math.Max(mixed * Scalar.Lerp(SmallestEye, SmallestOnTop, onTop), builder.Fitting * SmallestOwn * (1 - onTop));
        radius = Math.Max(radius * Scalar.Lerp(1, EyesOnTop, onTop), smallest * half);
        double insect = species.Class == AnimalClass.Arthropod && species.EyeStyle != EyeStyle.Bead ? builder.Fitting : 0;
        radius += FacetedShare * insect * Math.Max(0, (SmallestFaceted * half) - radius);
        bool faceted = random.Chance(species.CompoundEyes);
        bool slit = random.Chance(species.SlitPupils);
        bool bar = builder.Stream("bar pupils").Chance(species.BarPupils);
        EyeStyle style = species.EyeStyle != EyeStyle.Round ? species.EyeStyle : faceted ? EyeStyle.Compound : slit ? EyeStyle.Slit : bar ? EyeStyle.Bar : EyeStyle.Round;
        if (builder.Stream("single eye").Chance(SingleEyes * builder.Strangeness) && species.Class != AnimalClass.Arthropod && species.Snout != SnoutKind.Beak && !FaceRule.IsHidden(builder))
        {
            double large = Math.Min(1.35 * radius, LargestSingle * half);
            return new EyeBlueprint(style, species.Eye.Ring - 1.2, 0, large, SingleSink, SingleForward, Scalar.Radians(58), Scalar.Radians(60), 0);
        }

        double upper = Scalar.Clamp(species.LidDegrees.Upper - (9 * mood), 34, 72);
        double lower = species.LidDegrees.Lower;
        if (species.EyeRim == EyeRim.Lids)
        {
            double lidded = Math.Max(mixed, onTop);
            upper = Math.Min(upper, Scalar.Lerp(upper, Scalar.Lerp(WidestUpper, WidestOnTop, onTop), lidded));
            lower = Math.Min(lower, Scalar.Lerp(lower, WidestLower, lidded));
        }

        double sink = Math.Max(species.EyeSink, Scalar.Lerp(species.EyeSink, MixedSink, mixed));
        sink = Math.Min(sink, Scalar.Lerp(sink, DeepestSink, builder.Fitting));
        double segment = Math.Min(species.Eye.Segment, Scalar.Lerp(Scalar.Lerp(species.Eye.Segment, LowestEye, mixed), LowestFaceted, FacetedShare * insect));
        return new EyeBlueprint(style, species.Eye.Ring, segment, radius, sink, Math.Max(Forward(builder), FacetedAhead * insect), Scalar.Radians(upper), Scalar.Radians(lower), 0.42 * mood);
    }

    /// <summary>How far eyes look ahead: those of strange creatures are seen from the front, where others are slits at the edge of a mask. Eyes on top of the head are seen from there as they are, and turned ahead they would be lids from the side.</summary>
    private static double Forward(CreatureBuilder builder)
    {
        SpeciesProfile species = builder.Parents.Head;
        if (builder.Kind == LocomotionKind.Swimming)
        {
            return Scalar.Lerp(species.EyeForward, Math.Max(species.EyeForward, Ahead), builder.Fitting);
        }

        double ashore = species.Class == AnimalClass.Arthropod ? 0 : builder.Fitting;
        double aside = Scalar.Clamp(2 * (species.Eye.Segment - OnTop), 0, 1);
        return species.EyeForward + (AheadShare * ashore * aside * Math.Max(0, LooksAhead - species.EyeForward));
    }

    /// <summary>How far the mouth is open where no ground is in its way, radians.</summary>
    public static double Opening(CreatureBuilder builder) => Gape(builder).Opening;

    private static MouthBlueprint Mouth(CreatureBuilder builder, double smile)
    {
        SpeciesProfile species = builder.Parents.Head;
        (double opening, bool toothed) = Gape(builder);
        opening = species.MouthCorner == 0 ? 0 : Math.Min(opening, WidestOpening(builder));
        return new MouthBlueprint(species.MouthCorner, opening, smile, toothed && species.MouthCorner > 0 ? species.ToothLength : 0, species.MouthCorner == 0 ? TongueStyle.None : species.Tongue);
    }

    private static (double Opening, bool Toothed) Gape(CreatureBuilder builder)
    {
        SpeciesProfile species = builder.Parents.Head;
        RandomStream random = builder.Stream("mouth");
        double opening = CreatureBuilder.Choose(random, (0.0, 0.4), (0.10, 0.2), (0.2, 0.2), (0.32, 0.2));
        double beak = CreatureBuilder.Choose(random, (0.0, 1), (0.06, 1), (0.2, 1));
        bool toothed = random.Chance(species.Teeth);
        opening = species.Snout == SnoutKind.Beak ? beak : Math.Min(opening, species.WidestMouth);
        if (species.MouthOpenings is Weighted<double>[] own)
        {
            opening = CreatureBuilder.Choose(random, own);
        }

        return (species.MouthCorner == 0 ? 0 : opening, toothed);
    }

    /// <summary>How far a walker may open its mouth before the lower jaw touches the ground, radians.</summary>
    public static double WidestOpening(CreatureBuilder builder)
    {
        if (!builder.IsOnGround)
        {
            return double.PositiveInfinity;
        }

        BodyShape s = builder.Shape;
        int hinge = OpenJaw.HingeOf(builder);
        double jaw = s.Arc[hinge] - s.Arc[StationRing.Nose] + s.Bottom[StationRing.Nose];
        return Math.Max(0, (StanceSampler.Lowest(s, 0, hinge) - JawClearance) / jaw);
    }
}
