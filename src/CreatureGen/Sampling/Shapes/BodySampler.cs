using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Sampling.Parents;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Draws the body: which bases are mixed, proportions, posture, lattice slices and the end of the tail.</summary>
internal static class BodySampler
{
    /// <summary>Longest tail, as a factor on that of the body tables.</summary>
    private const double LongestTail = 2.4;

    /// <summary>How far the slices of a swimmer's lattice depart from 1 at full strangeness: without legs it is told apart by its outline alone.</summary>
    private const double SwimmersSpread = 0.56;

    /// <summary>Largest head of another class on an insect: on its thin legs a larger one hides the rest from the front.</summary>
    private const double LargestOnInsect = 0.9;

    /// <summary>Degrees by which the raised neck of a mixed mammal is laid down in the water: its withers would be a corner of the back.</summary>
    private const double LaidNeck = 14;

    // Degrees by which the tail of a swimmer rises and falls from its back.
    private const double RisingTail = -6;
    private const double FallingTail = 12;

    /// <summary>The part of a fan of feathers that is spread on the ground, where birds close it: spread it is an apron over the legs from behind.</summary>
    private const double ClosedFan = 0.52;

    /// <summary>How far the edges of a ray are bent at least, metres at one metre from the midline: level, it is a spindle from the side.</summary>
    private const double LeastCurl = 0.38;

    /// <summary>Fills in all of the creature that does not depend on how the creature stands.</summary>
    public static void Sample(CreatureBuilder builder)
    {
        builder.Style = builder.Stream("style").Normal(0, 1);
        builder.Blend = Blend(builder);
        builder.Signature = DrawSignature(builder);
        builder.Tail = Tail(builder);
        builder.Proportions = Proportions(builder);
        builder.Drawn = Posture(builder);
        builder.Posture = builder.Drawn;
        builder.Slices = Slices(builder);
        builder.Disc = Disc(builder);
        if (builder.Fitting > 0)
        {
            Fit(builder);
        }
        else
        {
            // Animals are of one piece: no fit changes them but that of a fan of feathers, and not to ask them saves a blueprint a twentieth of its time.
            builder.Posture = TailFit.Lower(builder);
        }

        builder.Drawn = builder.Posture;
    }

    /// <summary>Fits the parts of different bodies to one another.</summary>
    private static void Fit(CreatureBuilder builder)
    {
        builder.Slices = TailFit.Point(builder, builder.Slices);
        builder.Slices = TailFit.RunOut(builder);
        builder.Slices = TrunkFit.Gather(builder);
        builder.Slices = FaceFit.Round(builder);
        builder.Proportions = TailFit.Drive(builder);
        builder.Proportions = TrunkFit.Fit(builder);
        builder.Proportions = HeadFit.Fit(builder);
        builder.Proportions = FaceFit.Lengthen(builder);
        builder.Proportions = TailFit.Fit(builder);
        builder.Posture = TailFit.Lower(builder);
        builder.Posture = NeckFit.Carry(builder);
        builder.Posture = FaceFit.Level(builder);
    }

    private static DiscBlueprint Disc(CreatureBuilder builder)
    {
        (double sweep, double min, double max) = builder.Species.Disc;
        if (sweep == 0)
        {
            return new DiscBlueprint(0, 0);
        }

        double curl = min == max ? min : builder.Stream("disc").Uniform(min, max);
        return new DiscBlueprint(sweep, curl + (curl < 0 ? -LeastCurl : LeastCurl));
    }

    /// <summary>The parents in their shares; the head and the tail rather of those that give them.</summary>
    private static BodyBlend Blend(CreatureBuilder builder)
    {
        Parentage parents = builder.Parents;
        (double Second, double Third) torso = WeightsOf(parents.Torso);
        (double Second, double Third) head = WeightsOf(Towards(parents, parents.Head, parents.Region.Head));
        (double Second, double Third) tail = WeightsOf(Towards(parents, parents.Tail, parents.Region.Tail));
        var bodies = new[]
        {
            new MixedBody(parents.First.Body, 1, 1, 1),
            new MixedBody(parents.Second.Body, torso.Second, head.Second, tail.Second),
            new MixedBody(parents.Third.Body, torso.Third, head.Third, tail.Third),
        };
        return new BodyBlend(new ValueList<MixedBody>(bodies), parents.Head.Body, parents.Skin.Body, parents.Legs.Body);
    }

