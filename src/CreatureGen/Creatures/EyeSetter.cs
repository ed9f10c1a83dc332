using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>Sets eyes and lids into a grown surface and tells the rig about them. Everything at scale 1.</summary>
internal static class EyeSetter
{
    /// <summary>Eyes that look are looked at first; a face without them is none.</summary>
    private const float EyeSimplificationWeight = 3f;

    private const float LidShade = 0.8f;

    /// <summary>How far apart the two halves of a lid on the midline may be by rounding, in radii.</summary>
    private const float LidRounding = 5e-5f;

    /// <summary>The eye of a creature's left side.</summary>
    public static EyeFrame EyeOf(CreatureBlueprint blueprint, GrownSurface grown)
    {
        EyeBlueprint eye = EyesOf(blueprint);
        SurfacePoint skin = grown.Skin.At(eye.Ring, eye.Segment);
        if (eye.IsSingle)
        {
            skin = new SurfacePoint(new Vector3(0f, skin.Position.Y, skin.Position.Z), Vec.Normalize(new Vector3(0f, skin.Normal.Y, skin.Normal.Z)));
        }

        return EyeFrame.On(skin, eye, grown.Skin.Shape.Forward((int)eye.Ring), 1f);
    }

    /// <summary>The left eye as the rig sees it.</summary>
    public static EyeSocket SocketOf(CreatureBlueprint blueprint, in EyeFrame frame)
    {
        EyeBlueprint eye = EyesOf(blueprint);
        return new EyeSocket(frame.Centre, frame.Gaze, frame.Radius)
        {
            Lids = RimOf(blueprint) != EyeRim.Lids ? null : new LidHinge(
                LidShape.Hinge(frame, eye),
                LidShape.RimDirection(frame, eye, LidPart.Upper),
                LidShape.RimDirection(frame, eye, LidPart.Lower),
                LidShape.Closing(eye, LidPart.Upper),
                LidShape.Closing(eye, LidPart.Lower)),
        };
    }

    /// <summary>Adds both eyes and what surrounds them.</summary>
    /// <param name="blueprint">The creature.</param>
    /// <param name="grown">Its surface.</param>
    /// <param name="coat">Its colours.</param>
    /// <param name="builder">Is cleared and used.</param>
    /// <param name="pieces">Gets the pieces.</param>
    public static void Add(CreatureBlueprint blueprint, GrownSurface grown, CoatPainter coat, PieceBuilder builder, List<Piece> pieces)
    {
        EyeBlueprint eye = EyesOf(blueprint);
        EyeFrame frame = EyeOf(blueprint, grown);
        EyeRim rim = RimOf(blueprint);
        Vector3 skin = SkinAround(eye, frame, coat);
        builder.Clear(SurfaceFinish.Eye);
        if (rim == EyeRim.Bare)
        {
            EyeShape.Append(builder, frame, eye.Style, coat.Palette.Iris);
        }
        else
        {
            EyeShape.Append(builder, frame, eye.Style, coat.Palette.Iris, skin * 0.8f);
        }

        Piece ball = builder.ToPiece(MaterialKind.Skin, new PieceBinding.Joint("Eye_L"), eye.Style == EyeStyle.Compound ? 1f : EyeSimplificationWeight);
        AddPair(pieces, ball, eye.IsSingle ? "" : "Eye_R");
        if (rim == EyeRim.Bare)
        {
            return;
        }

        AddLid(LidPart.Upper, "UpperLid_");
        AddLid(LidPart.Lower, "LowerLid_");

        void AddLid(LidPart part, string joint)
        {
            builder.Clear();
            LidShape.Append(builder, frame, eye, part, skin);
            if (frame.IsMedian)
            {
                builder.Symmetrise(0, LidRounding * frame.Radius);
            }

            bool moves = rim == EyeRim.Lids;
            AddPair(pieces, builder.ToPiece(MaterialKind.Skin, new PieceBinding.Joint(moves ? joint + "L" : "Head")), eye.IsSingle ? "" : moves ? joint + "R" : "Head");
        }
    }

    /// <summary>The eyes of a blueprint. Lids of a single eye do not roll: it has no outer corner.</summary>
    private static EyeBlueprint EyesOf(CreatureBlueprint blueprint) =>
        blueprint.Head.Eyes.IsSingle ? blueprint.Head.Eyes with { LidTilt = 0 } : blueprint.Head.Eyes;

    private static EyeRim RimOf(CreatureBlueprint blueprint) =>
        blueprint.Head.Eyes.Style is EyeStyle.Compound or EyeStyle.Bead ? EyeRim.Bare : SpeciesCatalogue.Find(blueprint.Body.Blend.Face).EyeRim;

    /// <summary>Lids wear the coat of the skin above the eye, a little darker.</summary>
    private static Vector3 SkinAround(EyeBlueprint eye, in EyeFrame frame, CoatPainter coat)
    {
        var address = new VertexAddress { Region = SurfaceRegion.Body, Appendage = -1, Sign = 1, Ring = (float)eye.Ring, Segment = (float)eye.Segment };
        return LidShade * coat.At(address, frame.Centre + (frame.Up * (1.1f * frame.Radius)), frame.Up);
    }

    /// <summary>Adds a piece and, if it has a joint on the right, its mirror image.</summary>
    private static void AddPair(List<Piece> pieces, Piece left, string rightJoint)
    {
        pieces.Add(left);
        if (rightJoint.Length > 0)
        {
            pieces.Add(PieceMirror.Mirror(left, new PieceBinding.Joint(rightJoint)));
        }
    }
}
