namespace CreatureGen.Anatomy.Legs;

/// <summary>The hind leg of a grasshopper, its knee high above the back.</summary>
internal static class JumperLeg
{
    public static LegKind Kind { get; } = new(
        LimbArchetype.Jumper,
        outline: new LegOutline(FootEnd.Point)
        {
            KneeRow = 4,
            AnkleRow = 7,
            BallRow = 8,
            Jointed = true,
            Rows = new LegSection[]
            {
                new() { Forward = 0, Down = 0, Outward = 0, ForeRadius = 1000, SideRadius = 1000 },
                new() { Forward = -120, Down = -250, Outward = 300, ForeRadius = 1250, SideRadius = 1100 },
                new() { Forward = -420, Down = -850, Outward = 460, ForeRadius = 1020, SideRadius = 880 },
                new() { Forward = -720, Down = -1220, Outward = 540, ForeRadius = 470, SideRadius = 450 },
                new() { Forward = -860, Down = -1000, Outward = 560, ForeRadius = 440, SideRadius = 430 },
                new() { Forward = -980, Down = -300, Outward = 620, ForeRadius = 265, SideRadius = 260 },
                new() { Forward = -1100, Down = 500, Outward = 700, ForeRadius = 290, SideRadius = 280 },
                new() { Forward = -1140, Down = 930, Outward = 740, ForeRadius = 150, SideRadius = 150 },
                new() { Forward = -980, Down = 980, Outward = 760, ForeRadius = 180, SideRadius = 180 },
            },
        },
        build: new LegBuild(LimbPosture.Splayed)
        {
            MinGirth = 0.06,
            GreatestGirth = 0.20,
            SideGirth = 1,
            SwingDegrees = 20,
            FootForward = -0.98,
            FootOutward = 0.76,
            Heel = 0.16,
            Toe = 0.30,
            HalfWidth = 0.16,
        },
        limits: new LegLimits(
            hip: new(swingX: (-60, 60), swingZ: (-60, 60), twist: (-40, 40)),
            knee: new(swingX: (-120, 30), swingZ: (-10, 10), twist: (-10, 10)),
            ankle: new(swingX: (-50, 50), swingZ: (-12, 12), twist: (-20, 20)),
            ball: new(swingX: (-40, 40), swingZ: (-10, 10), twist: (-10, 10))),
        step: new LegStep(LegLinkage.Foot)
        {
            Lift = 0.14,
            Peak = 0.5,
            FoldDegrees = 0,
            UnfoldDegrees = 0,
            ToeOffDegrees = 10,
            SwingPitchDegrees = 14,
            StrikeDegrees = 0,
            Bend = -1,
            Leaps = true,
            Immersion = 0.3f,
        },
        flight: new LegFlight(
            tucked: new LegPosture(hip: -0.85, knee: -0.60, ankle: 0.30, ball: 0.30),
            hanging: new LegPosture(hip: -0.70, knee: -0.40, ankle: 0.30, ball: 0.30),
            reaching: new LegPosture(hip: -0.20, knee: 0.10, ankle: 0, ball: 0)));
}
