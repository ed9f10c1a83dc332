using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Gives fliers wings, and legs that they stand on: the rules for fliers say how many there are, where and how long; those for walkers see to it that they carry the body.</summary>
internal static class FlierLegs
{
    /// <summary>Last ring of an insect's thorax.</summary>
    private const int ThoraxEnd = 34;

    /// <summary>Least height of the belly above the ground, relative to the torso.</summary>
    private const double MinClearance = 0.08;

    /// <summary>How far the foot of a leg that hangs trails behind, in lengths of the leg.</summary>
    private const double HangingShear = -0.15;

    /// <summary>How far the feet of a single pair are ahead of its hips, in heights of these.</summary>
    private const double FeetAhead = 0.15;

    /// <summary>How far a body is pitched at a time to stand, degrees: more would change how it flies.</summary>
    private const double MaxPitch = 4;

    /// <summary>By which part of the feet's hull a flier's centre of mass is to lie inside it: that of spread wings is estimated, the less surely the stranger the body and the more pairs there are.</summary>
    private const double SafeMargin = 0.1;

    /// <summary>Factor on the girth of a single pair that is not a bird's: thighs as thick as a deep body asks for would crease where they leave it.</summary>
    private const double SlenderPair = 0.82;

    /// <summary>Girth below which feet get smaller with the legs: they would be as long as the body.</summary>
    private const double MinFeet = 0.75;

    /// <summary>Probability at full strangeness of any number of legs.</summary>
    private const double AnyPairs = 0.35;

    /// <summary>Shortest leg relative to the body's length.</summary>
    private const double ShortestLeg = 0.05;

    /// <summary>Most pairs of legs of what is no insect.</summary>
    public const int MaxUnderOthers = 4;

    /// <summary>Pairs of legs beyond which each has a slim thigh and few toes: these grow out of few cells, and there is room for all.</summary>
    private const int ManyPairs = 2;
    private const int FewToes = 3;

    /// <summary>Adds wings and legs to the creature, and sets its body down on these.</summary>
    public static void Add(CreatureBuilder builder, LegStyle style)
    {
        if (builder.Parents.Legs.Legs is LegPreset preset)
        {
            AddOwn(builder, style, preset);
            return;
        }

        bool insect = builder.Parents.Legs.Class == AnimalClass.Arthropod;
        RandomStream random = builder.Stream("flier legs");
        int pairs = PairsOf(builder, random);
        LegArrangement arrangement = insect && random.Chance(0.5) ? LegArrangement.Clustered : LegArrangement.Spread;
        FlierLegAnatomy anatomy = insect ? FlierLegAnatomy.Insect : pairs == 1 ? FlierLegAnatomy.Bird : pairs == 2 ? FlierLegAnatomy.Dragon : FlierLegAnatomy.Beast;
        if (insect && pairs <= 4)
        {
            // Few legs all grow from the thorax.
            anatomy = anatomy with { Sockets = new List<LimbSocket>(anatomy.Sockets).FindAll(site => site.Ring <= ThoraxEnd) };
        }

        if (builder.Parents.Legs.Bird is BirdPreset own)
        {
            double thigh = CreatureBuilder.Between(builder.Stream("thigh"), own.Thigh);
            anatomy = anatomy with { Sockets = new List<LimbSocket>(anatomy.Sockets).ConvertAll(site => site with { Archetype = LimbArchetype.Bird, Girth = pairs > ManyPairs ? Math.Min(thigh, site.Girth) : thigh }) };
            style = OwnLegs.StyleOf(builder, style, own);
        }

        // Thin legs keep the feet of stout ones: these have as much to carry.
        double girth = builder.Parents.Legs.LegGirth * (pairs == 1 && builder.Parents.Legs.Bird is null ? SlenderPair : 1);
        double feet = Math.Max(girth, MinFeet);
        style = style with { FootSize = style.FootSize / feet };
        anatomy = anatomy with { Size = anatomy.Size with { Girth = girth, Foot = insect ? anatomy.Size.Foot / feet : style.FootSize, Toes = insect ? 0 : pairs > ManyPairs ? Math.Min(style.Toes, FewToes) : style.Toes } };
        WingMotion motion = builder.Plan == BodyPlan.Buzzing ? WingMotion.Buzzing : WingMotion.Flapping;
        FlyingPlacement placement = FlyingRules.Place(LegSampler.Measure(builder), motion, motion == WingMotion.Buzzing ? 2 : 1, new FlyingLegs(pairs, arrangement), anatomy, builder.Sockets, builder.Seed.Child("flier"));
        WingSampler.Add(builder, placement);
        ExtraWings.AddBehind(builder);
        if (placement.Legs.Count > 0)
        {
            style = insect ? style with { FootSize = 1 } : style with { Toes = anatomy.Size.Toes == 0 ? style.Toes : anatomy.Size.Toes };
            Stand(builder, style, placement, anatomy);
        }
    }

