using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Gives walkers and fliers their legs and arms where the attachment rules put them.</summary>
internal static class LegSampler
{
    /// <summary>Rounds of placing legs and moving the body for them.</summary>
    private const int Rounds = 4;

    /// <summary>Probability at full strangeness of a second pair of arms, and its thickness and length relative to the first: hands of longer ones hang beside the knees and their arms seem to grow from the hips.</summary>
    private const double SecondArms = 0.4;
    private const double ThinnerArms = 0.8;
    private const double ShorterArms = 0.58;

    /// <summary>Part of its length by which the hand of a second arm is held before the body: hung down like the first ones, both pairs of hands lie at the thighs and tangle with them.</summary>
    private const double ArmsAhead = 0.45;

    // Breadth of a body against its depth from which its legs grow nearer to the belly, by how many segments for each unit of it, and by how many at most.
    private const double Broad = 1.05;
    private const double BroadOnBirdLegs = 0.85;
    private const double LoweringRate = 2.2;
    private const double MaxLowering = 1.3;

    /// <summary>Part by which the margin of balance grows at full strangeness.</summary>
    private const double UnsureMargin = 0.6;

    /// <summary>Rings between two pairs of arms: fewer would crease under both.</summary>
    private const int ArmGap = 3;

    /// <summary>How often a head or a tail that tips a walker over is made smaller.</summary>
    private const int Lightenings = 8;

    /// <summary>Radius of an even cylinder as heavy as a hanging arm with its hand, relative to the radius of its root.</summary>
    private const double ArmFullness = 0.55;

    /// <summary>Fills in the legs of the creature; gives the plan to try instead when the body cannot carry the legs of its own.</summary>
    public static BodyPlan? Sample(CreatureBuilder builder)
    {
        var style = new LegStyle(builder);
        switch (builder.Kind)
        {
            case LocomotionKind.Walking:
                return Walk(builder, style);
            case LocomotionKind.Flying:
                FlierLegs.Add(builder, style);
                return null;
            default:
                OwnLegs.Paddle(builder, style);
                return null;
        }
    }

    /// <summary>Volume of a pair of spread wings in spans times chords squared.</summary>
    private const double WingFullness = 0.05;

    /// <summary>How far behind its shoulder a spread wing's centre of mass is, in spans.</summary>
    private const double WingTrail = 0.03;

    /// <summary>The same of a membrane that the flank holds as far as the hip.</summary>
    private const double MembraneTrail = 0.05;

    /// <summary>The torso of the creature as the attachment rules see it, with the weight of spread wings and of an open mouth.</summary>
    public static SpineMeasure Measure(CreatureBuilder builder)
    {
        BodyShape s = builder.Shape;
        SpineMeasure measure = OpenJaw.Measure(builder);
        foreach (WingBlueprint wing in builder.Wings)
        {
            if (wing.Style != WingStyle.Folded)
            {
                double volume = WingFullness * wing.Span * wing.Chord * wing.Chord;
                double z = measure.At(wing.Socket.Ring + (0.5 * wing.Socket.Rows)).Z - ((WingForm.Of(wing.Style).Feathers > 0 ? WingTrail : MembraneTrail) * wing.Span);
                measure = measure.Laden(z, volume / (volume + StanceSampler.Volume(s)));
            }
        }

        return measure;
    }

