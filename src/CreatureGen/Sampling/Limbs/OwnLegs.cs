using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Legs that a species brings with it: where its preset puts them, not where the rules of its plan would choose.</summary>
internal static class OwnLegs
{
    // Half depth of a trunk that an insect's legs look right under, metres, and how much thicker they get under a stouter one: a log on wires falls.
    private const double SlightTrunk = 0.1;
    private const double MaxStout = 1.6;

    /// <summary>The style of legs of a preset.</summary>
    public static LegStyle StyleOf(CreatureBuilder builder, LegStyle style, LegPreset preset)
    {
        RandomStream random = builder.Stream("own legs");
        return style with
        {
            Slimness = IsJointed(preset.Sites[0].Archetype) ? 1 : style.Slimness,
            FootSize = IsJointed(preset.Sites[0].Archetype) ? 1 : 1.2,
            Toes = IsJointed(preset.Sites[0].Archetype) ? 0 : random.Integer(preset.Toes.Min, preset.Toes.Max + 1),
            ClawLength = preset.Claw,
            KneeRise = preset.KneeRise,
        };
    }

    /// <summary>The style of a bird's legs.</summary>
    public static LegStyle StyleOf(CreatureBuilder builder, LegStyle style, BirdPreset preset)
    {
        RandomStream random = builder.Stream("own legs");
        return style with
        {
            Slimness = random.Uniform(0.95, 1.1),
            Stoutness = 1,
            FootSize = style.FootSize * preset.Foot,
            Toes = preset.Toes,
            ClawLength = preset.Claw,
        };
    }

    /// <summary>The places of a preset on the body as it is.</summary>
    public static SocketSet SetOf(CreatureBuilder builder, LegPreset preset, SpineMeasure measure)
    {
        double reach = CreatureBuilder.Between(builder.Stream("reach"), preset.Reach);
        var places = new List<LimbSocket>();
        foreach (LegSite site in preset.SitesWithin(builder.MinLegPairs, builder.MaxLegPairs))
        {
            bool jointed = IsJointed(site.Archetype);
            double half = 0.5 * measure.At(site.Ring).Thickness;
            double stout = jointed ? Scalar.Lerp(1, Scalar.Clamp(Math.Sqrt(half / SlightTrunk), 1, MaxStout), builder.Fitting) : 1;
            double girth = stout * preset.Thickness * site.Thickness / half;
            places.Add(new LimbSocket(site.Ring, site.Segment, site.Archetype, girth, reach * site.Reach / measure.BodyLength, site.Azimuth, jointed ? SocketBounds.Insect : SocketBounds.Limb));
        }

        var stance = new StanceLimits(MinimumLength: 0.01, MaximumRaise: 0.5, RearwardShear: -0.3, ForwardShear: 0.3, MaximumPitchDegrees: 3, MaximumFootGrowth: 1.5, LowerPlan: builder.Plan, FewerPlan: builder.Plan) { BalanceMargin = SafeMargin(builder) };
        return new SocketSet(builder.Plan, places, places.Count, null, stance) { TakesAll = true };
    }

    /// <summary>The hips of a bird.</summary>
    public static SocketSet SetOf(CreatureBuilder builder, BirdPreset preset)
    {
        double girth = CreatureBuilder.Between(builder.Stream("thigh"), preset.Thigh);
        var hips = new List<LimbSocket>();
        for (int ring = 34; ring <= 38; ring++)
        {
            hips.Add(new LimbSocket(ring, preset.HipSegment, LimbArchetype.Bird, girth, 0, 0, SocketBounds.Limb));
        }

        var stance = new StanceLimits(MinimumLength: 0.12, MaximumRaise: 0.45, RearwardShear: -0.05, ForwardShear: 0.5, MaximumPitchDegrees: 22, MaximumFootGrowth: 1.6, LowerPlan: BodyPlan.Theropod, FewerPlan: BodyPlan.Theropod) { BalanceMargin = SafeMargin(builder) };
        return new SocketSet(BodyPlan.Theropod, hips, 1, null, stance);
    }

