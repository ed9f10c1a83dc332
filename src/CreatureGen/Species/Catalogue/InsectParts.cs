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
        new(FeatureKind.Mandible, Ring: 1.5, Segment: 8.5, Length: length, Radius: radius, Outward: 0, Upward: 0.1, Forward: 0.95, Sideward: sideward, BendUp: bendUp, BendForward: 0.1, BendSide: bendSide, Flatness: 1, Taper: 0.65);

    public static FeatureBlueprint NoseHorn(double length) => new(FeatureKind.Horn, Ring: 4, Segment: 0, Length: length, Radius: 0.048, Outward: 0, Upward: 0.55, Forward: 0.85, Sideward: 0, BendUp: 0.4, BendForward: -0.35, BendSide: 0, Flatness: 1, Taper: 0.7);

    public static FeatureBlueprint Feeler(double ring, double segment, double length, double radius, double outward, double upward, double forward, double bendUp, double bendForward, double knob = 0.3) =>
        new(FeatureKind.Antenna, ring, segment, length, radius, 0, upward, forward, outward, bendUp, bendForward, 0.12, knob, 0.6);

    public static PartSlot Elbowed() => new(new PartChoice(1, Part(Feeler(ring: 6, segment: 2.6, length: 0.36, radius: 0.013, outward: 0.35, upward: 1.05, forward: 0.35, bendUp: -0.75, bendForward: 0.7), 0.85, 1.1)));

    public static PartSlot Long(double length) => new(new PartChoice(1, Part(Feeler(ring: 6, segment: 2.6, length: length, radius: 0.011, outward: 0.42, upward: 0.8, forward: 0.75, bendUp: -0.3, bendForward: 0.15), 0.85, 1.2)));

    public static PartSlot SmallJaws() => new(new PartChoice(1, Part(Jaw(length: 0.07, radius: 0.022, sideward: 0, bendUp: -0.1, bendSide: -0.4), 0.8, 1.2)));

    public static PartPreset Ocellus(double ring, double segment, double radius) =>
        Part(new FeatureBlueprint(FeatureKind.Ocellus, ring, segment, Length: radius * 1.1, Radius: radius, Outward: 1, Upward: 0, Forward: 0, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 0.42), 1, 1);
}