    private static BodyPlan? Walk(CreatureBuilder builder, LegStyle style)
    {
        ExtraWings.AddRaised(builder);
        LegPreset? preset = builder.Parents.Legs.Legs;
        BirdPreset? bird = builder.Parents.Legs.Bird;
        style = preset != null ? OwnLegs.StyleOf(builder, style, preset) : bird != null ? OwnLegs.StyleOf(builder, style, bird) : style;
        var size = new LegSize(1, preset != null ? 1 : style.Reach, style.FootSize, style.Toes);
        int extra = ExtraLegs.PairsOf(builder);
        if (extra > 0 && WalkingRules.Place(Measure(builder), SetFor(Measure(builder)), size, builder.Stream("arms")).PlanChange != null)
        {
            // No room for them between the others.
            extra = 0;
        }

        BodyProportions drawn = builder.Proportions;
        WalkingPlacement placement = Carry(builder, SetFor, size);
        if (extra > 0 && (!builder.IsCarried || (placement.PlanChange != null && placement.PlanChange != builder.Plan)))
        {
            // They do not carry it; without them it stands as its kind does.
            extra = 0;
            builder.Proportions = drawn;
            StanceSampler.StandAnew(builder);
            placement = Carry(builder, SetFor, size);
        }

        if (placement.PlanChange != null && placement.PlanChange != builder.Plan)
        {
            return placement.PlanChange;
        }

        AddStanding(builder, style, placement, SetFor(Measure(builder)), size);
        if (placement.Arms is ArmPlacement arms)
        {
            LegStyle hand = style with { ClawLength = Math.Max(style.ClawLength, 0.6), FootSize = 1.3 };
            Add(builder, hand, LimbArchetype.Arm, LegStance.Hanging, arms.Socket, arms.RootRadius, arms.Length, arms.Length * 0.9, 0, 0, arms.Site.Bounds.Pad);
            AddSecondArms(builder, hand, arms);
        }

        if (preset != null)
        {
            OwnLegs.AddArms(builder, style, preset);
        }

        if (builder.Parents.Legs.Wings is ThinWings wings)
        {
            WingSampler.AddThin(builder, wings.Folded);
        }

        if (builder.Parents.Legs.Class == AnimalClass.Bird && builder.Plan == BodyPlan.Theropod && placement.Arms is null && builder.Wings.Count == 0)
        {
            WingSampler.AddFolded(builder);
        }

        builder.Legs.Sort((a, b) => a.Socket.Ring.CompareTo(b.Socket.Ring));
        return null;

        SocketSet SetFor(SpineMeasure measure) => preset is null && bird is null && extra > 0 ? ExtraLegs.Between(SetOf(builder), extra) : OrdinaryFor(measure);

        SocketSet OrdinaryFor(SpineMeasure measure) => ClearOfFace.Turn(PlacesFor(measure), builder.Shape, measure.BodyLength * size.Reach);

        SocketSet PlacesFor(SpineMeasure measure) => preset != null ? OwnLegs.SetOf(builder, preset, measure) : bird != null ? OwnLegs.SetOf(builder, bird) : SetOf(builder);
    }

    /// <summary>A second, smaller pair of arms behind the first, now and then, where there is room.</summary>
    private static void AddSecondArms(CreatureBuilder builder, LegStyle hand, ArmPlacement arms)
    {
        bool second = builder.Stream("second arms").Chance(SecondArms * builder.Strangeness);
        SocketBlueprint socket = arms.Socket with { Ring = arms.Socket.Ring + arms.Socket.Rows + ArmGap };
        if (second && builder.Sockets.IsFree(socket, arms.Site.Bounds.Pad))
        {
            double length = ShorterArms * arms.Length;
            Add(builder, hand, LimbArchetype.Arm, LegStance.Hanging, socket, ThinnerArms * arms.RootRadius, length, 0.9 * length, 0, ArmsAhead, arms.Site.Bounds.Pad);
        }
    }

    /// <summary>Places the legs of a walker so that they carry it: what hangs over its feet is made lighter, and what the settled body lowers into the ground is raised.</summary>
    private static WalkingPlacement Carry(CreatureBuilder builder, Func<SpineMeasure, SocketSet> anatomy, LegSize size)
    {
        WalkingPlacement placement = Settle(builder, anatomy, size);
        for (int round = 0; round < Lightenings && placement.Balance is { Remedy: BalanceRemedy.AddPairOrTail } balance; round++)
        {
            StanceSampler.Lighten(builder, balance.Overhang);
            placement = Settle(builder, anatomy, size);
        }

        for (int round = 0; round < Rounds && StanceSampler.Sinks(builder); round++)
        {
            // The body was pitched to stand, and its tail came down with it.
            StanceSampler.Clear(builder);
            StanceSampler.Lift(builder);
            placement = Settle(builder, anatomy, size);
        }

        builder.IsCarried = placement.RaiseBody == 0 && placement.Balance is not { Remedy: BalanceRemedy.AddPairOrTail } && !StanceSampler.Sinks(builder);
        return placement;
    }