    /// <summary>lerp(lerp(A, B, w1), C, w2): the second body gets w1 (1 − w2), the third w2.</summary>
    private static (double Second, double Third) WeightsOf((double First, double Second, double Third) fractions) =>
        (fractions.Third < 1 ? fractions.Second / (1 - fractions.Third) : 0, fractions.Third);

    /// <summary>The shares in a region whose donor has at least a given share; the others keep theirs to one another.</summary>
    private static (double First, double Second, double Third) Towards(Parentage parents, SpeciesProfile donor, double min)
    {
        (double first, double second, double third) = parents.Torso;
        double fraction = donor == parents.First ? first : donor == parents.Second ? second : third;
        if (fraction >= min)
        {
            return parents.Torso;
        }

        double others = (1 - min) / (1 - fraction);
        return (donor == parents.First ? min : first * others, donor == parents.Second ? min : second * others, donor == parents.Third ? min : third * others);
    }

    private static Signature DrawSignature(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("signature");
        Signature signature = CreatureBuilder.Choose(
            random,
            (Signature.None, 0.15), (Signature.BigHead, 0.16), (Signature.LongNeck, 0.12), (Signature.BigTail, 0.12), (Signature.Hulk, 0.14),
            (Signature.Rump, 0.08), (Signature.Hump, 0.08), (Signature.BigEyes, 0.08), (Signature.LongSnout, 0.07));
        if (builder.Species.Signatures is Signature[] fitting && Array.IndexOf(fitting, signature) < 0)
        {
            return Signature.None;
        }

        bool unfit = (builder.Kind == LocomotionKind.Swimming && signature is Signature.LongNeck or Signature.Hump or Signature.Hulk)
            || (builder.Species.Class == AnimalClass.Amphibian && signature is Signature.LongNeck or Signature.LongSnout)
            || (builder.Plan == BodyPlan.Legless && signature is Signature.Hump or Signature.Rump or Signature.Hulk);
        return unfit ? (random.Chance(0.5) ? Signature.BigEyes : Signature.None) : signature;
    }

    private static BodyProportions Proportions(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("proportions");
        AnimalClass group = builder.Species.Class;
        double head = Scalar.Clamp(1.26 + (0.14 * builder.Style) + random.Normal(0, 0.05), 0.9, 1.55);
        double neck = random.LogNormal(0.22, 0.65, 1.7);
        double tail = random.LogNormal(0.25, 0.55, 1.7);
        double snout = Scalar.Clamp(PortableMath.Exp(random.Normal(-0.08 * builder.Style, 0.18)), 0.6, 1.5);
        double girth = CreatureBuilder.Around(random, 1, 0.08, 0.85, 1.2);
        double belly = CreatureBuilder.Around(random, 1, 0.07, 0.88, 1.15);
        double depth = Scalar.Clamp(PortableMath.Exp(random.Normal(-0.02, 0.22)), 0.66, 1.38);
        double wide = random.LogNormal(0.12, 0.85, 1.25);
        SpeciesProfile species = builder.Species;
        SpeciesProfile face = builder.Parents.Head;
        if (face.IsSpecies)
        {
            head = face.HeadSize.Mean + ((head - 1.26) * face.HeadSize.Variation);
            snout = PortableMath.Pow(snout, Stature.Freely(builder, face.Variety));
        }

        neck = species.IsSpecies ? PortableMath.Pow(neck, Stature.Freely(builder, species.Variety)) : neck;
        tail = builder.Parents.Tail.IsSpecies ? PortableMath.Pow(tail, Stature.Freely(builder, builder.Parents.Tail.Variety)) : tail;

        double neckGirth = 1, chest = 1, hump = 1, rump = 1, tailGirth = 1, width = 1;
        if (group == AnimalClass.Amphibian)
        {
            neck = Math.Min(neck, 0.95);
        }

        if (group == AnimalClass.Arthropod)
        {
            girth = species.IsSpecies ? girth : wide;
        }

        head = face.Class == AnimalClass.Arthropod ? Math.Min(head, 1.22) : group == AnimalClass.Arthropod ? Math.Min(head, LargestOnInsect) : head;

        switch (builder.Signature)
        {
            case Signature.BigHead:
                head = Math.Min(1.75, head * 1.25);
                neck *= 0.85;
                break;
            case Signature.LongNeck:
                neck = Math.Max(neck, 1.1) * 1.75;
                head *= 0.88;
                neckGirth = 0.84;
                break;
            case Signature.BigTail:
                tail *= 1.35;
                tailGirth = 1.5;
                break;
            case Signature.Hulk:
                chest = 1.2;
                rump = 0.9;
                break;
            case Signature.Rump:
                rump = 1.2;
                chest = 0.95;
                break;
            case Signature.Hump:
                hump = 1.5;
                break;
            case Signature.LongSnout:
                snout = Math.Max(snout, 1) * 1.5;
                break;
        }

        if (builder.Plan == BodyPlan.Theropod && group != AnimalClass.Bird)
        {
            girth *= 1.14;
            tailGirth = Math.Max(tailGirth, 1.25);
        }

        if (builder.Plan == BodyPlan.Centaur)
        {
            chest = 1.15;
        }

        if (builder.Kind == LocomotionKind.Swimming)
        {
            neck = Math.Min(neck, 1.1);
            if (group == AnimalClass.Fish && !species.IsSpecies)
            {
                head *= 0.74;
                snout *= 0.8;
                width = depth < 1 ? Scalar.Lerp(0.85, 1, (depth - 0.6) / 0.4) : Scalar.Lerp(1, 0.78, (depth - 1) / 0.6);
            }
        }

        if (TailTaper.Of(builder.Tail.Style) is TailTaper taper)
        {
            tail = Math.Min(LongestTail, tail * taper.Length);
            tailGirth *= taper.Girth;
        }

        depth = builder.Kind != LocomotionKind.Swimming ? 1 : group == AnimalClass.Fish && !species.IsSpecies ? depth : PortableMath.Pow(depth, builder.Strangeness);
        if (neck > 1.25)
        {
            head *= 0.92;
        }

        return Stature.Vary(builder, new BodyProportions(head, snout, neck, neckGirth, girth, belly, chest, hump, rump, tail, tailGirth, depth, width));
    }

