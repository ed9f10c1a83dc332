using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Swimmers, and those of them that walk as well.</summary>
internal static class SwimmerParts
{
    public static LegPreset Paddling(double thickness, double claw) => new()
    {
        Sites = new[]
        {
            new LegSite(LimbArchetype.Sprawl) { Ring = 27, Segment = 9.7, Azimuth = -0.1, Reach = 0.95, Thickness = 0.88 },
            new LegSite(LimbArchetype.Sprawl) { Ring = 41, Segment = 9.8, Azimuth = -0.3 },
        },
        Reach = (0.24, 0.28), HangingLength = 0.2, Thickness = thickness, Claw = claw,
    };

    public static PartPreset[] Scutes()
    {
        var rows = new System.Collections.Generic.List<PartPreset>();
        for (int ring = 18; ring < 52; ring += 2)
        {
            double size = ring < 26 ? 0.026 : ring < 44 ? 0.034 : 0.03;
            rows.Add(Scute(ring, ring < 44 ? 1.3 : 1.0, size));
            if (ring < 44)
            {
                rows.Add(Scute(ring, 3.2, size));
            }
        }

        return rows.ToArray();
    }

    public static PartPreset Scute(double ring, double segment, double size) =>
        new(new FeatureBlueprint(FeatureKind.Scute, ring, segment, Length: size, Radius: size * 0.95, Outward: 0.9, Upward: 0, Forward: -0.5, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 0.75, Taper: 0.8), 0.85, 1.15);

    /// <summary>Rows of short spines over back and flanks.</summary>
    public static PartPreset[] Quills(double length)
    {
        var quills = new System.Collections.Generic.List<PartPreset>();
        for (int row = 0; row < 5; row++)
        {
            double first = 1.6 + (row % 2 * 1.1);
            for (double segment = first; segment < 14; segment += 2.6)
            {
                quills.Add(new PartPreset(new FeatureBlueprint(FeatureKind.Spike, Ring: 18 + (3.6 * row), Segment: segment, Length: length, Radius: 0.012 + (0.05 * length), Outward: 1, Upward: 0, Forward: -0.45, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1), 0.85, 1.2));
            }
        }

        return quills.ToArray();
    }

    public static PartPreset[] Gills()
    {
        var plumes = new PartPreset[3];
        for (int k = 0; k < plumes.Length; k++)
        {
            plumes[k] = new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 16.5 + k, Segment: 4.5 + (1.6 * k), Length: 0.17, Radius: 0.032, Outward: 1, Upward: 0.45 - (0.35 * k), Forward: -0.55, Sideward: 0.2, BendUp: -0.12, BendForward: -0.3, BendSide: 0, Flatness: 1, Taper: 0.7), 0.8, 1.2);
        }

        return plumes;
    }
}
