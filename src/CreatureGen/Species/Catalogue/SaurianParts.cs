using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Reptiles with a collar: horned dinosaurs and frilled lizards.</summary>
internal static class SaurianParts
{
    public static readonly PartPreset[] NoseHorn = { Horn(2.6, 0, 0.13, 0.045, 0.2) };

    public static readonly PartPreset[] BrowHorns = { Horn(9.2, 3.2, 0.30, 0.042, 0.5), Horn(2.6, 0, 0.07, 0.04, 0.2) };

    public static PartPreset Horn(double ring, double segment, double length, double radius, double forward) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, segment, length, radius, 0.5, 0.6, forward, 0.15, 0.1, 0.25, -0.05, 1, 1), 0.8, 1.3);
}