    private static BodyPosture Posture(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("posture");
        double tilt = Stature.Freely(builder, builder.Species.TiltVariety);
        double neck = tilt * random.Normal(0, 9);
        double head = tilt * random.Normal(0, 6);
        double tail = tilt * random.Normal(0, 14);
        double torso = 0;
        double trunk = 0;
        double upright = random.Uniform(48, 66);
        double uprightNeck = random.Uniform(-2, 10);
        double lean = builder.Species.Bird != null ? 0 : builder.Species.Class == AnimalClass.Bird ? random.Uniform(0, 14) : random.Uniform(6, 22);

        // S1.5: one angle for the neck and one for the tail, in [0, 200° / bones]; here a moderate share of it, either way.
        double neckBend = tilt * random.Uniform(-2, 5);
        double tailBend = tilt * random.Uniform(-6, 9);
        switch (builder.Plan)
        {
            case BodyPlan.Upright:
                torso = upright - (builder.Species.Class == AnimalClass.Amphibian ? 12 : 0);
                neck = uprightNeck - (builder.Species.Class == AnimalClass.Amphibian ? 12 : 0);
                tail += 18;
                neckBend = 0;
                break;
            case BodyPlan.Theropod:
                tail *= 0.4;
                trunk = lean;
                neck += builder.Species.Class == AnimalClass.Bird ? 0 : 22;
                tail -= builder.Species.Class == AnimalClass.Bird ? 0 : 6;
                tailBend = Math.Min(tailBend, 2);
                break;
            case BodyPlan.Centaur:
                neck += 25;
                break;
            case BodyPlan.Legless:
                tailBend = 0;
                tail = 0;
                break;
        }

        if (builder.Species.Bird is not null && builder.Plan == BodyPlan.Flapping)
        {
            (double Torso, double Tail) laid = FlightPitch(builder);
            torso += laid.Torso;
            tail += laid.Tail;
        }

        if (builder.Signature == Signature.LongNeck)
        {
            neck += 8;
        }

        if (TailTaper.Of(builder.Tail.Style) is { Curl: not 0 } curled)
        {
            tail = Math.Min(tail, curled.Curl / 5);
            tailBend = curled.Curl / BodyGrid.TailBones;
        }

        if (builder.Kind == LocomotionKind.Swimming)
        {
            // Swimmers keep a straight spine (S1.5).
            neck /= 3;
            head /= 2;
            tail /= 5;
            neckBend = 0;
            tailBend = 0;
            tail -= Arch(builder);
            neck -= builder.Species.SwimmingNeckDrop + (builder.Species.Class == AnimalClass.Mammal ? LaidNeck * builder.Fitting : 0);
            head = builder.Species.SwimmingHead ?? head;
        }

        return new BodyPosture(Scalar.Radians(head), Scalar.Radians(neck), Scalar.Radians(torso), Scalar.Radians(tail), Scalar.Radians(trunk), Scalar.Radians(neckBend), Scalar.Radians(tailBend));
    }

