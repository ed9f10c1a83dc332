using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The way of the left one of two necks: where each ring in front of the fork comes to lie, how it is turned, and how large and narrow it is.</summary>
/// <remarks>
/// Rings are turned about their own dorsal axis, so that a neck which stands upright leans out and one which lies level turns aside. A neck goes out first and comes back towards straight
/// ahead before the head, which stays as it was built: from the nape on all is moved as one.
/// </remarks>
internal sealed class ForkCourse
{
    /// <summary>The last ring that moves as one with the head.</summary>
    public const int Rigid = StationRing.Nape;

    // Parts of a neck over which it leans out, and from which on it comes back to what part of that.
    private const double Out = 0.4;
    private const double Back = 0.45;
    private const double Kept = 0.45;

    /// <summary>Part of a neck over which it comes to its own size.</summary>
    private const double Sizing = 0.7;

    /// <summary>Least of its width that is left to a neck beside the other one.</summary>
    private const double Narrowest = 0.45;

    /// <summary>Room between both necks in half widths of the body at the fork.</summary>
    private const double Gap = 0.05;

    private readonly BodyShape shape;
    private readonly Vector3[] centres;
    private readonly Quaternion[] turns;
    private readonly float[] sizes;
    private readonly float[] widths;

    /// <summary>Lays the way.</summary>
    public ForkCourse(BodyShape shape, ForkBlueprint fork)
    {
        this.shape = shape;
        Ring = fork.Ring;
        centres = new Vector3[Ring + 1];
        turns = new Quaternion[Ring + 1];
        sizes = new float[Ring + 1];
        widths = new float[Ring + 1];
        double length = shape.Arc[Ring] - shape.Arc[Rigid];
        double root = shape.Width[Ring];
        centres[Ring] = shape.Centre(Ring) + new Vector3((float)(root / 2), 0f, 0f);
        (turns[Ring], sizes[Ring], widths[Ring]) = (Quaternion.Identity, 1f, 0.5f);
        for (int i = Ring - 1; i >= Rigid; i--)
        {
            double along = (shape.Arc[Ring] - shape.Arc[i]) / length;
            double before = (shape.Arc[Ring] - shape.Arc[i + 1]) / length;
            double lean = LeanAt(fork.Spread, (along + before) / 2);
            sizes[i] = (float)Scalar.Lerp(1, fork.Size, Scalar.Smooth(along / Sizing));
            Vector3 step = (shape.Centre(i) - shape.Centre(i + 1)) * ((float)fork.Length * (sizes[i] + sizes[i + 1]) / 2f);
            PortableMath.SinCos(lean, out double sine, out double cosine);
            centres[i] = centres[i + 1] + (step * (float)cosine) + new Vector3(Vec.Length(step) * (float)sine, 0f, 0f);
            turns[i] = Rotation.FromAxisAngle(shape.Up(i), LeanAt(fork.Spread, along));
            double room = centres[i].X - (Gap * root);
            widths[i] = (float)Scalar.Clamp(room / Math.Max(shape.Width[i] * sizes[i] * PortableMath.Cos(LeanAt(fork.Spread, along)), 1e-6), Narrowest, 1);
        }

        widths[Rigid] = 1f;
        SmoothWidths();
    }

    /// <summary>The ring at which the body forks.</summary>
    public int Ring { get; }

    /// <summary>Half of the way between both heads where they sit on their necks, metres.</summary>
    public float Apart => centres[Rigid].X;

    /// <summary>How what lies at a ring is turned.</summary>
    public Quaternion TurnAt(double ring) => Between(ring, out int i, out float t) ? Rotation.Nlerp(turns[i], turns[i + 1], t) : turns[i];

    /// <summary>How large what lies at a ring is.</summary>
    public float SizeAt(double ring) => Between(ring, out int i, out float t) ? sizes[i] + ((sizes[i + 1] - sizes[i]) * t) : sizes[i];

    /// <summary>Where a point goes that belongs to the section at a ring.</summary>
    public Vector3 Move(double ring, Vector3 point)
    {
        bool between = Between(ring, out int i, out float t);
        Vector3 first = MoveWith(i, point);
        return between ? Vec.Lerp(first, MoveWith(i + 1, point), t) : first;
    }

    private static double LeanAt(double spread, double along) => spread * Scalar.Smooth(along / Out) * Scalar.Lerp(1, Kept, Scalar.Smooth((along - Back) / (1 - Back)));

    /// <summary>Takes corners off the flanks, where necks come free of each other: on the side of the narrower.</summary>
    private void SmoothWidths()
    {
        float before = widths[Rigid];
        for (int i = Rigid + 1; i < Ring; i++)
        {
            float here = widths[i];
            widths[i] = Math.Min(here, (before + (2f * here) + widths[i + 1]) / 4f);
            before = here;
        }
    }

    private bool Between(double ring, out int i, out float t)
    {
        ring = Scalar.Clamp(ring, Rigid, Ring);
        i = (int)ring;
        t = (float)(ring - i);
        return t > 0f;
    }

    private Vector3 MoveWith(int ring, Vector3 point)
    {
        Vector3 d = point - shape.Centre(ring);
        d.X *= widths[ring];
        return centres[ring] + Rotation.Rotate(turns[ring], d * sizes[ring]);
    }
}
