namespace CreatureGen.Anatomy.Legs;

/// <summary>The leg of a running biped.</summary>
internal static class TheropodLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Theropod,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 5,
            BallRow = 7,
            MinThickness = 0.145,
            MaxThickness = 0.34,
            FootRows = 2,
            ToeLength = 1.15,
            ToeSplay = 0.52,
            ToeRadius = 0.15,
            LongToed = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 90, Down = 160, Outward = 60, ForeRadius = 1040, SideRadius = 930, SideOffset = -130 },
                new() { Forward = 220, Down = 370, Outward = 60, ForeRadius = 720, SideRadius = 510, ForeOffset = -170, SideOffset = -35 },
                new() { Forward = 50, Down = 530, Outward = 40, ForeRadius = 520, SideRadius = 470, ForeOffset = -60 },
                new() { Forward = -65, Down = 665, Outward = 34, ForeRadius = 300, SideRadius = 220, ForeOffset = -40 },
                new() { Forward = -130, Down = 740, Outward = 30, ForeRadius = 280, SideRadius = 275, ForeOffset = -30 },
                new() { Forward = -60, Down = 890, Outward = 30, ForeRadius = 180, SideRadius = 170 },
                new() { Forward = -10, Down = 955, Outward = 30, ForeRadius = 220, SideRadius = 280 },
                new() { Forward = 60, Down = 968, Outward = 30, ForeRadius = 210, SideRadius = 340 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.145,
            GreatestGirth = 0.34,
            CarryingShank = 0.105,
            SideGirth = 0.8,
            SwingDegrees = 35,
            FootForward = 0.06,
            FootOutward = 0.03,
            Heel = 0.21,
            Toe = 1.15,
            HalfWidth = 0.60,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 60), swingZ: (-30, 20), twist: (-20, 20)),
            knee: new(swingX: (-30, 110), swingZ: (-5, 5), twist: (-10, 10)),
            ankle: new(swingX: (-110, 35), swingZ: (-5, 5), twist: (-8, 8)),
            ball: new(swingX: (-95, 70), swingZ: (-15, 15), twist: (-12, 12))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.14,
            Peak = 0.38,
            FoldDegrees = 48,
            UnfoldDegrees = -16,
            ToeOffDegrees = 55,
            SwingPitchDegrees = 85,
            StrikeDegrees = -8,
            Bend = 1,
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
