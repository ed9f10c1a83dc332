namespace CreatureGen.Anatomy.Legs;

/// <summary>The fore leg of a frog.</summary>
internal static class FrogForeLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.FrogFore,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 5,
            FootRows = 2,
            ToeLength = 0.9,
            ToeSplay = 0.55,
            ToeRadius = 0.13,
            Crouched = true,
            FlatSoled = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 800 },
                new() { Forward = 0, Down = 50, Outward = 220, ForeRadius = 700, SideRadius = 600 },
                new() { Forward = -60, Down = 250, Outward = 420, ForeRadius = 500, SideRadius = 450 },
                new() { Forward = -40, Down = 500, Outward = 500, ForeRadius = 380, SideRadius = 360 },
                new() { Forward = 20, Down = 800, Outward = 460, ForeRadius = 320, SideRadius = 320 },
                new() { Forward = 80, Down = 930, Outward = 460, ForeRadius = 280, SideRadius = 400 },
                new() { Forward = 220, Down = 950, Outward = 480, ForeRadius = 260, SideRadius = 460 },
            },
        },
        build: new LegBuild(LimbPosture.Splayed)
        {
            MinGirth = 0.12,
            GreatestGirth = 0.45,
            SideGirth = 0.8,
            SwingDegrees = 25,
            FootForward = 0.22,
            FootOutward = 0.48,
            Heel = 0.26,
            Toe = 0.90,
            HalfWidth = 0.55,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 70), swingZ: (-60, 60), twist: (-90, 90)),
            knee: new(swingX: (-130, 30), swingZ: (-15, 15), twist: (-20, 20)),
            ankle: new(swingX: (-70, 70), swingZ: (-32, 32), twist: (-32, 32)),
            ball: new(swingX: (-70, 60), swingZ: (-25, 25), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.14,
            Peak = 0.45,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 30,
            SwingPitchDegrees = 36,
            StrikeDegrees = -8,
            Bend = -1,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.30, knee: -0.30, ankle: 0.10, ball: 0.10),
            hanging: new LegPosture(hip: 0.15, knee: -0.40, ankle: 0.15, ball: 0.15),
            reaching: new LegPosture(hip: -0.20, knee: 0.10, ankle: 0, ball: 0)));
}
