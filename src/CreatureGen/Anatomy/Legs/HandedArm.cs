namespace CreatureGen.Anatomy.Legs;

/// <summary>An arm with a hand.</summary>
internal static class HandedArm
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Arm,
        outline: new LegOutline(FootEnd.Toes)
        {
            KneeRow = 2,
            AnkleRow = 4,
            BallRow = 5,
            ToeLength = 0.75,
            ToeSplay = 0.45,
            ToeRadius = 0.13,
            Handed = true,
            Carried = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 900 },
                new() { Forward = -10, Down = 120, Outward = 160, ForeRadius = 660, SideRadius = 580 },
                new() { Forward = -100, Down = 420, Outward = 260, ForeRadius = 440, SideRadius = 420 },
                new() { Forward = 20, Down = 570, Outward = 270, ForeRadius = 380, SideRadius = 360 },
                new() { Forward = 220, Down = 660, Outward = 200, ForeRadius = 270, SideRadius = 300 },
                new() { Forward = 300, Down = 690, Outward = 200, ForeRadius = 260, SideRadius = 400 },
            },
        },
        build: new LegBuild(LimbPosture.Under)
        {
            MinGirth = 0.10,
            GreatestGirth = 0.34,
            SideGirth = 0.9,
            SwingDegrees = LegBuild.HangingSwingDegrees,
            FootForward = 0.20,
            FootOutward = 0.20,
            Heel = 0.26,
            Toe = 0.40,
            HalfWidth = 0.40,
        },
        limits: new LegLimits(
            hip: new(swingX: (-170, 60), swingZ: (-110, 40), twist: (-80, 80)),
            knee: new(swingX: (-80, 70), swingZ: (-5, 5), twist: (-8, 8)),
            ankle: new(swingX: (-70, 80), swingZ: (-30, 25), twist: (-80, 80)),
            ball: new(swingX: (-60, 90), swingZ: (-20, 20), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.12,
            Peak = 0.45,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 40,
            SwingPitchDegrees = 50,
            StrikeDegrees = -8,
            Bend = -1,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.45, knee: -0.80, ankle: 0.20, ball: 0.30),
            hanging: new LegPosture(hip: 0.20, knee: -0.60, ankle: 0.15, ball: 0.25),
            reaching: new LegPosture(hip: -0.10, knee: -0.40, ankle: 0, ball: 0)));
}