    /// <summary>Places the legs of a walker, and raises and pitches the body until it stands on them.</summary>
    public static WalkingPlacement Settle(CreatureBuilder builder, Func<SpineMeasure, SocketSet> anatomy, LegSize size)
    {
        WalkingPlacement placement = Place();
        for (int round = 1; round < Rounds; round++)
        {
            double pitch = placement.Balance?.Pitch ?? 0;
            if (placement.RaiseBody == 0 && pitch == 0)
            {
                break;
            }

            builder.Raised += placement.RaiseBody;
            builder.Elevation += placement.RaiseBody;
            builder.Posture = builder.Posture with { Trunk = builder.Posture.Trunk + pitch };
            builder.Shape = StanceSampler.ShapeOf(builder);
            placement = Place();
        }

        return placement;

        WalkingPlacement Place()
        {
            SpineMeasure measure = Measure(builder);
            return WalkingRules.Place(measure, anatomy(measure), size, builder.Stream("arms"));
        }
    }

    /// <summary>How a leg of a placement turns to the front and leans, radians and shift of the foot in units of the length.</summary>
    public static (double Azimuth, double Shear) Posture(CreatureBuilder builder, WalkingPlacement placement, LegPlacement leg)
    {
        bool last = leg == placement.Legs[placement.Legs.Count - 1];
        double azimuth = LegKinds.Of(leg.Site.Archetype).Outline.Arched && last ? UnderAbdomen(builder, leg, placement.Legs[0]) : leg.Site.Azimuth;
        return (azimuth, placement.Legs.Count == 1 ? UnderMass(builder, leg, placement.Arms) : leg.Shear);
    }

    private static List<LimbSocket> SitesOf(WalkingPlacement placement)
    {
        var sites = new List<LimbSocket>();
        foreach (LegPlacement leg in placement.Legs)
        {
            sites.Add(leg.Site);
        }

        return sites;
    }

    /// <summary>A biped stands with its feet under its centre of mass, as far as its hips allow; the rules have seen to it that it can.</summary>
    private static double UnderMass(CreatureBuilder builder, LegPlacement leg, ArmPlacement? arms)
    {
        double middle = leg.Foot.Z + ((leg.Foot.Toe - leg.Foot.Heel) / 2);
        SpineMeasure measure = Measure(builder);
        double mass = arms is null ? measure.CentreOfMass.Z : WithArms(builder.Shape, measure, arms);
        double ideal = leg.Shear + ((mass - middle) / leg.Length);
        return Scalar.Clamp(ideal, Math.Min(leg.Shear, -0.1), Math.Max(leg.Shear, 0.5));
    }

    /// <summary>Where the centre of mass lies along z with a pair of hanging arms, which the measured body is without: they balance on their shoulders.</summary>
    private static double WithArms(BodyShape body, SpineMeasure measure, ArmPlacement arms)
    {
        double radius = ArmFullness * arms.RootRadius;
        double both = 2 * PortableMath.Pi * radius * radius * arms.Length;
        return Scalar.Lerp(measure.CentreOfMass.Z, measure.At(arms.Site.Ring).Z, both / (both + StanceSampler.Volume(body)));
    }

    /// <summary>The turn of an insect's last legs, radians: far enough back to carry a heavy abdomen.</summary>
    private static double UnderAbdomen(CreatureBuilder builder, LegPlacement last, LegPlacement first)
    {
        LegBuild build = LegKinds.Of(last.Site.Archetype).Build;
        double step = build.FootOutward * last.Reach;
        double front = first.RootZ + (step * PortableMath.Sin(first.Site.Azimuth));
        double mass = Measure(builder).CentreOfMass.Z;

        // Behind the centre of mass by a fifth of what lies before it.
        double sine = (mass - (0.2 * (front - mass)) - last.RootZ) / step;
        return Math.Min(last.Site.Azimuth, PortableMath.Asin(Scalar.Clamp(sine, -0.97, 0.97)));
    }

    /// <summary>The plan with arms in front of its legs; plans that have none of these stay as they are.</summary>
    public static BodyPlan WithArms(BodyPlan plan) => PlanTraits.IsQuadruped(plan) ? BodyPlan.Centaur : plan;

    /// <summary>The plan of four legs under the body that a species has oftenest.</summary>
    private static BodyPlan QuadrupedOf(SpeciesProfile legs)
    {
        BodyPlan plan = legs.IsHoofed ? BodyPlan.Unguligrade : BodyPlan.Digitigrade;
        double max = 0;
        foreach (Weighted<BodyPlan> own in legs.WalkingPlans)
        {
            if (PlanTraits.IsQuadruped(own.Value) && own.Weight > max)
            {
                (plan, max) = (own.Value, own.Weight);
            }
        }

        return plan;
    }

