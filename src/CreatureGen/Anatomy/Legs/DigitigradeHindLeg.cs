namespace CreatureGen.Anatomy.Legs;

/// <summary>A hind leg on its toes, as dogs and cats have it.</summary>
internal static class DigitigradeHindLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.DigitigradeHind,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 5,
            BallRow = 7,
            MinThickness = 0.19,
            MaxThickness = 0.34,
            FootRows = 2,
            ToeLength = 0.4,
            ToeSplay = 0.22,
            ToeRadius = 0.19,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 60, Down = 170, Outward = 50, ForeRadius = 1020, SideRadius = 830, SideOffset = -80 },
                new() { Forward = 120, Down = 370, Outward = 50, ForeRadius = 590, SideRadius = 445, ForeOffset = -40, SideOffset = -20 },
                new() { Forward = -20, Down = 530, Outward = 30, ForeRadius = 450, SideRadius = 415, ForeOffset = -30 },
                new() { Forward = -110, Down = 635, Outward = 24, ForeRadius = 300, SideRadius = 220, ForeOffset = -35 },
                new() { Forward = -170, Down = 700, Outward = 20, ForeRadius = 285, SideRadius = 275, ForeOffset = -40 },
                new() { Forward = -130, Down = 860, Outward = 20, ForeRadius = 190, SideRadius = 178 },
                new() { Forward = -70, Down = 945, Outward = 20, ForeRadius = 270, SideRadius = 355 },
                new() { Forward = 30, Down = 965, Outward = 20, ForeRadius = 260, SideRadius = 440 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.19,
            GreatestGirth = 0.34,
            SideGirth = 0.8,
            SwingDegrees = 35,
            FootForward = 0.03,
            FootOutward = 0.02,
            Heel = 0.26,
            Toe = 0.40,
            HalfWidth = 0.42,
        },
        limits: new LegLimits(
            hip: new(swingX: (-65, 55), swingZ: (-50, 20), twist: (-25, 25)),
            knee: new(swingX: (-27, 100), swingZ: (-5, 5), twist: (-10, 10)),
            ankle: new(swingX: (-100, 30), swingZ: (-8, 8), twist: (-12, 12)),
            ball: new(swingX: (-95, 60), swingZ: (-15, 15), twist: (-15, 15))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.13,
            Peak = 0.40,
            FoldDegrees = 40,
            UnfoldDegrees = -12,
            ToeOffDegrees = 50,
            SwingPitchDegrees = 70,
            StrikeDegrees = -6,
            Bend = 1,
            RestPitch = 0.33f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.75, knee: 0.55, ankle: 0.30, ball: 0.85),
            hanging: new LegPosture(hip: 0.10, knee: 0.50, ankle: -0.20, ball: 0.70),
            reaching: new LegPosture(hip: -0.40, knee: 0.15, ankle: -0.10, ball: -0.10))
        {
            Foremost = new LegPosture(hip: -0.40, knee: 1.30, ankle: -0.90, ball: 0.80),
            Midmost = new LegPosture(hip: 0.25, knee: 1.20, ankle: -0.30, ball: 0.85),
        });
}
