using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Limbs.Attachment;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Gives walkers and fliers their legs and arms where the attachment rules put them.</summary>
internal static class LegSampler
{
    /// <summary>Rounds of placing legs and moving the body for them.</summary>
    private const int Rounds = 4;

    /// <summary>Radius of an even cylinder as heavy as a hanging arm with its hand, relative to the radius of its root.</summary>
    private const double ArmFullness = 0.55;

    /// <summary>Fills in the legs of the draft; gives the plan to try instead when the body cannot carry the legs of its own.</summary>
    public static BodyPlan? Sample(CreatureDraft draft)
    {
        var style = new LegStyle(draft);
        switch (draft.Kind)
        {
            case LocomotionKind.Walking:
                return Walk(draft, style);
            case LocomotionKind.Flying:
                FlierLegs.Add(draft, style);
                return null;
            default:
                OwnLegs.Paddle(draft, style);
                return null;
        }
    }

    /// <summary>Volume of a pair of spread wings in spans times chords squared.</summary>
    private const double WingFullness = 0.05;

    /// <summary>How far behind its shoulder a spread wing's centre of mass is, in spans.</summary>
    private const double WingTrail = 0.03;

    /// <summary>The torso of the draft as the attachment rules see it, with the weight of spread wings.</summary>
    public static SpineMeasure Measure(CreatureDraft draft)
    {
        BodyShape s = draft.Shape;
        SpineMeasure measure = SpineSurvey.Measure(s.Y, s.Z, s.Width, s.Top, s.Bottom);
        foreach (WingBlueprint wing in draft.Wings)
        {
            if (wing.Style != WingStyle.Folded)
            {
                double volume = WingFullness * wing.Span * wing.Chord * wing.Chord;
                double z = measure.At(wing.Socket.Ring + (0.5 * wing.Socket.Rows)).Z - (WingTrail * wing.Span);
                measure = measure.Laden(z, volume / (volume + StanceSampler.Volume(s)));
            }
        }

        return measure;
    }

    private static BodyPlan? Walk(CreatureDraft draft, LegStyle style)
    {
        LegKit? kit = draft.Species.Legs;
        BirdKit? bird = draft.Species.Bird;
        style = kit != null ? OwnLegs.StyleOf(draft, style, kit) : bird != null ? OwnLegs.StyleOf(draft, style, bird) : style;
        var size = new LegSize(1, kit != null ? 1 : style.Reach, style.FootSize, style.Toes);
        WalkingPlacement placement = Settle(draft, SetFor, size);
        if (placement.PlanChange != null && placement.PlanChange != draft.Plan)
        {
            return placement.PlanChange;
        }

        AddStanding(draft, style, placement, SetFor(Measure(draft)), size);
        if (placement.Arms is ArmPlacement arms)
        {
            LegStyle hand = style with { ClawLength = Math.Max(style.ClawLength, 0.6), FootSize = 1.3 };
            Add(draft, hand, LimbArchetype.Arm, LegStance.Hanging, arms.Socket, arms.RootRadius, arms.Length, arms.Length * 0.9, 0, 0, arms.Site.Bounds.Pad);
        }

        if (kit != null)
        {
            OwnLegs.AddArms(draft, style, kit);
        }

        if (draft.Species.Wings is ThinWings wings)
        {
            WingSampler.AddThin(draft, wings.Folded);
        }

        if (draft.Species.Family == "avian" && draft.Plan == BodyPlan.Theropod && placement.Arms is null)
        {
            WingSampler.AddFolded(draft);
        }

        draft.Legs.Sort((a, b) => a.Socket.Ring.CompareTo(b.Socket.Ring));
        return null;

        SocketSet SetFor(SpineMeasure measure) => kit != null ? OwnLegs.SetOf(draft, kit, measure) : bird != null ? OwnLegs.SetOf(draft, bird) : SetOf(draft);
    }

    /// <summary>Places the legs of a walker, and raises and pitches the body until it stands on them.</summary>
    public static WalkingPlacement Settle(CreatureDraft draft, Func<SpineMeasure, SocketSet> anatomy, LegSize size)
    {
        WalkingPlacement placement = Place();
        for (int round = 1; round < Rounds; round++)
        {
            double pitch = placement.Balance?.Pitch ?? 0;
            if (placement.RaiseBody == 0 && pitch == 0)
            {
                break;
            }

            draft.Raised += placement.RaiseBody;
            draft.Elevation += placement.RaiseBody;
            draft.Posture = draft.Posture with { Trunk = draft.Posture.Trunk + pitch };
            draft.Shape = StanceSampler.ShapeOf(draft);
            placement = Place();
        }

        return placement;

        WalkingPlacement Place()
        {
            SpineMeasure measure = Measure(draft);
            return WalkingRules.Place(measure, anatomy(measure), size, draft.Stream("arms"));
        }
    }

