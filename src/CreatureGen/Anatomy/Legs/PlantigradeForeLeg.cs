namespace CreatureGen.Anatomy.Legs;

/// <summary>A fore leg on its sole, as bears have it.</summary>
internal static class PlantigradeForeLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.PlantigradeFore,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 6,
            MinThickness = 0.24,
            MaxThickness = 0.31,
            FootRows = 2,
            ToeLength = 0.38,
            ToeSplay = 0.22,
            ToeRadius = 0.2,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 850 },
                new() { Forward = 20, Down = 220, Outward = 50, ForeRadius = 810, SideRadius = 720 },
                new() { Forward = -70, Down = 460, Outward = 40, ForeRadius = 620, SideRadius = 450, ForeOffset = -60 },
                new() { Forward = -25, Down = 620, Outward = 30, ForeRadius = 485, SideRadius = 480 },
                new() { Forward = -10, Down = 800, Outward = 20, ForeRadius = 315, SideRadius = 295 },
                new() { Forward = 80, Down = 915, Outward = 20, ForeRadius = 290, SideRadius = 485 },
                new() { Forward = 200, Down = 955, Outward = 20, ForeRadius = 270, SideRadius = 540 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.24,
            GreatestGirth = 0.31,
            SideGirth = 0.85,
            SwingDegrees = 32,
            FootForward = 0.15,
            FootOutward = 0.03,
            Heel = 0.30,
            Toe = 0.38,
            HalfWidth = 0.55,
        },
        limits: new LegLimits(
            hip: new(swingX: (-90, 60), swingZ: (-60, 30), twist: (-30, 30)),
            knee: new(swingX: (-115, 25), swingZ: (-5, 5), twist: (-15, 15)),
            ankle: new(swingX: (-35, 120), swingZ: (-30, 20), twist: (-30, 30)),
            ball: new(swingX: (-80, 50), swingZ: (-10, 10), twist: (-5, 5))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.12,
            Peak = 0.45,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 48,
            SwingPitchDegrees = 68,
            StrikeDegrees = -8,
            Bend = -1,
            MaxAdduction = 0.10f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: -0.30, knee: -1.25, ankle: 2.00, ball: 0.60),
            hanging: new LegPosture(hip: 0.15, knee: -0.80, ankle: 0.70, ball: 0.50),
            reaching: new LegPosture(hip: -0.30, knee: -0.20, ankle: 0.15, ball: 0.05))
        {
            Midmost = new LegPosture(hip: 0.30, knee: -0.90, ankle: 1.50, ball: 0.75),
            Hindmost = new LegPosture(hip: 0.95, knee: -0.15, ankle: 0.55, ball: 0.70),
        });
}
