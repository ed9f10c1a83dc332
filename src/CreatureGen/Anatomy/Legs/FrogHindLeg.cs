namespace CreatureGen.Anatomy.Legs;

/// <summary>The folded hind leg of a frog.</summary>
internal static class FrogHindLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.FrogHind,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 3,
            AnkleRow = 5,
            BallRow = 7,
            FootRows = 2,
            ToeLength = 0.9,
            ToeSplay = 0.55,
            ToeRadius = 0.13,
            Crouched = true,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 220, Down = -100, Outward = 340, ForeRadius = 950, SideRadius = 700 },
                new() { Forward = 500, Down = -220, Outward = 620, ForeRadius = 600, SideRadius = 500 },
                new() { Forward = 580, Down = -60, Outward = 740, ForeRadius = 420, SideRadius = 380 },
                new() { Forward = 440, Down = 340, Outward = 860, ForeRadius = 380, SideRadius = 330 },
                new() { Forward = 260, Down = 720, Outward = 980, ForeRadius = 270, SideRadius = 260 },
                new() { Forward = 220, Down = 880, Outward = 1060, ForeRadius = 220, SideRadius = 260 },
                new() { Forward = 360, Down = 940, Outward = 1200, ForeRadius = 190, SideRadius = 360 },
                new() { Forward = 560, Down = 950, Outward = 1360, ForeRadius = 180, SideRadius = 420 },
            },
        },
        build: new LegBuild(LimbPosture.Splayed)
        {
            MinGirth = 0.12,
            GreatestGirth = 0.45,
            SideGirth = 0.8,
            SwingDegrees = 25,
            FootForward = 0.56,
            FootOutward = 1.36,
            Heel = 0.24,
            Toe = 0.90,
            HalfWidth = 0.55,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 80), swingZ: (-60, 70), twist: (-60, 60)),
            knee: new(swingX: (-30, 130), swingZ: (-15, 15), twist: (-20, 20)),
            ankle: new(swingX: (-130, 60), swingZ: (-28, 28), twist: (-28, 28)),
            ball: new(swingX: (-70, 60), swingZ: (-25, 25), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.14,
            Peak = 0.42,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 30,
            SwingPitchDegrees = 36,
            StrikeDegrees = -8,
            Bend = 1,
            Leaps = true,
            KneesAhead = true,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.30, knee: -0.30, ankle: 0.10, ball: 0.10),
            hanging: new LegPosture(hip: 0.15, knee: -0.40, ankle: 0.15, ball: 0.15),
            reaching: new LegPosture(hip: -0.20, knee: 0.10, ankle: 0, ball: 0)));
}
