using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Limbs;

/// <summary>How a limb ends.</summary>
internal enum FootEnd
{
    /// <summary>A flat end split into toes or fingers.</summary>
    Toes,

    /// <summary>A hoof.</summary>
    Hoof,

    /// <summary>A round sole with nails.</summary>
    Pad,

    /// <summary>A narrow tip.</summary>
    Point,
}

/// <summary>
/// The shape of a leg or arm as data: rows of forward, down and outward in units of its length, and fore-aft and lateral radius in units of its thickness. Row 0 is the socket.
/// </summary>
internal sealed class LegForm
{
    /// <summary>Takes a table of forward, down, outward, fore-aft radius and lateral radius, in thousandths, row by row.</summary>
    public LegForm(
        LimbArchetype archetype,
        FootEnd end,
        (int Knee, int Ankle, int Ball) hinges,
        (double Min, double Max) thickness,
        int footRows,
        (double Length, double Splay, double Radius) toes,
        params short[] table)
    {
        Archetype = archetype;
        End = end;
        KneeRow = hinges.Knee;
        AnkleRow = hinges.Ankle;
        BallRow = hinges.Ball;
        MinThickness = (float)thickness.Min;
        MaxThickness = (float)thickness.Max;
        FootRows = footRows;
        ToeLength = (float)toes.Length;
        ToeSplay = (float)toes.Splay;
        ToeRadius = (float)toes.Radius;
        Rows = table.Length / 5;
        Forward = Column(table, 0);
        Down = Column(table, 1);
        Outward = Column(table, 2);
        ForeRadius = Column(table, 3);
        SideRadius = Column(table, 4);
    }

    public LimbArchetype Archetype { get; }

    public FootEnd End { get; }

    public int Rows { get; }

    public int KneeRow { get; }

    public int AnkleRow { get; }

    public int BallRow { get; }

    /// <summary>Least thickness relative to the length; 0 when there is no limit.</summary>
    public float MinThickness { get; }

    /// <summary>Most thickness relative to the length; 0 when there is no limit.</summary>
    public float MaxThickness { get; }

    /// <summary>Whether it reaches out to the side and turns with its azimuth, instead of standing under the body.</summary>
    public bool Lateral => Archetype is LimbArchetype.Insect or LimbArchetype.Sprawl;

    /// <summary>Whether it arches out of the body's side on a socket of few cells and ends in a point.</summary>
    public bool Jointed => Archetype is LimbArchetype.Insect or LimbArchetype.Raptorial or LimbArchetype.Jumper;

    /// <summary>Whether it stands on long spread toes under the body.</summary>
    public bool LongToed => Archetype is LimbArchetype.Theropod or LimbArchetype.Bird;

    /// <summary>Whether it folds at the side of the body, its foot far out.</summary>
    public bool Crouched => Archetype is LimbArchetype.FrogHind or LimbArchetype.FrogFore;

    /// <summary>Number of last rows whose radii grow with the size of the foot.</summary>
    public int FootRows { get; }

    /// <summary>Length of the toes in units of thickness times foot size.</summary>
    public float ToeLength { get; }

    /// <summary>Angle between the outer toes and straight ahead, radians.</summary>
    public float ToeSplay { get; }

    /// <summary>Radius of a toe's tip in units of thickness times foot size.</summary>
    public float ToeRadius { get; }

    public float[] Forward { get; }

    public float[] Down { get; }

    public float[] Outward { get; }

    public float[] ForeRadius { get; }

    public float[] SideRadius { get; }

    private static float[] Column(short[] table, int column)
    {
        float[] values = new float[table.Length / 5];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = table[(5 * i) + column] / 1000f;
        }

        return values;
    }
}

