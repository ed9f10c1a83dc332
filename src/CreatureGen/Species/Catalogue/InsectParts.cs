using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Insects and their kin: what decides is waist and abdomen, height of the knees, feelers and jaws, wings.</summary>
internal static class InsectParts
{
    /// <summary>What they have in common.</summary>
    public static readonly SpeciesProfile Common = Insect.Profile with
    {
        Dominance = (0.86, 0.96),
        Kinship = 0.6,
        Variety = 0.35,
        TiltVariety = 0.35,
        LatticeSpread = 0.16,
        HeadSize = (1.06, 0.7),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
        EyeStyle = EyeStyle.Compound,
        EyeSink = 0.45,
    };

    public static LegSite[] Sixth(double front, double middle, double rear) => new[]
    {
        new LegSite(LimbArchetype.Insect) { Ring = 24, Segment = 9.7, Azimuth = front, Reach = 1.05 },
        new LegSite(LimbArchetype.Insect) { Ring = 28, Segment = 9.7, Azimuth = middle },
        new LegSite(LimbArchetype.Insect) { Ring = 32, Segment = 9.7, Azimuth = rear, Reach = 1.06 },
    };

    public static PartPreset Part(FeatureBlueprint part, double min, double max) => new(part, min, max);

    public static FeatureBlueprint Jaw(double length, double radius, double sideward, double bendUp, double bendSide) =>
        new(FeatureKind.Mandible, 1.5, 8.5, length, radius, 0, 0.1, 0.95, sideward, bendUp, 0.1, bendSide, 1, 0.65);

    public static FeatureBlueprint NoseHorn(double length) => new(FeatureKind.Horn, 4, 0, length, 0.048, 0, 0.55, 0.85, 0, 0.4, -0.35, 0, 1, 0.7);

    public static FeatureBlueprint Feeler(double ring, double segment, double length, double radius, double outward, double upward, double forward, double bendUp, double bendForward, double knob = 0.3) =>
        new(FeatureKind.Antenna, ring, segment, length, radius, 0, upward, forward, outward, bendUp, bendForward, 0.12, knob, 0.6);

    public static PartSlot Elbowed() => new(new PartChoice(1, Part(Feeler(6, 2.6, 0.36, 0.013, 0.35, 1.05, 0.35, -0.75, 0.7), 0.85, 1.1)));

    public static PartSlot Long(double length) => new(new PartChoice(1, Part(Feeler(6, 2.6, length, 0.011, 0.42, 0.8, 0.75, -0.3, 0.15), 0.85, 1.2)));

    public static PartSlot SmallJaws() => new(new PartChoice(1, Part(Jaw(0.07, 0.022, 0, -0.1, -0.4), 0.8, 1.2)));

    public static PartPreset Ocellus(double ring, double segment, double radius) =>
        Part(new FeatureBlueprint(FeatureKind.Ocellus, ring, segment, Length: radius * 1.1, Radius: radius, Outward: 1, Upward: 0, Forward: 0, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 0.42), 1, 1);
}
