namespace CreatureGen.Anatomy.Legs;

/// <summary>A fore leg on a hoof.</summary>
internal static class UnguligradeForeLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.UnguligradeFore,
        outline: new LegOutline(FootEnd.Hoof)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 6,
            MinThickness = 0.165,
            MaxThickness = 0.34,
            FootRows = 3,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 20, Down = 180, Outward = 40, ForeRadius = 740, SideRadius = 660, SideOffset = -60 },
                new() { Forward = -40, Down = 380, Outward = 30, ForeRadius = 470, SideRadius = 400, ForeOffset = -70 },
                new() { Forward = 4, Down = 590, Outward = 16, ForeRadius = 250, SideRadius = 205 },
                new() { Forward = 20, Down = 660, Outward = 10, ForeRadius = 250, SideRadius = 280 },
                new() { Forward = 10, Down = 780, Outward = 10, ForeRadius = 155, SideRadius = 142 },
                new() { Forward = 10, Down = 875, Outward = 10, ForeRadius = 200, SideRadius = 200 },
                new() { Forward = 40, Down = 930, Outward = 10, ForeRadius = 200, SideRadius = 210 },
                new() { Forward = 55, Down = 965, Outward = 10, ForeRadius = 270, SideRadius = 280 },
                new() { Forward = 70, Down = 1000, Outward = 10, ForeRadius = 310, SideRadius = 310 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.165,
            GreatestGirth = 0.34,
            SideGirth = 0.8,
            SwingDegrees = 32,
            FootForward = 0.07,
            FootOutward = 0.01,
            Heel = 0.31,
            Toe = 0.31,
            HalfWidth = 0.31,
        },
        limits: new LegLimits(
            hip: new(swingX: (-50, 50), swingZ: (-25, 18), twist: (-15, 15)),
            knee: new(swingX: (-95, 20), swingZ: (-5, 5), twist: (-8, 8)),
            ankle: new(swingX: (-8, 130), swingZ: (-7, 7), twist: (-10, 10)),
            ball: new(swingX: (-60, 100), swingZ: (-12, 12), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.10,
            Peak = 0.46,
            FoldDegrees = 54,
            UnfoldDegrees = 0,
            ToeOffDegrees = 52,
            SwingPitchDegrees = 92,
            StrikeDegrees = -4,
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