    /// <summary>Adds the limbs that a walker holds up.</summary>
    public static void AddArms(CreatureBuilder builder, LegStyle style, LegPreset preset)
    {
        foreach (LegSite site in preset.Arms)
        {
            SocketBlueprint socket = SocketSizing.Centre(site.Ring, site.Segment, SocketBounds.Insect.MinimumRows, SocketBounds.Insect.MinimumColumns);
            LegSampler.Add(builder, style with { Toes = 1 }, site.Archetype, LegStance.Hanging, socket, preset.Thickness * site.Thickness, site.Reach, site.Reach, 0, 0, 0);
        }
    }

    /// <summary>Least and largest thickness of a swimmer's leg, part of the depth of its body there, and how much larger its feet are: thin arms with small hands on a full body were sticks, thick ones on a thin body are all that is seen of it. Slimmer legs are shorter by the root of it.</summary>
    private const double PaddleThickness = 0.22;
    private const double ThickestPaddle = 0.3;
    private const double PaddleFoot = 1.1;

    /// <summary>Length of the forelegs of a swimmer that has no others, relative to those of one on four: as long as these they are the legs of a walker under a fish.</summary>
    private const double ArmsAlone = 0.8;

    /// <summary>Probability at full strangeness that a swimmer which a tail fin drives has arms for the fins beside it: hands on a fish look stuck on.</summary>
    private const double ArmedFish = 0.4;

    /// <summary>Hangs the legs of a swimmer that has any: before a tail fin that drives it hind legs would hang in its way, as whales and sea cows know.</summary>
    public static void Paddle(CreatureBuilder builder, LegStyle style)
    {
        if (builder.Parents.Paddles is not LegPreset preset)
        {
            return;
        }

        bool finned = FinSampler.IsDrivenByTailFin(builder);
        if (finned && builder.MinLegPairs == 0 && !builder.Stream("arms of fish").Chance(ArmedFish * builder.Strangeness))
        {
            return;
        }

        style = StyleOf(builder, style, preset);
        style = style with { FootSize = PaddleFoot * style.FootSize };
        SpineMeasure measure = LegSampler.Measure(builder);
        double reach = CreatureBuilder.Between(builder.Stream("reach"), preset.Reach);
        bool frontOnly = finned && builder.MinLegPairs < preset.Sites.Length;
        foreach (LegSite site in preset.Sites)
        {
            if (frontOnly && site.Ring > BodyGrid.AnchorRing)
            {
                continue;
            }

            SpineSection section = measure.At(site.Ring);
            double thickness = Math.Max(preset.Thickness * site.Thickness, PaddleThickness * section.Thickness);
            double slimmer = PortableMath.Pow(Math.Min(1, ThickestPaddle * section.Thickness / thickness), builder.Fitting);
            thickness *= slimmer;
            double length = (frontOnly ? Scalar.Lerp(1, ArmsAlone, builder.Fitting) : 1) * Math.Sqrt(slimmer);
            SocketBlueprint socket = SocketSizing.Size(
                site.Ring, site.Segment, thickness, thickness * 0.8, section.RingSpacing, SocketSizing.SegmentSpacing(section.HipWidth, section.Thickness), style.Toes, SocketBounds.Limb);
            LegSampler.Add(builder, style, site.Archetype, LegStance.Hanging, socket, thickness, length * preset.HangingLength, length * reach * site.Reach, site.Azimuth, 0, SocketBounds.Limb.Pad);
        }
    }

    private static bool IsJointed(LimbArchetype archetype) => LegKinds.Of(archetype).Outline.Jointed;

    /// <summary>Parts of other parents weigh what the estimate does not know.</summary>
    private static double SafeMargin(CreatureBuilder builder) => Balance.MinMargin * (1 + (2 * builder.Strangeness));
}
