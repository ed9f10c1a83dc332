using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Limbs.Attachment;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Legs that a species brings with it: where its kit puts them, not where the rules of its plan would choose.</summary>
internal static class OwnLegs
{
    /// <summary>The style of legs of a kit.</summary>
    public static LegStyle StyleOf(CreatureDraft draft, LegStyle style, LegKit kit)
    {
        RandomStream random = draft.Stream("own legs");
        return style with
        {
            Slimness = IsJointed(kit.Sites[0].Archetype) ? 1 : style.Slimness,
            FootSize = IsJointed(kit.Sites[0].Archetype) ? 1 : 1.2,
            Toes = IsJointed(kit.Sites[0].Archetype) ? 0 : random.Integer(kit.Toes.Least, kit.Toes.Most + 1),
            ClawLength = kit.Claw,
            KneeRise = kit.KneeRise,
        };
    }

    /// <summary>The style of a bird's legs.</summary>
    public static LegStyle StyleOf(CreatureDraft draft, LegStyle style, BirdKit kit)
    {
        RandomStream random = draft.Stream("own legs");
        return style with
        {
            Slimness = random.Uniform(0.95, 1.1),
            Stoutness = 1,
            FootSize = style.FootSize * kit.Foot,
            Toes = kit.Toes,
            ClawLength = kit.Claw,
        };
    }

    /// <summary>The places of a kit on the body as it is.</summary>
    public static SocketSet SetOf(CreatureDraft draft, LegKit kit, SpineMeasure measure)
    {
        double reach = CreatureDraft.Between(draft.Stream("reach"), kit.Reach);
        var places = new List<LimbSocket>();
        foreach (LegSite site in kit.Sites)
        {
            bool jointed = IsJointed(site.Archetype);
            double girth = kit.Thickness * site.Thickness / (0.5 * measure.At(site.Ring).Thickness);
            places.Add(new LimbSocket(site.Ring, site.Segment, site.Archetype, girth, reach * site.Reach / measure.BodyLength, site.Azimuth, jointed ? SocketBounds.Insect : SocketBounds.Limb));
        }

        var stance = new StanceLimits(0.01, 0.5, -0.3, 0.3, 3, 1.5, draft.Plan, draft.Plan);
        return new SocketSet(draft.Plan, places, places.Count, null, stance) { TakesAll = true };
    }

    /// <summary>The hips of a bird.</summary>
    public static SocketSet SetOf(CreatureDraft draft, BirdKit kit)
    {
        double girth = CreatureDraft.Between(draft.Stream("thigh"), kit.Thigh);
        var hips = new List<LimbSocket>();
        for (int ring = 34; ring <= 38; ring++)
        {
            hips.Add(new LimbSocket(ring, kit.HipSegment, LimbArchetype.Bird, girth, 0, 0, SocketBounds.Limb));
        }

        var stance = new StanceLimits(0.12, 0.45, -0.05, 0.5, 22, 1.6, BodyPlan.Theropod, BodyPlan.Theropod);
        return new SocketSet(BodyPlan.Theropod, hips, 1, null, stance);
    }

    /// <summary>Adds the limbs that a walker holds up.</summary>
    public static void AddArms(CreatureDraft draft, LegStyle style, LegKit kit)
    {
        foreach (LegSite site in kit.Arms)
        {
            SocketBlueprint socket = SocketSizing.Centre(site.Ring, site.Segment, SocketBounds.Insect.MinimumRows, SocketBounds.Insect.MinimumColumns);
            LegSampler.Add(draft, style with { Toes = 1 }, site.Archetype, LegStance.Hanging, socket, kit.Thickness * site.Thickness, site.Reach, site.Reach, 0, 0, 0);
        }
    }

    /// <summary>Hangs the legs of a swimmer that has any.</summary>
    public static void Paddle(CreatureDraft draft, LegStyle style)
    {
        if (draft.Species.Paddles is not LegKit kit)
        {
            return;
        }

        style = StyleOf(draft, style, kit);
        SpineMeasure measure = LegSampler.Measure(draft);
        double reach = CreatureDraft.Between(draft.Stream("reach"), kit.Reach);
        foreach (LegSite site in kit.Sites)
        {
            SpineSection section = measure.At(site.Ring);
            double thickness = kit.Thickness * site.Thickness;
            SocketBlueprint socket = SocketSizing.Size(
                site.Ring, site.Segment, thickness, thickness * 0.8, section.RingSpacing, SocketSizing.SegmentSpacing(section.HipWidth, section.Thickness), style.Toes, SocketBounds.Limb);
            LegSampler.Add(draft, style, site.Archetype, LegStance.Hanging, socket, thickness, kit.HangingLength, reach * site.Reach, site.Azimuth, 0, SocketBounds.Limb.Pad);
        }
    }

    private static bool IsJointed(LimbArchetype archetype) => archetype is LimbArchetype.Insect or LimbArchetype.Jumper or LimbArchetype.Raptorial;
}
