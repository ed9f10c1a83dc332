namespace CreatureGen.Anatomy.Legs;

/// <summary>The slender leg of a bird.</summary>
internal static class BirdLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Bird,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 3,
            AnkleRow = 5,
            BallRow = 7,
            MinThickness = 0.05,
            MaxThickness = 0.34,
            FootRows = 2,
            ToeLength = 1.25,
            ToeSplay = 0.5,
            ToeRadius = 0.15,
            LongToed = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 50, Down = 140, Outward = 70, ForeRadius = 960, SideRadius = 870, SideOffset = -130 },
                new() { Forward = 130, Down = 320, Outward = 70, ForeRadius = 640, SideRadius = 620, SideOffset = -75 },
                new() { Forward = 80, Down = 480, Outward = 55, ForeRadius = 430, SideRadius = 360, ForeOffset = -50 },
                new() { Forward = -45, Down = 660, Outward = 30, ForeRadius = 225, SideRadius = 200 },
                new() { Forward = -95, Down = 760, Outward = 22, ForeRadius = 250, SideRadius = 265 },
                new() { Forward = -40, Down = 900, Outward = 18, ForeRadius = 168, SideRadius = 158 },
                new() { Forward = 0, Down = 960, Outward = 18, ForeRadius = 190, SideRadius = 250 },
                new() { Forward = 60, Down = 970, Outward = 18, ForeRadius = 180, SideRadius = 300 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.05,
            GreatestGirth = 0.34,
            CarryingShank = 0.079,
            SideGirth = 0.8,
            SwingDegrees = 35,
            FootForward = 0.06,
            FootOutward = 0.06,
            Heel = 0.19,
            Toe = 1.25,
            HalfWidth = 0.62,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 60), swingZ: (-30, 20), twist: (-20, 20)),
            knee: new(swingX: (-30, 110), swingZ: (-5, 5), twist: (-10, 10)),
            ankle: new(swingX: (-110, 35), swingZ: (-14, 14), twist: (-8, 8)),
            ball: new(swingX: (-95, 70), swingZ: (-15, 15), twist: (-16, 16))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.16,
            Peak = 0.38,
            FoldDegrees = 52,
            UnfoldDegrees = -16,
            ToeOffDegrees = 55,
            SwingPitchDegrees = 85,
            StrikeDegrees = -8,
            Bend = 1,
            Immersion = 0.4f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 1.15, knee: 0.10, ankle: 0.55, ball: 0.90),
            hanging: new LegPosture(hip: -0.10, knee: 0.45, ankle: 0.20, ball: 0.70),
            reaching: new LegPosture(hip: -0.45, knee: 0.10, ankle: -0.05, ball: -0.25))
        {
            Foremost = new LegPosture(hip: -0.20, knee: 1.20, ankle: -1.20, ball: 0.60),
            Midmost = new LegPosture(hip: 0.50, knee: 1.00, ankle: 0.10, ball: 0.90),
        });
}