/// <summary>The forms of all archetypes.</summary>
internal static class LegForms
{
    private static readonly LegForm[] all =
    {
        new(LimbArchetype.DigitigradeHind, FootEnd.Toes, hinges: (2, 4, 6), thickness: (0.19, 0.34), footRows: 2, toes: (0.4, 0.22, 0.19),
            0, 0, 0, 1000, 800, 60, 170, 50, 1000, 660, 120, 370, 50, 600, 470, -20, 540, 30, 400, 350,
            -170, 700, 20, 250, 220, -130, 860, 20, 210, 240, -70, 945, 20, 270, 340, 30, 965, 20, 260, 420),
        new(LimbArchetype.DigitigradeFore, FootEnd.Toes, hinges: (2, 4, 5), thickness: (0.185, 0.34), footRows: 2, toes: (0.4, 0.22, 0.19),
            0, 0, 0, 1000, 800, 20, 180, 40, 720, 520, -70, 400, 30, 440, 380, -30, 620, 20, 290, 280,
            0, 820, 10, 240, 260, 30, 945, 10, 270, 350, 110, 965, 10, 260, 420),
        new(LimbArchetype.UnguligradeHind, FootEnd.Hoof, hinges: (2, 4, 6), thickness: (0.165, 0.34), footRows: 3, toes: (0, 0, 0),
            0, 0, 0, 1000, 800, 50, 170, 50, 920, 600, 90, 340, 40, 540, 420, -30, 480, 20, 350, 290,
            -130, 610, 10, 240, 200, -100, 760, 10, 170, 170, -80, 875, 10, 210, 210, -40, 930, 10, 200, 210,
            -15, 965, 10, 270, 280, 0, 1000, 10, 310, 310),
        new(LimbArchetype.UnguligradeFore, FootEnd.Hoof, hinges: (2, 4, 6), thickness: (0.165, 0.34), footRows: 3, toes: (0, 0, 0),
            0, 0, 0, 1000, 800, 20, 180, 40, 720, 500, -40, 380, 30, 420, 350, -10, 550, 20, 270, 250,
            20, 660, 10, 240, 220, 10, 780, 10, 160, 165, 10, 875, 10, 200, 200, 40, 930, 10, 200, 210,
            55, 965, 10, 270, 280, 70, 1000, 10, 310, 310),
        new(LimbArchetype.PlantigradeHind, FootEnd.Toes, hinges: (2, 4, 6), thickness: (0.24, 0.31), footRows: 2, toes: (0.38, 0.22, 0.2),
            0, 0, 0, 1000, 850, 60, 200, 60, 950, 700, 110, 430, 60, 660, 560, 20, 660, 40, 460, 450,
            -50, 800, 30, 360, 400, 60, 915, 30, 290, 480, 200, 955, 30, 270, 530),
        new(LimbArchetype.PlantigradeFore, FootEnd.Toes, hinges: (2, 4, 6), thickness: (0.24, 0.31), footRows: 2, toes: (0.38, 0.22, 0.2),
            0, 0, 0, 1000, 850, 20, 220, 50, 800, 620, -70, 460, 40, 580, 500, -20, 680, 30, 440, 440,
            -10, 800, 20, 340, 400, 80, 915, 20, 290, 480, 200, 955, 20, 270, 530),
        new(LimbArchetype.Column, FootEnd.Pad, hinges: (2, 4, 6), thickness: (0.18, 0.34), footRows: 3, toes: (0, 0, 0),
            0, 0, 0, 1000, 850, 40, 220, 50, 920, 700, 75, 450, 50, 680, 590, 10, 660, 35, 520, 490,
            -10, 830, 30, 470, 470, 15, 945, 30, 555, 560, 25, 1000, 30, 610, 620),
        new(LimbArchetype.Sprawl, FootEnd.Toes, hinges: (2, 5, 7), thickness: (0, 0), footRows: 2, toes: (0.75, 0.75, 0.13),
            0, 0, 0, 1000, 800, 0, -20, 400, 780, 660, 20, 30, 800, 560, 500, 0, 300, 1000, 420, 400,
            0, 620, 1050, 340, 330, 60, 860, 1080, 340, 380, 200, 930, 1120, 300, 460, 320, 940, 1150, 280, 500),
        new(LimbArchetype.Theropod, FootEnd.Toes, hinges: (2, 4, 6), thickness: (0.145, 0.34), footRows: 2, toes: (1.15, 0.52, 0.15),
            0, 0, 0, 1000, 800, 90, 160, 60, 1020, 680, 220, 360, 60, 660, 480, 50, 550, 40, 420, 350,
            -130, 740, 30, 240, 220, -60, 890, 30, 200, 210, -10, 955, 30, 220, 280, 60, 968, 30, 210, 340),
        new(LimbArchetype.Insect, FootEnd.Point, hinges: (3, 6, 7), thickness: (0, 0), footRows: 0, toes: (0, 0, 0),
            0, 0, 0, 1000, 1000, 0, -60, 300, 720, 720, 0, -340, 720, 620, 620, 0, -480, 1050, 440, 440,
            0, -380, 1220, 380, 380, 0, 50, 1420, 400, 400, 0, 550, 1620, 260, 260, 0, 930, 1780, 180, 180,
            0, 985, 1920, 160, 160),
        new(LimbArchetype.Arm, FootEnd.Toes, hinges: (2, 4, 5), thickness: (0, 0), footRows: 0, toes: (0.75, 0.45, 0.13),
            0, 0, 0, 1000, 900, -10, 120, 160, 660, 580, -100, 420, 260, 440, 420, 20, 570, 270, 380, 360,
            220, 660, 200, 270, 300, 300, 690, 200, 260, 400),
        new(LimbArchetype.Bird, FootEnd.Toes, hinges: (3, 5, 7), thickness: (0.05, 0.34), footRows: 2, toes: (1.25, 0.5, 0.15),
            0, 0, 0, 1000, 800, 50, 140, 70, 960, 660, 130, 320, 70, 640, 480, 80, 480, 55, 400, 340,
            -45, 660, 30, 220, 210, -95, 760, 22, 190, 190, -40, 900, 18, 170, 180, 0, 960, 18, 190, 250, 60, 970, 18, 180, 300),
        new(LimbArchetype.Raptorial, FootEnd.Point, hinges: (3, 5, 8), thickness: (0, 0), footRows: 0, toes: (0, 0, 0),
            0, 0, 0, 1000, 1000, 100, 220, 100, 850, 800, 240, 520, 180, 750, 700, 420, 500, 220, 950, 800,
            620, 100, 260, 1150, 800, 740, -240, 280, 600, 580, 840, -340, 280, 500, 450, 960, -160, 280, 420, 400, 1000, 180, 260, 300, 300, 940, 460, 240, 100, 100),
        new(LimbArchetype.Jumper, FootEnd.Point, hinges: (4, 7, 8), thickness: (0, 0), footRows: 0, toes: (0, 0, 0),
            0, 0, 0, 1000, 1000, -120, -250, 300, 1250, 1100, -420, -850, 460, 1150, 1000, -720, -1220, 540, 620, 600,
            -860, -1000, 560, 460, 460, -980, -300, 620, 340, 340, -1100, 500, 700, 260, 260, -1140, 930, 740, 200, 200, -980, 980, 760, 180, 180),
        new(LimbArchetype.FrogHind, FootEnd.Toes, hinges: (3, 5, 7), thickness: (0, 0), footRows: 2, toes: (0.9, 0.55, 0.13),
            0, 0, 0, 1000, 800, 220, -100, 340, 950, 700, 500, -220, 620, 600, 500, 580, -60, 740, 420, 380,
            440, 340, 860, 380, 330, 260, 720, 980, 270, 260, 220, 880, 1060, 220, 260, 360, 940, 1200, 190, 360, 560, 950, 1360, 180, 420),
        new(LimbArchetype.FrogFore, FootEnd.Toes, hinges: (2, 4, 5), thickness: (0, 0), footRows: 2, toes: (0.9, 0.55, 0.13),
            0, 0, 0, 1000, 800, 0, 50, 220, 700, 600, -60, 250, 420, 500, 450, -40, 500, 500, 380, 360,
            20, 800, 460, 320, 320, 80, 930, 460, 280, 400, 220, 950, 480, 260, 460),
    };

    /// <summary>Legs that sprawl on land, as they are carried in the water: laid back along the flank, the elbow out, the foot level like an oar between two strokes.</summary>
    private static readonly LegForm trailing = new(LimbArchetype.Sprawl, FootEnd.Toes, hinges: (2, 5, 7), thickness: (0, 0), footRows: 2, toes: (0.75, 0.75, 0.13),
        0, 0, 0, 1000, 800, -90, 40, 330, 780, 660, -300, 110, 600, 560, 500, -540, 170, 720, 420, 400,
        -800, 220, 790, 340, 330, -1000, 260, 810, 300, 380, -1140, 280, 830, 250, 460, -1260, 300, 850, 220, 500);

    /// <summary>The form of a leg: legs that sprawl trail where they do not stand.</summary>
    public static LegForm Of(LegBlueprint leg) => leg.Archetype == LimbArchetype.Sprawl && leg.Stance == LegStance.Hanging ? trailing : Of(leg.Archetype);

    /// <summary>The form of an archetype on the ground.</summary>
    public static LegForm Of(LimbArchetype archetype) =>
        Array.Find(all, f => f.Archetype == archetype) ?? throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there is no form for this archetype");
}
