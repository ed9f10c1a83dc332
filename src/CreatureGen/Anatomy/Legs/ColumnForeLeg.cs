namespace CreatureGen.Anatomy.Legs;

/// <summary>The fore leg of a body on pillars: the elbow behind, the wrist ahead, a broad foot below it.</summary>
internal static class ColumnForeLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.ColumnFore,
        outline: new LegOutline(FootEnd.Pad)
        {
            KneeRow = 2,
            AnkleRow = 5,
            BallRow = 7,
            MinThickness = 0.145,
            MaxThickness = 0.34,
            FootRows = 2,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 850 },
                new() { Forward = 40, Down = 210, Outward = 60, ForeRadius = 780, SideRadius = 690 },
                new() { Forward = -100, Down = 410, Outward = 50, ForeRadius = 550, SideRadius = 470 },
                new() { Forward = -30, Down = 545, Outward = 40, ForeRadius = 490, SideRadius = 490 },
                new() { Forward = 10, Down = 680, Outward = 30, ForeRadius = 355, SideRadius = 335 },
                new() { Forward = 40, Down = 785, Outward = 25, ForeRadius = 390, SideRadius = 410 },
                new() { Forward = 10, Down = 900, Outward = 25, ForeRadius = 345, SideRadius = 360 },
                new() { Forward = 25, Down = 1000, Outward = 25, ForeRadius = 585, SideRadius = 595 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.145,
            GreatestGirth = 0.34,
            SideGirth = 0.85,
            SwingDegrees = 28,
            FootForward = 0.01,
            FootOutward = 0.03,
            Heel = 0.66,
            Toe = 0.66,
            HalfWidth = 0.68,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 45), swingZ: (-25, 12), twist: (-15, 15)),
            knee: new(swingX: (-85, 8), swingZ: (-4, 4), twist: (-6, 6)),
            ankle: new(swingX: (-45, 90), swingZ: (-6, 6), twist: (-6, 6)),
            ball: new(swingX: (-30, 30), swingZ: (-5, 5), twist: (-5, 5))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.07,
            Peak = 0.42,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 22,
            SwingPitchDegrees = 32,
            StrikeDegrees = -3,
            Bend = -1,
            MaxAdduction = 0.03f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.40, knee: -0.80, ankle: 0.80, ball: 0.30),
            hanging: new LegPosture(hip: 0.10, knee: -0.45, ankle: 0.50, ball: 0.20),
            reaching: new LegPosture(hip: -0.20, knee: -0.10, ankle: 0.05, ball: 0)));
}