    /// <summary>By how many segments legs grow nearer to the belly of a broad body: from its edges they stand like those of a table.</summary>
    private static double LoweringAt(CreatureBuilder builder, int ring)
    {
        double broad = builder.Plan == BodyPlan.Theropod && builder.Parents.Legs.Bird != null ? BroadOnBirdLegs : Broad;
        return builder.Fitting * Scalar.Clamp(LoweringRate * ((builder.Shape.Width[ring] / builder.HalfDepth(ring)) - broad), 0, MaxLowering);
    }

    private static SocketSet SetOf(CreatureBuilder builder)
    {
        bool bird = builder.Parents.Legs.Class == AnimalClass.Bird;
        SocketSet set = builder.Plan switch
        {
            BodyPlan.Centaur => SocketSets.Centaur(QuadrupedOf(builder.Parents.Legs)),
            BodyPlan.Upright => SocketSets.Upright(builder.Stream("upright legs").Chance(0.6) ? LimbArchetype.PlantigradeHind : LimbArchetype.DigitigradeHind),
            BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar => SocketSets.Quadruped(builder.Plan) with { Arms = null },
            _ => SocketSets.Of(builder.Plan),
        };
        if (bird && set.Arms != null)
        {
            set = set with { Arms = set.Arms with { OddsNear = 0, OddsFar = 0.15 } };
        }
        else if (builder.Plan is BodyPlan.Theropod or BodyPlan.Upright && set.Arms is ArmAnatomy arms && builder.Wings.Count == 0)
        {
            // Without arms or wings a mixed body on two legs is a pear on posts.
            set = set with { Arms = arms with { OddsNear = Scalar.Lerp(arms.OddsNear, 1, builder.Fitting), OddsFar = Scalar.Lerp(arms.OddsFar, 1, builder.Fitting) } };
        }

        if (PlanTraits.IsAboveLegs(builder.Plan) || builder.Plan == BodyPlan.Theropod)
        {
            set = set.Lowered(LoweringAt(builder, StationRing.Shoulder), LoweringAt(builder, builder.Plan == BodyPlan.Theropod ? StationRing.BipedHip : StationRing.Pelvis));
        }

        // The weight of a strange body is known less surely than that of an animal.
        set = set with { Stance = set.Stance with { BalanceMargin = Balance.MinMargin * (1 + (UnsureMargin * builder.Strangeness)) } };
        double girth = builder.Parents.Legs.LegGirth;
        return set.WithGirth(builder.Signature == Signature.Hulk ? 1.3 * girth : girth, builder.Signature == Signature.Rump ? 1.15 * girth : girth);
    }

    /// <summary>Adds the legs of a placement that the builder stands on.</summary>
    public static void AddStanding(CreatureBuilder builder, LegStyle style, WalkingPlacement placement, SocketSet places, LegSize size)
    {
        double growth = placement.Balance?.FootGrowth ?? 1;
        builder.Stand = new LegStand(places.Pinned(SitesOf(placement), placement.Girth), size, growth);
        foreach (LegPlacement leg in placement.Legs)
        {
            LegBuild build = LegKinds.Of(leg.Site.Archetype).Build;
            bool splayed = build.Posture == LimbPosture.Splayed;
            (double azimuth, double shear) = Posture(builder, placement, leg);
            double slim = LegLoad.Thicker(builder, style, leg, placement.Legs.Count) * style.Slimness * (leg.Site.Ring < BodyGrid.AnchorRing && builder.Parents.Legs.Legs == null ? 1.05 : 1);
            (double shank, double foot) = LegMates.Evened(builder, leg, placement.Legs);
            Add(builder, style with { Slimness = slim * shank, FootSize = style.FootSize * growth * foot }, leg.Site.Archetype, LegStance.Standing, leg.Socket, leg.RootRadius, leg.RootHeight, splayed ? leg.Reach : leg.RootHeight, azimuth, shear, leg.Site.Bounds.Pad);
        }
    }

