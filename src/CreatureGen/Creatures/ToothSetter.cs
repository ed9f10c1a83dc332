using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Limbs;
using CreatureGen.Maths;

namespace CreatureGen.Creatures;

/// <summary>Sets teeth and gums along the lips of a mouth.</summary>
internal sealed class ToothSetter
{
    /// <summary>Length of the longest tooth, in those that the blueprint tells of the muzzle's half width.</summary>
    private const double Length = 1.4;

    /// <summary>How far the middle of a gum is behind the lip, in its heights.</summary>
    private const float GumInset = 1.15f;

    // How far behind the lip teeth stand in a mouth that is shut, so that the other lip covers them, and in those that are bared, in lengths.
    private const float Covered = 0.8f;
    private const float Bared = -0.06f;

    // Length of the longest tooth that a mouth has room for: that of a shut one in depths of the jaw at its front, where the lips hide teeth and where teeth are bared, and what an open one adds, in its gape.
    private const float InJaw = 0.3f;
    private const float OnJaw = 0.45f;
    private const float InGape = 0.5f;

    /// <summary>How much farther in the lower teeth stand, in lengths: the upper ones lap over them.</summary>
    private const float Within = 0.1f;

    /// <summary>Angle of the jaw from which on teeth are not behind the other lip, radians.</summary>
    private const double Open = 0.08;

    private static readonly Vector3 gumColour = new(0.27f, 0.075f, 0.08f);

    private readonly Dentition dentition;
    private readonly LipLine upper;
    private readonly LipLine lower;
    private readonly float length;
    private readonly float hidden;

    /// <summary>Measures the lips of a creature whose mouth opens and has teeth.</summary>
    public ToothSetter(CreatureBlueprint blueprint, GrownSurface grown, Vector3[] normals, Dentition dentition)
    {
        this.dentition = dentition;
        MouthBlueprint mouth = blueprint.Head.Mouth;
        BodyShape shape = grown.Skin.Shape;
        hidden = 1f - Scalar.Smooth((float)(mouth.Opening / Open));
        float longest = (float)(mouth.Teeth * shape.Width[StationRing.MuzzleMiddle] * Length);
        float jaw = (float)Math.Min(shape.Bottom[StationRing.Nose], shape.Bottom[StationRing.MuzzleFront]);
        float gape = Vec.Distance(MiddleOf(grown.Mouth.UpperLip), MiddleOf(grown.Mouth.LowerLip));
        length = Math.Min(longest, ((dentition.Bared ? OnJaw : InJaw) * jaw) + (InGape * gape));
        Vector3 up = shape.Up(StationRing.MuzzleFront);
        upper = Line(grown.Mouth.UpperLip, Vector3.Zero - up);
        lower = Line(grown.Mouth.LowerLip, Vec.Rotate(up, Vector3.UnitX, MouthSlit.AngleOf(mouth)));

        Vector3 MiddleOf(int[] lip) => grown.Surface.Positions[lip[lip.Length / 2]];

        LipLine Line(int[] lip, Vector3 direction)
        {
            var points = new SurfacePoint[(lip.Length / 2) + 1];
            for (int i = 0; i < points.Length; i++)
            {
                int vertex = lip[(lip.Length / 2) - i];
                points[i] = new SurfacePoint(grown.Surface.Positions[vertex], normals[vertex]);
            }

            return new LipLine(points, direction);
        }
    }

    private float Gum => dentition.Gum * length;

    /// <summary>Appends the gum of one jaw.</summary>
    public void AppendGum(PieceBuilder builder, Jaw jaw)
    {
        GumShape.Append(builder, LipOf(jaw), Gum, (GumInset * Gum) + (hidden * Covered * length), gumColour);
        builder.AppendMirrored(0, 0);
    }

    /// <summary>Appends the teeth of one jaw.</summary>
    public void AppendTeeth(PieceBuilder builder, Jaw jaw, Vector3 colour)
    {
        float inset = dentition.Bared ? Bared * length : (GumInset * Gum) + (((hidden * Covered) + (jaw == Jaw.Lower ? Within : 0f)) * length);
        ToothRow.Append(builder, LipOf(jaw), jaw == Jaw.Upper ? dentition.Upper : dentition.Lower, length, inset, colour);
        builder.AppendMirrored(0, 0);
    }

    private LipLine LipOf(Jaw jaw) => jaw == Jaw.Upper ? upper : lower;
}
