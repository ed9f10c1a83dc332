using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Birds: a beak is the pitch of the first stations of the table; legs, folded wing and tail fan are proportions.</summary>
internal static class BirdParts
{
    /// <summary>What they have in common.</summary>
    public static readonly SpeciesProfile Common = Avian.Profile.Tamed() with
    {
        HeadSize = (1.12, 0.7),
        LatticeSpread = 0.16,
        HeadOrnament = (0, 0),
        WingMembrane = 0,
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Theropod, 1) },
        FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
    };

    /// <summary>Five tufts over the crown.</summary>
    public static PartPreset[] Crest(double size)
    {
        var tufts = new PartPreset[5];
        for (int q = 0; q < tufts.Length; q++)
        {
            double length = 0.12 * size * (1 - (0.5 * System.Math.Abs((q / 4.0) - 0.35)));
            tufts[q] = new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 11 + (q * 0.9), Segment: 0, Length: length, Radius: 0.024, Outward: 0.8, Upward: 0, Forward: -0.6, Sideward: 0, BendUp: 0.1, BendForward: -0.3, BendSide: 0, Flatness: 0.5, Taper: 0.7), 0.85, 1.3);
        }

        return tufts;
    }

    /// <summary>A long feather over each eye.</summary>
    public static PartPreset[] Brows() => new[]
    {
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 9.4, Segment: 4.0, Length: 0.2, Radius: 0.016, Outward: 0.35, Upward: 0.2, Forward: -0.8, Sideward: 0.5, BendUp: -0.15, BendForward: 0, BendSide: 0, Flatness: 0.6, Taper: 0.8), 0.8, 1.3),
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 10.2, Segment: 3.4, Length: 0.15, Radius: 0.014, Outward: 0.4, Upward: 0.3, Forward: -0.8, Sideward: 0.4, BendUp: -0.1, BendForward: 0, BendSide: 0, Flatness: 0.6, Taper: 0.8), 0.8, 1.3),
    };

    /// <summary>Two long feathers from the nape.</summary>
    public static PartPreset[] Plumes() => new[]
    {
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 13.5, Segment: 1.0, Length: 0.26, Radius: 0.014, Outward: 0.35, Upward: 0.1, Forward: -1, Sideward: 0, BendUp: -0.35, BendForward: 0, BendSide: 0, Flatness: 0.6, Taper: 0.8), 0.8, 1.3),
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 13.0, Segment: 0, Length: 0.2, Radius: 0.014, Outward: 0.4, Upward: 0.1, Forward: -1, Sideward: 0, BendUp: -0.3, BendForward: 0, BendSide: 0, Flatness: 0.6, Taper: 0.8), 0.8, 1.3),
    };
}
