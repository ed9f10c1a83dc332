using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Legs;

/// <summary>The shape of a leg or arm as data.</summary>
/// <param name="End">How it ends.</param>
internal sealed record LegOutline(FootEnd End)
{
    /// <summary>Most of a leg's radius that is only to make it stout, relative to half of its socket's length.</summary>
    private const float Balloon = 1.3f;

    /// <summary>Most of it relative to that length otherwise.</summary>
    private const float Widest = 1.12f;

    /// <summary>The same of a leg in joints, which is drawn in between its socket and its thigh: as thin as the small socket, the legs of a spider are wires.</summary>
    private const float WidestJointed = 1.7f;

    /// <summary>From the socket on.</summary>
    public LegSection[] Rows { get; init; } = Array.Empty<LegSection>();

    public int KneeRow { get; init; }

    public int AnkleRow { get; init; }

    public int BallRow { get; init; }

    /// <summary>Least thickness relative to the length; 0 when there is no limit.</summary>
    public double MinThickness { get; init; }

    /// <summary>Most thickness relative to the length; 0 when there is no limit.</summary>
    public double MaxThickness { get; init; }

    /// <summary>Number of last rows whose radii grow with the size of the foot.</summary>
    public int FootRows { get; init; }

    /// <summary>Length of the toes in units of thickness times foot size.</summary>
    public double ToeLength { get; init; }

    /// <summary>Angle between the outer toes and straight ahead, radians.</summary>
    public double ToeSplay { get; init; }

    /// <summary>Radius of a toe's tip in units of thickness times foot size.</summary>
    public double ToeRadius { get; init; }

    /// <summary>Whether it reaches out to the side and turns with its azimuth, instead of standing under the body.</summary>
    public bool Lateral { get; init; }

    /// <summary>Whether it arches out of the body's side on a socket of few cells and ends in a point.</summary>
    public bool Jointed { get; init; }

    /// <summary>Whether it stands on long spread toes under the body.</summary>
    public bool LongToed { get; init; }

    /// <summary>Whether it folds at the side of the body, its foot far out.</summary>
    public bool Crouched { get; init; }

    /// <summary>Whether it stands on the whole of its sole.</summary>
    public bool FlatSoled { get; init; }

    /// <summary>Whether it ends in a hand.</summary>
    public bool Handed { get; init; }

    /// <summary>Whether it is carried close to the body instead of being stood on: arms, and the fore legs of a mantis.</summary>
    public bool Carried { get; init; }

    /// <summary>Whether it arches out to the side over a raised knee: the legs of insects and spiders.</summary>
    public bool Arched => Lateral && Jointed;

    /// <summary>Whether it reaches out to the side on a foot that points ahead like any other: the legs of newts and lizards.</summary>
    public bool Sprawling => Lateral && !Jointed;

    /// <summary>Mean radius from the knee to the ankle to the sides, in units of its thickness.</summary>
    public double ShankRadius()
    {
        double sum = 0;
        for (int row = KneeRow; row <= AnkleRow; row++)
        {
            sum += Rows[row].SideRadius / 1000.0;
        }

        return sum / (AnkleRow - KneeRow + 1);
    }

    /// <summary>Radius of its thigh as it is grown, metres.</summary>
    /// <param name="wanted">What it is to be.</param>
    /// <param name="half">Half the length of its socket.</param>
    /// <param name="height">Height of its root above the ground, or its length.</param>
    public float Thickness(float wanted, float half, float height)
    {
        float thickness = Math.Min(wanted, half * (Jointed ? WidestJointed : Widest));
        if (MinThickness > 0)
        {
            // A tall leg of a slim body stays as slim as where it grows from, or it would hang there like a balloon.
            float min = Math.Min((float)MinThickness * height, Math.Max(thickness, Balloon * half));
            thickness = Scalar.Clamp(thickness, min, (float)MaxThickness * height);
        }

        return thickness;
    }
}