    /// <summary>How many pairs of legs are drawn for one that has no insect's own.</summary>
    public static int PairsOf(CreatureBuilder builder) => PairsOf(builder, builder.Stream("flier legs"));

    /// <summary>Now and then any number of legs: up to eight pairs under an insect, up to four under others; always one that is asked for.</summary>
    private static int PairsOf(CreatureBuilder builder, RandomStream legs)
    {
        bool insect = builder.Parents.Legs.Class == AnimalClass.Arthropod;
        int pairs = CreatureBuilder.Choose(legs, builder.Parents.Legs.FlierLegPairs);
        RandomStream random = builder.Stream("strange flier legs");
        bool strange = random.Chance(AnyPairs * builder.Strangeness);
        int drawn = FlyingRules.DrawLegs(random).Pairs;
        pairs = strange ? insect ? drawn : drawn / 2 : pairs;

        // Without legs only what is as long as a snake or as wide as wings flies well: others are a head between wings from the front, and a torpedo from the side.
        bool slim = builder.Parents.First.Disc.Sweep != 0 || Array.Exists(builder.Parents.First.WalkingPlans, plan => plan.Value == BodyPlan.Legless);
        int least = builder.Strangeness > 0 && !slim ? Math.Max(1, builder.MinLegPairs) : builder.MinLegPairs;
        return Math.Min(Math.Min(Math.Max(least, pairs), builder.MaxLegPairs), FlyingRules.MaxPairs);
    }

    /// <summary>An insect stands with spread wings as it does with folded ones.</summary>
    private static void AddOwn(CreatureBuilder builder, LegStyle style, LegPreset preset)
    {
        style = OwnLegs.StyleOf(builder, style, preset);
        var size = new LegSize(1, 1, style.FootSize, style.Toes);
        WalkingPlacement placement = LegSampler.Settle(builder, measure => OwnLegs.SetOf(builder, preset, measure), size);
        LegSampler.AddStanding(builder, style, placement, OwnLegs.SetOf(builder, preset, LegSampler.Measure(builder)), size);
        OwnLegs.AddArms(builder, style, preset);
        WingSampler.AddThin(builder, builder.Parents.Legs.Wings!.Spread);
        builder.Legs.Sort((a, b) => a.Socket.Ring.CompareTo(b.Socket.Ring));
    }