    /// <summary>Degrees by which the tail of a mixed swimmer falls from the line of its back, or rises: straight ones are of one piece.</summary>
    private static double Arch(CreatureBuilder builder) => builder.Species.Disc.Sweep != 0 ? 0 : builder.Fitting * builder.Stream("arch of a swimmer").Uniform(RisingTail, FallingTail);

    /// <summary>Degrees by which the upright trunk of a bird is laid down to fly, and its tail: by the shares of the birds in it, for what others give to it is level already, and would hang head first.</summary>
    private static (double Torso, double Tail) FlightPitch(CreatureBuilder builder)
    {
        IReadOnlyList<double> shares = builder.Blend.TorsoFractions;
        (double torso, double tail) = (0, 0);
        for (int k = 0; k < shares.Count; k++)
        {
            if (SpeciesCatalogue.Find(builder.Blend.Bodies[k].Name).Bird is BirdPreset bird)
            {
                torso += shares[k] * bird.FlightPitch.Torso;
                tail += shares[k] * bird.FlightPitch.Tail;
            }
        }

        (double ownTorso, double ownTail) = builder.Species.Bird!.FlightPitch;
        return (Scalar.Lerp(ownTorso, torso, builder.Fitting), Scalar.Lerp(ownTail, tail, builder.Fitting));
    }

    /// <summary>S1.3: swimmers get smaller ranges in x and z and a larger one in y.</summary>
    private static ValueList<LatticeSlice> Slices(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("lattice");
        bool inWater = builder.Kind == LocomotionKind.Swimming;
        bool swims = inWater && !builder.Species.IsSpecies;
        double spread = Math.Max(builder.Species.LatticeSpread, Scalar.Lerp(builder.Species.LatticeSpread, inWater ? SwimmersSpread : 0.3, builder.Strangeness));
        double wider = 1 + (0.7 * builder.Strangeness);
        var slices = new LatticeSlice[11];
        for (int k = 0; k < slices.Length; k++)
        {
            double x = random.Uniform(-1, 1);
            double y = random.Uniform(-1, 1);
            double z = random.Uniform(-1, 1);
            slices[k] = swims
                ? new LatticeSlice(0.9 + (0.14 * wider * x), 1.06 + (0.28 * wider * y), 1 + (0.14 * wider * z))
                : new LatticeSlice(1 + (spread * x), 1 + (spread * y), 1 + (spread * z));
        }

        // Third and fourth pairs of legs stand below the middle slices.
        double longer = ExtraLegs.LengthOf(builder) * Stature.Torso(builder);
        for (int k = 4; k <= 6; k++)
        {
            slices[k] = slices[k] with { Length = longer * slices[k].Length };
        }

        return new ValueList<LatticeSlice>(slices);
    }

    /// <summary>The end of the tail of walkers and fliers; swimmers get theirs with their fins.</summary>
    private static TailBlueprint Tail(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("tail");
        double feathers = random.Uniform(0.13, 0.19);
        bool feathered = builder.Kind == LocomotionKind.Flying || random.Chance(0.55);
        double size = random.Uniform(0.16, 0.24);
        double fork = TailSampler.FanFork(builder, random);

        // A fan of feathers at a furry rump, or of rays, looks stuck on.
        bool feathery = builder.Parents.Skin.Class == AnimalClass.Bird || builder.Kind == LocomotionKind.Flying;
        bool scaly = builder.Parents.Skin.Class is AnimalClass.Fish or AnimalClass.Reptile or AnimalClass.Amphibian;
        if (builder.Kind == LocomotionKind.Swimming)
        {
            return new TailBlueprint(TailStyle.Plain, 0, 0);
        }

        if (TailSampler.Draw(builder) is TailBlueprint own)
        {
            return own;
        }

        if (builder.Parents.Tail.Bird is BirdPreset bird && feathery)
        {
            double fan = bird.Fan * (builder.Kind == LocomotionKind.Flying ? 1.35 : ClosedFan);
            return bird.Fan == 0 ? TailSampler.Other(builder) : new TailBlueprint(TailStyle.Feathers, fan, 0);
        }

        return builder.Parents.Tail.Class switch
        {
            AnimalClass.Bird when feathered && feathery => new TailBlueprint(TailStyle.Feathers, builder.Kind == LocomotionKind.Flying ? feathers : ClosedFan * feathers, 0),
            AnimalClass.Fish when scaly && builder.Plan != BodyPlan.Theropod => new TailBlueprint(TailStyle.Fan, size, fork),
            _ => TailSampler.Other(builder),
        };
    }
}
