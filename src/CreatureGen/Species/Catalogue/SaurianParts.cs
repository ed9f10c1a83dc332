using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Reptiles with a collar: horned dinosaurs and frilled lizards.</summary>
internal static class SaurianParts
{
    public static readonly PartPreset[] NoseHorn = { Horn(2.6, 0, 0.13, 0.045, 0.2) };

    public static readonly PartPreset[] BrowHorns = { Horn(9.2, 3.2, 0.30, 0.042, 0.5), Horn(2.6, 0, 0.07, 0.04, 0.2) };

    public static PartPreset Horn(double ring, double segment, double length, double radius, double forward) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, segment, length, radius, Outward: 0.5, Upward: 0.6, Forward: forward, Sideward: 0.15, BendUp: 0.1, BendForward: 0.25, BendSide: -0.05, Flatness: 1, Taper: 1), 0.8, 1.3);
}