    private static void Stand(CreatureBuilder builder, LegStyle style, FlyingPlacement flying, FlierLegAnatomy anatomy)
    {
        (BodyPosture posture, double elevation, double raised, BodyShape shape) = (builder.Posture, builder.Elevation, builder.Raised, builder.Shape);
        StanceSampler.Lower(builder, Math.Min(MeanTip(flying.Legs), StanceSampler.Lowest(builder.Shape, 20, 44) - (MinClearance * builder.TorsoLength)));
        SocketSet set = SetOf(builder, flying, anatomy);
        WalkingPlacement placement = LegSampler.Settle(builder, _ => set, anatomy.Size);
        if (IsCarried(placement))
        {
            // A raised head or tail moves the centre of mass: the feet are placed under the body as it is.
            BodyShape settled = builder.Shape;
            StanceSampler.Clear(builder);
            placement = builder.Shape == settled && placement.RaiseBody == 0 ? placement : LegSampler.Settle(builder, _ => set, anatomy.Size);
            if (IsCarried(placement) && StanceSampler.Lowest(builder.Shape, 0, BodyGrid.Rings) > 0)
            {
                LegSampler.AddStanding(builder, style, placement, set, anatomy.Size);
                return;
            }
        }

        // No legs at these places carry it: they hang, and it stays in the air.
        (builder.Posture, builder.Elevation, builder.Raised, builder.Shape) = (posture, elevation, raised, shape);
        foreach (LegPlacement leg in flying.Legs)
        {
            bool splayed = LegKinds.Of(leg.Site.Archetype).Build.Posture == LimbPosture.Splayed;
            LegStyle own = style with { Slimness = LegLoad.Thicker(builder, style, leg, flying.Legs.Count) * style.Slimness };
            LegSampler.Add(builder, own, leg.Site.Archetype, LegStance.Hanging, leg.Socket, leg.RootRadius, leg.Length, splayed ? leg.Reach : leg.Length, leg.Site.Azimuth, splayed ? 0 : HangingShear, leg.Site.Bounds.Pad);
        }
    }

    private static bool IsCarried(WalkingPlacement placement) => placement.Balance is { Pitch: 0 } balance && balance.Remedy != BalanceRemedy.AddPairOrTail;

    private static double MeanTip(IReadOnlyList<LegPlacement> legs)
    {
        double sum = 0;
        foreach (LegPlacement leg in legs)
        {
            sum += leg.TipHeight / legs.Count;
        }

        return sum;
    }

    /// <summary>One pair stands nearest under the centre of mass, feet ahead of the hips as birds stand.</summary>
    private static LimbSocket UnderMass(CreatureBuilder builder, FlierLegAnatomy anatomy)
    {
        SpineMeasure measure = LegSampler.Measure(builder);
        LimbSocket best = anatomy.Sockets[0];
        double nearest = double.MaxValue;
        foreach (LimbSocket site in anatomy.Sockets)
        {
            SpineSection section = measure.At(site.Ring);
            double off = Math.Abs(section.Z + (FeetAhead * LegFitting.AttachmentHeight(section, site.Segment)) - measure.CentreOfMass.Z);
            (best, nearest) = off < nearest ? (site, off) : (best, nearest);
        }

        return best;
    }

    /// <summary>The places of the legs, each as large as the rules for fliers made it.</summary>
    private static SocketSet SetOf(CreatureBuilder builder, FlyingPlacement flying, FlierLegAnatomy anatomy)
    {
        var places = new List<LimbSocket>();
        foreach (LegPlacement leg in flying.Legs)
        {
            bool alone = flying.Legs.Count == 1 && LegKinds.Of(leg.Site.Archetype).Build.Posture == LimbPosture.Under;
            LimbSocket site = alone ? UnderMass(builder, anatomy) : leg.Site;
            double factor = alone ? 1 : flying.LegFactor;
            places.Add(site with { Girth = site.Girth * factor, Reach = site.Reach * factor });
        }

        double forward = places.Count == 1 ? 0.5 : 0.3;
        var stance = new StanceLimits(ShortestLeg, 0.45, -0.3, forward, MaxPitch, 1.6, builder.Plan, builder.Plan) { BalanceMargin = SafeMargin * (1 + builder.Strangeness) * Math.Max(1, builder.Wings.Count) };
        return new SocketSet(builder.Plan, places, places.Count, null, stance) { TakesAll = true };
    }
}
