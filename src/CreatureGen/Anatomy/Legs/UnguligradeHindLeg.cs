namespace CreatureGen.Anatomy.Legs;

/// <summary>A hind leg on a hoof.</summary>
internal static class UnguligradeHindLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.UnguligradeHind,
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
                new() { Forward = 50, Down = 170, Outward = 50, ForeRadius = 940, SideRadius = 830, SideOffset = -100 },
                new() { Forward = 90, Down = 340, Outward = 40, ForeRadius = 620, SideRadius = 490, ForeOffset = -100, SideOffset = -35 },
                new() { Forward = -85, Down = 545, Outward = 14, ForeRadius = 310, SideRadius = 205, ForeOffset = -35 },
                new() { Forward = -130, Down = 610, Outward = 10, ForeRadius = 285, SideRadius = 270, ForeOffset = -40 },
                new() { Forward = -100, Down = 760, Outward = 10, ForeRadius = 165, SideRadius = 150 },
                new() { Forward = -80, Down = 875, Outward = 10, ForeRadius = 210, SideRadius = 210 },
                new() { Forward = -40, Down = 930, Outward = 10, ForeRadius = 200, SideRadius = 210 },
                new() { Forward = -15, Down = 965, Outward = 10, ForeRadius = 270, SideRadius = 280 },
                new() { Forward = 0, Down = 1000, Outward = 10, ForeRadius = 310, SideRadius = 310 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.165,
            GreatestGirth = 0.34,
            SideGirth = 0.8,
            SwingDegrees = 32,
            FootForward = 0,
            FootOutward = 0,
            Heel = 0.31,
            Toe = 0.31,
            HalfWidth = 0.31,
        },
        limits: new LegLimits(
            hip: new(swingX: (-55, 50), swingZ: (-35, 15), twist: (-20, 20)),
            knee: new(swingX: (-25, 100), swingZ: (-5, 5), twist: (-8, 8)),
            ankle: new(swingX: (-110, 25), swingZ: (-5, 5), twist: (-8, 8)),
            ball: new(swingX: (-60, 95), swingZ: (-12, 12), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Pantograph)
        {
            Lift = 0.075,
            Peak = 0.40,
            FoldDegrees = 42,
            UnfoldDegrees = -14,
            ToeOffDegrees = 55,
            SwingPitchDegrees = 70,
            StrikeDegrees = -4,
            Bend = 1,
            RestPitch = 0.66f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.70, knee: 0.60, ankle: 0.30, ball: 0.85),
            hanging: new LegPosture(hip: 0.10, knee: 0.50, ankle: -0.20, ball: 0.70),
            reaching: new LegPosture(hip: -0.40, knee: 0.15, ankle: -0.10, ball: -0.10))
        {
            Foremost = new LegPosture(hip: -0.40, knee: 1.30, ankle: -0.90, ball: 0.80),
            Midmost = new LegPosture(hip: 0.25, knee: 1.20, ankle: -0.30, ball: 0.85),
        });
}
