using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Mammals on land: what decides is neck and muzzle, the line of the back, hair, ears and horns.</summary>
internal static class MammalParts
{
    public static PartPreset NoseHorn(double ring, double length, double radius) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, Segment: 0, Length: length, Radius: radius, Outward: 0.75, Upward: 0.55, Forward: 0.35, Sideward: 0, BendUp: 0.1, BendForward: -0.3, BendSide: 0, Flatness: 1, Taper: 1), 0.8, 1.3);
}
