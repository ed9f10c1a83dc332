namespace CreatureGen.Anatomy.Legs;

/// <summary>A leg out to the side, as newts and lizards have it.</summary>
internal static class SprawlLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Sprawl,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 5,
            BallRow = 7,
            FootRows = 2,
            ToeLength = 0.75,
            ToeSplay = 0.75,
            ToeRadius = 0.13,
            Lateral = true,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 0, Down = -20, Outward = 400, ForeRadius = 800, SideRadius = 690 },
                new() { Forward = 20, Down = 30, Outward = 800, ForeRadius = 530, SideRadius = 450, ForeOffset = -70 },
                new() { Forward = 0, Down = 300, Outward = 1000, ForeRadius = 530, SideRadius = 440, ForeOffset = 40 },
                new() { Forward = 0, Down = 620, Outward = 1050, ForeRadius = 340, SideRadius = 310 },
                new() { Forward = 60, Down = 860, Outward = 1080, ForeRadius = 265, SideRadius = 290 },
                new() { Forward = 200, Down = 930, Outward = 1120, ForeRadius = 300, SideRadius = 460 },
                new() { Forward = 320, Down = 940, Outward = 1150, ForeRadius = 280, SideRadius = 500 },
            },
        },
        build: new LegBuild(LimbPosture.Splayed)
        {
            MinGirth = 0.20,
            GreatestGirth = 0.45,
            SideGirth = 0.8,
            SwingDegrees = 30,
            FootForward = 0.32,
            FootOutward = 1.12,
            Heel = 0.28,
            Toe = 0.75,
            HalfWidth = 0.50,
        },
        limits: new LegLimits(
            hip: new(swingX: (-45, 60), swingZ: (-60, 70), twist: (-80, 80)),
            knee: new(swingX: (-60, 80), swingZ: (-15, 15), twist: (-20, 20)),
            ankle: new(swingX: (-60, 70), swingZ: (-45, 45), twist: (-45, 45)),
            ball: new(swingX: (-70, 60), swingZ: (-25, 25), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.14,
            Peak = 0.45,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 30,
            SwingPitchDegrees = 36,
            StrikeDegrees = -3,
            Bend = 0,
            Undulation = 0.9f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.80, knee: -0.35, ankle: 0.40, ball: 0.40),
            hanging: new LegPosture(hip: 0.35, knee: -0.45, ankle: 0.30, ball: 0.30),
            reaching: new LegPosture(hip: -0.10, knee: -0.15, ankle: 0.05, ball: 0))
        {
            Foremost = new LegPosture(hip: -0.10, knee: -0.55, ankle: 0.40, ball: 0.40),
            Midmost = new LegPosture(hip: 0.40, knee: -0.35, ankle: 0.40, ball: 0.40),
            Hindmost = new LegPosture(hip: 0.80, knee: -0.10, ankle: 0.40, ball: 0.40),
        })
    {
        // As it is carried in the water: out to the side and down from the elbow, a thin wrist before a foot that is spread and turned down like an oar between two strokes.
        Trailing = new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 5,
            BallRow = 7,
            FootRows = 2,
            ToeLength = 0.75,
            ToeSplay = 0.85,
            ToeRadius = 0.13,
            Lateral = true,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = -45, Down = 60, Outward = 335, ForeRadius = 780, SideRadius = 640 },
                new() { Forward = -140, Down = 210, Outward = 620, ForeRadius = 530, SideRadius = 445 },
                new() { Forward = -300, Down = 420, Outward = 735, ForeRadius = 420, SideRadius = 365 },
                new() { Forward = -480, Down = 610, Outward = 790, ForeRadius = 335, SideRadius = 305 },
                new() { Forward = -635, Down = 790, Outward = 820, ForeRadius = 270, SideRadius = 310 },
                new() { Forward = -745, Down = 930, Outward = 860, ForeRadius = 235, SideRadius = 450 },
                new() { Forward = -835, Down = 1060, Outward = 905, ForeRadius = 200, SideRadius = 490 },
            },
        },
    };
}
