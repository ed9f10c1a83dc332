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
            tufts[q] = new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, 11 + (q * 0.9), 0, length, 0.024, 0.8, 0, -0.6, 0, 0.1, -0.3, 0, 0.5, 0.7), 0.85, 1.3);
        }

        return tufts;
    }

    /// <summary>A long feather over each eye.</summary>
    public static PartPreset[] Brows() => new[]
    {
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, 9.4, 4.0, 0.2, 0.016, 0.35, 0.2, -0.8, 0.5, -0.15, 0, 0, 0.6, 0.8), 0.8, 1.3),
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, 10.2, 3.4, 0.15, 0.014, 0.4, 0.3, -0.8, 0.4, -0.1, 0, 0, 0.6, 0.8), 0.8, 1.3),
    };

    /// <summary>Two long feathers from the nape.</summary>
    public static PartPreset[] Plumes() => new[]
    {
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, 13.5, 1.0, 0.26, 0.014, 0.35, 0.1, -1, 0, -0.35, 0, 0, 0.6, 0.8), 0.8, 1.3),
        new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, 13.0, 0, 0.2, 0.014, 0.4, 0.1, -1, 0, -0.3, 0, 0, 0.6, 0.8), 0.8, 1.3),
    };
}
