using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Hedgehogs.</summary>
internal static class Hedgehog
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "hedgehog",
        Table = new BodyTable(
            2.1,
            2.4,
            (0, -22, 24, 22, 20),     // nose
            (30, -22, 40, 34, 32),    // muzzle, front
            (55, -22, 52, 44, 44),    // muzzle
            (55, -26, 76, 66, 60),    // stop
            (50, -28, 112, 104, 82),  // brow
            (60, -16, 134, 126, 100), // cranium
            (60, 8, 140, 140, 118),   // nape
            (60, 26, 158, 168, 138),  // neck
            (80, 26, 186, 200, 164),  // neck base
            (110, 12, 220, 236, 190), // shoulders
            (180, 0, 252, 262, 212),  // ribs
            (180, -2, 268, 264, 216), // belly
            (160, 4, 258, 246, 206),  // loin
            (140, 20, 216, 204, 176), // pelvis
            (70, 34, 120, 118, 108),  // tail base
            (40, 36, 52, 52, 50),     // tail, first third
            (36, 34, 30, 30, 28),     // tail, second third
            (30, 32, 12, 12, 12)),    // tail tip
        TailHair = null,
        TorsoLength = (0.12, 0.18),
        Frequency = (0.22, 0, 0),
        OnlyByName = true,
        Dominance = (0.93, 0.98),
        Kinship = 0,
        HeadSize = (1.12, 0.6),
        HipHeight = (0.34, 0.40), LegGirth = 0.7,
        WalkingPlans = Weights.Of((BodyPlan.Plantigrade, 1)),
        Eye = (9.2, 5.2), EyeSize = 0.26,
        HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Round, 1)), EarSize = 0.7,
        Dentition = PegTeeth.Teeth, ToothLength = 0.08, Tusked = false, Antlered = false,
        Parts = new[] { new PartSlot(new PartChoice(1, Quills())) },
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Mottle, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.46, 0.05, 62)) { Kind = PatternKind.Mottle, Belly = new Tint(0.82, 0.04, 80), Limb = new Tint(0.70, 0.05, 65) },
            new Colouring(new Tint(0.30, 0.03, 55)) { Kind = PatternKind.Plain, Belly = new Tint(0.74, 0.04, 75), Limb = new Tint(0.52, 0.05, 55) },
            new Colouring(new Tint(0.86, 0.03, 85)) { Kind = PatternKind.Plain, Limb = new Tint(0.80, 0.06, 40) },
        },
    };

    /// <summary>Rows of short spines over back and flanks, each row between those of its neighbours.</summary>
    private static PartPreset[] Quills()
    {
        var quills = new List<PartPreset>();
        for (int row = 0; row < 11; row++)
        {
            for (double segment = row % 2 == 0 ? 0.9 : 2; segment < 9.5; segment += 2.2)
            {
                quills.Add(new PartPreset(new FeatureBlueprint(FeatureKind.Spike, Ring: 15.5 + (2.8 * row), Segment: segment, Length: 0.12, Radius: 0.013, Outward: 1, Upward: 0.1, Forward: -0.7, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1), 0.85, 1.2));
            }
        }

        return quills.ToArray();
    }
}
