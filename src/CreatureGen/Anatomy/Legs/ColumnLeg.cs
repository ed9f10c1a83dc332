namespace CreatureGen.Anatomy.Legs;

/// <summary>A pillar, as elephants have it.</summary>
internal static class ColumnLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Column,
        outline: new LegOutline(FootEnd.Pad)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 6,
            MinThickness = 0.145,
            MaxThickness = 0.34,
            FootRows = 3,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 850 },
                new() { Forward = 40, Down = 220, Outward = 50, ForeRadius = 960, SideRadius = 850, SideOffset = -110 },
                new() { Forward = 75, Down = 450, Outward = 50, ForeRadius = 610, SideRadius = 490, ForeOffset = -30, SideOffset = -20 },
                new() { Forward = 10, Down = 660, Outward = 35, ForeRadius = 490, SideRadius = 470 },
                new() { Forward = -10, Down = 830, Outward = 30, ForeRadius = 350, SideRadius = 340 },
                new() { Forward = 20, Down = 925, Outward = 30, ForeRadius = 560, SideRadius = 575 },
                new() { Forward = 25, Down = 1000, Outward = 30, ForeRadius = 575, SideRadius = 590 },
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
            knee: new(swingX: (-8, 85), swingZ: (-4, 4), twist: (-6, 6)),
            ankle: new(swingX: (-45, 50), swingZ: (-6, 6), twist: (-6, 6)),
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
            Bend = 1,
            MaxAdduction = 0.03f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.40, knee: 0.60, ankle: 0.50, ball: 0.30),
            hanging: new LegPosture(hip: 0.10, knee: 0.35, ankle: 0.30, ball: 0.20),
            reaching: new LegPosture(hip: -0.20, knee: 0.10, ankle: 0, ball: 0))
        {
            Foremost = new LegPosture(hip: -0.20, knee: 0.90, ankle: 0.30, ball: 0.30),
            Midmost = new LegPosture(hip: 0.10, knee: 0.75, ankle: 0.40, ball: 0.30),
        });
}