    private static FootStyle FootOf(LegStyle style, LimbArchetype archetype) => LegKinds.Of(archetype).Outline switch
    {
        { End: FootEnd.Hoof } => style.Hooves,
        { LongToed: true } => style.Foot is FootStyle.Paw or FootStyle.Stump or FootStyle.Sucker ? FootStyle.Talon : style.Foot,
        { End: FootEnd.Toes, Handed: false } => style.Foot,
        _ => FootStyle.Plain,
    };

    /// <summary>Adds a pair of legs if its cells are free.</summary>
    public static void Add(CreatureBuilder builder, LegStyle style, LimbArchetype archetype, LegStance stance, SocketBlueprint socket, double thickness, double length, double reach, double azimuth, double shear, int pad)
    {
        if (builder.Sockets.TryReserve(socket, pad))
        {
            builder.Legs.Add(new LegBlueprint(archetype, stance, socket, thickness, length, reach, azimuth, shear, style.Slimness, style.Stoutness, style.FootSize, style.KneeRise, Math.Max(1, style.Toes), style.ClawLength, FootOf(style, archetype)));
        }
    }
}

/// <summary>What the legs of a walker grew by.</summary>
/// <param name="Places">Their places, on any body of the species.</param>
/// <param name="Size">Their size.</param>
/// <param name="FootGrowth">Factor on their feet for balance.</param>
internal sealed record LegStand(SocketSet Places, LegSize Size, double FootGrowth);

/// <summary>What all legs of one creature share.</summary>
internal sealed record LegStyle
{
    /// <summary>Claws of toes that have none in their species, on a mixed body: its toes are balls without.</summary>
    private const double ShortClaw = 0.6;

    /// <summary>How much columns differ in stoutness: they have no other outline to be told by.</summary>
    private const double SpreadOfColumns = 0.16;

    // Largest feet as they are drawn, those of columns, and of a mixed body those with paws and those of two legs, which balance makes larger still: larger ones are balls or as long as the leg.
    private const double Largest = 1.65;
    private const double LargestColumn = 1.12;
    private const double LargestPaw = 1.38;
    private const double LargestOfTwo = 1.2;

    public LegStyle(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("leg style");
        Stoutness = CreatureBuilder.Around(random, 1 + (0.05 * builder.Style), builder.Plan == BodyPlan.Columnar ? SpreadOfColumns : 0.08, 0.85, 1.25);
        bool soft = builder.Plan is BodyPlan.Digitigrade or BodyPlan.Plantigrade;
        FootSize = CreatureBuilder.Around(random, 1.25 + (0.1 * builder.Style), 0.1, 1, LargestFoot(builder, soft));
        Slimness = CreatureBuilder.Around(random, builder.Plan == BodyPlan.Unguligrade ? 1.02 : 1.12, 0.1, 0.85, 1.35);
        Toes = builder.Plan is BodyPlan.Theropod or BodyPlan.ManyLegged || builder.Parents.Legs.Class == AnimalClass.Bird ? 3 : random.Integer(3, 5);
        Reach = random.Uniform(0.85, 1.15);
        Foot = FootSampler.Toes(builder);
        Hooves = FootSampler.Hooves(builder);
        ClawLength = Foot == FootStyle.Talon ? random.Uniform(1.5, 2.2) : soft ? CreatureBuilder.Choose(random, (builder.Fitting > 0 ? ShortClaw : 0.0, 0.35), (0.8, 0.3), (1.3, 0.35)) : random.Chance(0.5) ? 0.9 : 1.5;
    }

    public double Stoutness { get; init; }

    public double FootSize { get; init; }

    public double Slimness { get; init; }

    public double Reach { get; init; }

    public int Toes { get; init; }

    public double ClawLength { get; init; }

    public double KneeRise { get; init; } = 1;

    /// <summary>What feet with toes end in.</summary>
    public FootStyle Foot { get; init; }

    /// <summary>What hooves are like.</summary>
    public FootStyle Hooves { get; init; }

    private static double LargestFoot(CreatureBuilder builder, bool soft) => builder.Plan switch
    {
        BodyPlan.Columnar => LargestColumn,
        BodyPlan.Theropod => Scalar.Lerp(Largest, LargestOfTwo, builder.Fitting),
        _ => soft ? Scalar.Lerp(Largest, LargestPaw, builder.Fitting) : Largest,
    };
}
