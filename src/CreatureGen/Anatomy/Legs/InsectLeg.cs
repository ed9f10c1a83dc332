namespace CreatureGen.Anatomy.Legs;

/// <summary>The arched leg of an insect.</summary>
internal static class InsectLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Insect,
        outline: new LegOutline(FootEnd.Point)
        {
            KneeRow = 3,
            AnkleRow = 6,
            BallRow = 7,
            Lateral = true,
            Jointed = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 1000 },
                new() { Forward = 0, Down = -60, Outward = 300, ForeRadius = 570, SideRadius = 700 },
                new() { Forward = 0, Down = -340, Outward = 720, ForeRadius = 940, SideRadius = 860 },
                new() { Forward = 0, Down = -480, Outward = 1050, ForeRadius = 460, SideRadius = 450 },
                new() { Forward = 0, Down = -380, Outward = 1220, ForeRadius = 355, SideRadius = 345 },
                new() { Forward = 0, Down = 50, Outward = 1420, ForeRadius = 270, SideRadius = 265 },
                new() { Forward = 0, Down = 550, Outward = 1620, ForeRadius = 335, SideRadius = 320 },
                new() { Forward = 0, Down = 930, Outward = 1780, ForeRadius = 150, SideRadius = 150 },
                new() { Forward = 0, Down = 985, Outward = 1920, ForeRadius = 150, SideRadius = 260 },
            },
        },
        build: new LegBuild(LimbPosture.Splayed)
        {
            MinGirth = 0.08,
            GreatestGirth = 0.20,
            CarryingShank = 0.085,
            SideGirth = 1,
            SwingDegrees = 20,
            FootForward = 0,
            FootOutward = 1.92,
            Heel = 0.16,
            Toe = 0.30,
            HalfWidth = 0.16,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 60), swingZ: (-60, 60), twist: (-40, 40)),
            knee: new(swingX: (-80, 80), swingZ: (-10, 10), twist: (-10, 10)),
            ankle: new(swingX: (-50, 50), swingZ: (-12, 12), twist: (-20, 20)),
            ball: new(swingX: (-40, 40), swingZ: (-10, 10), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.16,
            Peak = 0.5,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 10,
            SwingPitchDegrees = 14,
            StrikeDegrees = 0,
            Bend = 0,
            Immersion = 0.3f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.70, knee: -1.10, ankle: 0.60, ball: 0.50) { Twist = 0.56 },
            hanging: new LegPosture(hip: 0.60, knee: -0.85, ankle: 0.50, ball: 0.40) { Twist = 0.48 },
            reaching: new LegPosture(hip: -0.05, knee: -0.15, ankle: 0, ball: 0))
        {
            Foremost = new LegPosture(hip: -0.45, knee: -0.75, ankle: 0.60, ball: 0.50) { Twist = -0.62 },
            Midmost = new LegPosture(hip: 0.15, knee: -0.80, ankle: 0.60, ball: 0.50) { Twist = 0.62 },
            Hindmost = new LegPosture(hip: 0.65, knee: 0.45, ankle: 0.30, ball: 0.30) { Twist = 0.52 },
        })
    {
        // As it is carried in the air: the knee drawn up beside the body, the shank laid back below it.
        Trailing = new LegOutline(FootEnd.Point)
        {
            KneeRow = 3,
            AnkleRow = 6,
            BallRow = 7,
            Lateral = true,
            Jointed = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 1000 },
                new() { Forward = -30, Down = -40, Outward = 300, ForeRadius = 570, SideRadius = 700 },
                new() { Forward = -110, Down = -220, Outward = 660, ForeRadius = 940, SideRadius = 860 },
                new() { Forward = -200, Down = -320, Outward = 930, ForeRadius = 460, SideRadius = 450 },
                new() { Forward = -320, Down = -230, Outward = 1040, ForeRadius = 355, SideRadius = 345 },
                new() { Forward = -580, Down = 110, Outward = 1100, ForeRadius = 270, SideRadius = 265 },
                new() { Forward = -830, Down = 440, Outward = 1130, ForeRadius = 335, SideRadius = 320 },
                new() { Forward = -1050, Down = 680, Outward = 1150, ForeRadius = 150, SideRadius = 150 },
                new() { Forward = -1150, Down = 770, Outward = 1150, ForeRadius = 150, SideRadius = 260 },
            },
        },
    };
}
