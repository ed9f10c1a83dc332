using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Mammals on land: what decides is neck and muzzle, the line of the back, hair, ears and horns.</summary>
internal static class MammalParts
{
    public static PartPreset NoseHorn(double ring, double length, double radius) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, 0, length, radius, 0.75, 0.55, 0.35, 0, 0.1, -0.3, 0, 1, 1), 0.8, 1.3);
}
