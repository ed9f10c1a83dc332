namespace CreatureGen.Anatomy.Legs;

/// <summary>A fore leg on its toes, as dogs and cats have it.</summary>
internal static class DigitigradeForeLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.DigitigradeFore,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 5,
            MinThickness = 0.185,
            MaxThickness = 0.34,
            FootRows = 2,
            ToeLength = 0.4,
            ToeSplay = 0.22,
            ToeRadius = 0.19,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 20, Down = 180, Outward = 40, ForeRadius = 725, SideRadius = 610 },
                new() { Forward = -70, Down = 400, Outward = 30, ForeRadius = 465, SideRadius = 350, ForeOffset = -25 },
                new() { Forward = -30, Down = 570, Outward = 20, ForeRadius = 340, SideRadius = 340 },
                new() { Forward = 0, Down = 820, Outward = 10, ForeRadius = 220, SideRadius = 198 },
                new() { Forward = 30, Down = 945, Outward = 10, ForeRadius = 270, SideRadius = 365 },
                new() { Forward = 110, Down = 965, Outward = 10, ForeRadius = 260, SideRadius = 440 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.19,
            GreatestGirth = 0.34,
            SideGirth = 0.8,
            SwingDegrees = 35,
            FootForward = 0.11,
            FootOutward = 0.01,
            Heel = 0.26,
            Toe = 0.40,
            HalfWidth = 0.42,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 60), swingZ: (-35, 20), twist: (-20, 20)),
            knee: new(swingX: (-105, 27), swingZ: (-5, 5), twist: (-10, 10)),
            ankle: new(swingX: (-20, 140), swingZ: (-16, 16), twist: (-30, 30)),
            ball: new(swingX: (-95, 60), swingZ: (-15, 15), twist: (-15, 15))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.14,
            Peak = 0.46,
            FoldDegrees = 48,
            UnfoldDegrees = 0,
            ToeOffDegrees = 45,
            SwingPitchDegrees = 80,
            StrikeDegrees = -6,
            Bend = -1,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: -0.30, knee: -1.25, ankle: 2.20, ball: 0.80),
            hanging: new LegPosture(hip: 0.20, knee: -0.90, ankle: 1.20, ball: 0.70),
            reaching: new LegPosture(hip: -0.30, knee: -0.20, ankle: 0.15, ball: 0.05))
        {
            Midmost = new LegPosture(hip: 0.30, knee: -0.90, ankle: 1.50, ball: 0.75),
            Hindmost = new LegPosture(hip: 0.95, knee: -0.15, ankle: 0.55, ball: 0.70),
        });
}
