using System;
using CreatureGen.Anatomy;

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
        (double Least, double Most) thickness,
        int footRows,
        (double Length, double Splay, double Radius) toes,
        params short[] table)
    {
        Archetype = archetype;
        End = end;
        KneeRow = hinges.Knee;
        AnkleRow = hinges.Ankle;
        BallRow = hinges.Ball;
        LeastThickness = (float)thickness.Least;
        MostThickness = (float)thickness.Most;
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
    public float LeastThickness { get; }

    /// <summary>Most thickness relative to the length; 0 when there is no limit.</summary>
    public float MostThickness { get; }

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
        new(LimbArchetype.Column, FootEnd.Pad, hinges: (2, 4, 6), thickness: (0.25, 0.34), footRows: 3, toes: (0, 0, 0),
            0, 0, 0, 1000, 850, 30, 220, 50, 900, 700, 50, 450, 50, 680, 600, 0, 700, 30, 560, 540,
            0, 880, 30, 560, 560, 10, 960, 30, 640, 660, 10, 1000, 30, 660, 680),
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
    };

    /// <summary>The form of an archetype.</summary>
    public static LegForm Of(LimbArchetype archetype) =>
        Array.Find(all, f => f.Archetype == archetype) ?? throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there is no form for this archetype");
}
