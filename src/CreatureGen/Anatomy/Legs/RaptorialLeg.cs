namespace CreatureGen.Anatomy.Legs;

/// <summary>The folded grasping leg of a mantis.</summary>
internal static class RaptorialLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Raptorial,
        outline: new LegOutline(FootEnd.Point)
        {
            KneeRow = 3,
            AnkleRow = 5,
            BallRow = 8,
            Jointed = true,
            Carried = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 1000 },
                new() { Forward = 100, Down = 220, Outward = 100, ForeRadius = 640, SideRadius = 580 },
                new() { Forward = 240, Down = 520, Outward = 180, ForeRadius = 470, SideRadius = 430 },
                new() { Forward = 420, Down = 500, Outward = 220, ForeRadius = 700, SideRadius = 520 },
                new() { Forward = 620, Down = 100, Outward = 260, ForeRadius = 960, SideRadius = 560 },
                new() { Forward = 740, Down = -240, Outward = 280, ForeRadius = 430, SideRadius = 380 },
                new() { Forward = 840, Down = -340, Outward = 280, ForeRadius = 360, SideRadius = 300 },
                new() { Forward = 960, Down = -160, Outward = 280, ForeRadius = 300, SideRadius = 240 },
                new() { Forward = 1000, Down = 180, Outward = 260, ForeRadius = 190, SideRadius = 160 },
                new() { Forward = 940, Down = 460, Outward = 240, ForeRadius = 60, SideRadius = 60 },
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
            hip: new(swingX: (-100, 60), swingZ: (-60, 60), twist: (-40, 40)),
            knee: new(swingX: (-60, 130), swingZ: (-10, 10), twist: (-10, 10)),
            ankle: new(swingX: (-130, 60), swingZ: (-12, 12), twist: (-16, 16)),
            ball: new(swingX: (-40, 40), swingZ: (-10, 10), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.12,
            Peak = 0.45,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 10,
            SwingPitchDegrees = 14,
            StrikeDegrees = 0,
            Bend = -1,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: 0.30, knee: -0.30, ankle: 0.10, ball: 0.10),
            hanging: new LegPosture(hip: 0.15, knee: -0.40, ankle: 0.15, ball: 0.15),
            reaching: new LegPosture(hip: -0.20, knee: 0.10, ankle: 0, ball: 0)));
}
