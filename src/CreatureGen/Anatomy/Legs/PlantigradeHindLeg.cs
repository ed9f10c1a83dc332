namespace CreatureGen.Anatomy.Legs;

/// <summary>A hind leg on its sole, as bears have it.</summary>
internal static class PlantigradeHindLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.PlantigradeHind,
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
                new() { Forward = 60, Down = 200, Outward = 60, ForeRadius = 980, SideRadius = 860, SideOffset = -70 },
                new() { Forward = 110, Down = 430, Outward = 60, ForeRadius = 680, SideRadius = 480, ForeOffset = -90 },
                new() { Forward = 20, Down = 620, Outward = 40, ForeRadius = 520, SideRadius = 490, ForeOffset = -40 },
                new() { Forward = -50, Down = 800, Outward = 30, ForeRadius = 350, SideRadius = 305, ForeOffset = -50 },
                new() { Forward = 60, Down = 915, Outward = 30, ForeRadius = 290, SideRadius = 485 },
                new() { Forward = 200, Down = 955, Outward = 30, ForeRadius = 270, SideRadius = 540 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.24,
            GreatestGirth = 0.31,
            SideGirth = 0.85,
            SwingDegrees = 32,
            FootForward = 0.14,
            FootOutward = 0.03,
            Heel = 0.30,
            Toe = 0.38,
            HalfWidth = 0.55,
        },
        limits: new LegLimits(
            hip: new(swingX: (-100, 40), swingZ: (-45, 25), twist: (-35, 35)),
            knee: new(swingX: (-15, 130), swingZ: (-5, 5), twist: (-10, 10)),
            ankle: new(swingX: (-40, 55), swingZ: (-15, 15), twist: (-30, 20)),
            ball: new(swingX: (-80, 45), swingZ: (-10, 10), twist: (-5, 5))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.085,
            Peak = 0.38,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 46,
            SwingPitchDegrees = 52,
            StrikeDegrees = -14,
            Bend = 1,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.55, knee: 0.90, ankle: 0.70, ball: 0.40),
            hanging: new LegPosture(hip: -0.05, knee: 0.45, ankle: 0.40, ball: 0.30),
            reaching: new LegPosture(hip: -0.45, knee: 0.20, ankle: -0.05, ball: -0.10))
        {
            Foremost = new LegPosture(hip: -0.40, knee: 1.40, ankle: 0.10, ball: 0.40),
            Midmost = new LegPosture(hip: 0.15, knee: 1.30, ankle: 0.40, ball: 0.40),
        });
}