    /// <summary>How a leg of a placement turns to the front and leans, radians and shift of the foot in units of the length.</summary>
    public static (double Azimuth, double Shear) Carriage(CreatureDraft draft, WalkingPlacement placement, LegPlacement leg)
    {
        bool last = leg == placement.Legs[placement.Legs.Count - 1];
        double azimuth = leg.Site.Archetype == LimbArchetype.Insect && last ? UnderAbdomen(draft, leg, placement.Legs[0]) : leg.Site.Azimuth;
        return (azimuth, placement.Legs.Count == 1 ? UnderMass(draft, leg, placement.Arms) : leg.Shear);
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
    private static double UnderMass(CreatureDraft draft, LegPlacement leg, ArmPlacement? arms)
    {
        double middle = leg.Foot.Z + ((leg.Foot.Toe - leg.Foot.Heel) / 2);
        SpineMeasure measure = Measure(draft);
        double mass = arms is null ? measure.CentreOfMass.Z : WithArms(draft.Shape, measure, arms);
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
    private static double UnderAbdomen(CreatureDraft draft, LegPlacement last, LegPlacement first)
    {
        LegBuild build = LegBuild.Of(last.Site.Archetype);
        double step = build.FootOutward * last.Reach;
        double front = first.RootZ + (step * PortableMath.Sin(first.Site.Azimuth));
        double mass = Measure(draft).CentreOfMass.Z;

        // Behind the centre of mass by a fifth of what lies before it.
        double sine = (mass - (0.2 * (front - mass)) - last.RootZ) / step;
        return Math.Min(last.Site.Azimuth, PortableMath.Asin(Scalar.Clamp(sine, -0.97, 0.97)));
    }

    private static SocketSet SetOf(CreatureDraft draft)
    {
        bool bird = draft.Species.Family == "avian";
        SocketSet set = draft.Plan switch
        {
            BodyPlan.Centaur => SocketSets.Centaur(draft.Species.Family == "bovine" ? BodyPlan.Unguligrade : BodyPlan.Digitigrade),
            BodyPlan.Upright => SocketSets.Upright(draft.Stream("upright legs").Chance(0.6) ? LimbArchetype.PlantigradeHind : LimbArchetype.DigitigradeHind),
            BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar => SocketSets.Quadruped(draft.Plan) with { Arms = null },
            _ => SocketSets.Of(draft.Plan),
        };
        if (bird && set.Arms != null)
        {
            set = set with { Arms = set.Arms with { OddsNear = 0, OddsFar = 0.15 } };
        }

        double girth = draft.Species.LegGirth;
        return set.WithGirth(draft.Signature == Signature.Hulk ? 1.3 * girth : girth, draft.Signature == Signature.Rump ? 1.15 * girth : girth);
    }

    /// <summary>Adds the legs of a placement that the draft stands on.</summary>
    public static void AddStanding(CreatureDraft draft, LegStyle style, WalkingPlacement placement, SocketSet places, LegSize size)
    {
        double growth = placement.Balance?.FootGrowth ?? 1;
        draft.Stand = new LegStand(places.Pinned(SitesOf(placement), placement.Girth), size, growth);
        foreach (LegPlacement leg in placement.Legs)
        {
            LegBuild build = LegBuild.Of(leg.Site.Archetype);
            bool splayed = build.Carriage == LegCarriage.Splayed;
            (double azimuth, double shear) = Carriage(draft, placement, leg);
            double slim = style.Slimness * (leg.Site.Ring < BodyGrid.AnchorRing && draft.Species.Legs == null ? 1.05 : 1);
            Add(draft, style with { Slimness = slim, FootSize = style.FootSize * growth }, leg.Site.Archetype, LegStance.Standing, leg.Socket, leg.RootRadius, leg.RootHeight, splayed ? leg.Reach : leg.RootHeight, azimuth, shear, leg.Site.Bounds.Pad);
        }
    }

    /// <summary>Adds a pair of legs if its cells are free.</summary>
    public static void Add(CreatureDraft draft, LegStyle style, LimbArchetype archetype, LegStance stance, SocketBlueprint socket, double thickness, double length, double reach, double azimuth, double shear, int pad)
    {
        if (draft.Sockets.TryReserve(socket, pad))
        {
            draft.Legs.Add(new LegBlueprint(archetype, stance, socket, thickness, length, reach, azimuth, shear, style.Slimness, style.Stoutness, style.FootSize, style.KneeRise, Math.Max(1, style.Toes), style.ClawLength));
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
    public LegStyle(CreatureDraft draft)
    {
        RandomStream random = draft.Stream("leg style");
        Stoutness = CreatureDraft.Around(random, 1 + (0.05 * draft.Style), 0.08, 0.85, 1.25);
        FootSize = CreatureDraft.Around(random, 1.25 + (0.1 * draft.Style), 0.1, 1, draft.Plan == BodyPlan.Columnar ? 1.12 : 1.65);
        Slimness = CreatureDraft.Around(random, draft.Plan == BodyPlan.Unguligrade ? 1.02 : 1.12, 0.1, 0.85, 1.35);
        Toes = draft.Plan is BodyPlan.Theropod or BodyPlan.ManyLegged || draft.Species.Family == "avian" ? 3 : random.Integer(3, 5);
        Reach = random.Uniform(0.85, 1.15);
        bool soft = draft.Plan is BodyPlan.Digitigrade or BodyPlan.Plantigrade;
        ClawLength = soft ? CreatureDraft.Choose(random, (0.0, 0.35), (0.8, 0.3), (1.3, 0.35)) : random.Chance(0.5) ? 0.9 : 1.5;
    }

    public double Stoutness { get; init; }

    public double FootSize { get; init; }

    public double Slimness { get; init; }

    public double Reach { get; init; }

    public int Toes { get; init; }

    public double ClawLength { get; init; }

    public double KneeRise { get; init; } = 1;
}
