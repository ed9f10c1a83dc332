using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Limbs;
using CreatureGen.Maths;

namespace CreatureGen.Creatures;

/// <summary>Sets the two bills of a beak on the jaws of a creature.</summary>
internal sealed class BeakSetter
{
    /// <summary>Rings of the muzzle that bills may lie on, and one behind them.</summary>
    private const int Rings = 9;

    /// <summary>Segments from one column of a bill to the next.</summary>
    private const int Stride = 2;

    private const int Chin = BodyGrid.Segments / 2;

    // How far the cutting edges lap over the lips, in radii of the section: the upper one over the lower one.
    private const float UpperLap = 0.12f;
    private const float LowerLap = 0.01f;

    /// <summary>Thickness of the lower bill along the lip, relative to that of its side: it lies within the upper one.</summary>
    private const float LowerTuck = 0.25f;

    // Shades of horn: at the root, on the lower bill, and of soft skin at the root; along the ridge, above the lips and on the cutting edge, without which a beak is an egg from the front.
    private const float AtRoot = 0.62f;
    private const float Lower = 0.85f;
    private const float Soft = 0.45f;
    private const float Ridge = 1.08f;
    private const float Flank = 0.8f;
    private const float Edge = 0.5f;

    /// <summary>Breadth of the change to the shade of the tip, as a share of the beak.</summary>
    private const float Blur = 0.1f;

    private readonly BeakForm form;
    private readonly float onFace;
    private readonly BillShape upper;
    private readonly BillShape lower;

    /// <summary>Fits a beak to the face of a creature whose mouth opens.</summary>
    public BeakSetter(BeakBlueprint beak, MouthBlueprint mouth, GrownSurface grown)
    {
        form = BeakForm.Of(beak.Style);
        BodyShape shape = grown.Skin.Shape;
        float nose = MouthSlit.NoseBulge(shape);
        BillReach reach = BillReach.Of(beak, shape);
        float covered = (float)BodyShape.At(shape.Arc, form.Root.Top);
        onFace = covered / (covered + reach.Upper);
        upper = new BillShape(Upper(grown), form.Upper, (float)beak.Girth)
        {
            Root = (form.Root.Top, form.Root.Lip), Length = reach.Upper, Nose = nose, Turn = (float)beak.Hook, Lap = UpperLap, Cere = form.Cere,
        };
        lower = new BillShape(LowerOf(grown, MouthSlit.AngleOf(mouth)), form.Lower, (float)beak.Girth)
        {
            Root = (form.Root.Chin, form.Root.Lip - 0.3f), Length = reach.Lower, Nose = nose, Turn = -BillShape.TurnOf((float)beak.Hook, reach, nose), Lap = LowerLap, Tuck = LowerTuck,
        };
    }

    /// <summary>The skin of the beak at the place of the left nostril.</summary>
    public SurfacePoint Nostril => upper.Place(form.Nostril.Along, form.Nostril.Segment / Stride);

    /// <summary>Whether nostrils are in soft skin.</summary>
    public bool IsNostrilSoft => form.Nostril.Along < form.Cere;

    /// <summary>Appends the upper bill.</summary>
    public void AppendUpper(PieceBuilder builder, CoatPalette palette, Vector3 horn) => upper.Append(builder, true, (along, column) =>
        Across(upper, column) * (along < form.Cere ? SoftColour(palette, horn) : Shaded(horn, along, form.Cere)));

    /// <summary>Appends the lower bill.</summary>
    public void AppendLower(PieceBuilder builder, Vector3 horn) => lower.Append(builder, false, (along, column) => Shaded(horn, along, 0f) * (Lower * Across(lower, column)));

    /// <summary>The colour of soft skin at the root: that of the legs, in the light.</summary>
    public static Vector3 SoftColour(CoatPalette palette, Vector3 horn) => Vec.Lerp(palette.Limb, horn, Soft);

    /// <summary>Shade of a column of a bill: lightest on the ridge, darkest on the cutting edge.</summary>
    private static float Across(BillShape bill, float column)
    {
        float across = column / bill.Lip;
        return Scalar.Lerp(Ridge, Flank, Scalar.Smooth(across / 0.7f)) * Scalar.Lerp(1f, Edge / Flank, Scalar.Smooth((across - 0.7f) / 0.3f));
    }

    private Vector3 Shaded(Vector3 horn, float along, float root)
    {
        float edge = Scalar.Lerp(AtRoot, 1f, Scalar.Smooth((along - root) / 0.3f));
        float share = along < 1f ? along * onFace : onFace + ((along - 1f) * (1f - onFace));
        float tip = form.TipMark > 0f ? Scalar.Smooth(((share - 1f + form.TipMark) / Blur) + 0.5f) : 0f;
        return horn * (edge * Scalar.Lerp(1f, form.TipShade, tip));
    }

    private static BillFace Upper(GrownSurface grown)
    {
        BodyShape shape = grown.Skin.Shape;
        const int columns = (BodyGrid.LipSegment / Stride) + 1;
        return Face(shape, columns, shape.Forward(StationRing.Nose), ring => Vector3.Zero - shape.Up(ring), (ring, k) =>
        {
            int segment = k * Stride;
            return new SurfacePoint(grown.Surface.Positions[grown.BodyVertex(ring, segment)], grown.Skin.At(ring, segment).Normal);
        });
    }

    private static BillFace LowerOf(GrownSurface grown, double angle)
    {
        BodyShape shape = grown.Skin.Shape;
        const int columns = ((Chin - BodyGrid.LipSegment) / Stride) + 1;
        return Face(shape, columns, Turned(shape.Forward(StationRing.Nose)), ring => Turned(shape.Up(ring)), (ring, k) =>
        {
            int segment = Chin - (k * Stride);
            int vertex = segment == BodyGrid.LipSegment && ring < grown.Mouth.CornerRing ? grown.Mouth.LowerLip[grown.Mouth.CornerRing - ring] : grown.BodyVertex(ring, segment);
            return new SurfacePoint(grown.Surface.Positions[vertex], Turned(grown.Skin.At(ring, segment).Normal));
        });

        Vector3 Turned(Vector3 v) => Vec.Rotate(v, Vector3.UnitX, angle);
    }

    private static BillFace Face(BodyShape shape, int columns, Vector3 forward, Func<int, Vector3> toMouth, Func<int, int, SurfacePoint> at)
    {
        var skin = new SurfacePoint[Rings * columns];
        var directions = new Vector3[Rings];
        float[] radius = new float[Rings];
        for (int ring = 0; ring < Rings; ring++)
        {
            directions[ring] = toMouth(ring);
            radius[ring] = (float)((shape.Width[ring] + (0.5 * (shape.Top[ring] + shape.Bottom[ring]))) / 2);
            for (int k = 0; k < columns; k++)
            {
                SurfacePoint point = at(ring, k);
                skin[(ring * columns) + k] = k > 0 ? point : new SurfacePoint(new Vector3(0f, point.Position.Y, point.Position.Z), Vec.Normalize(new Vector3(0f, point.Normal.Y, point.Normal.Z), Vector3.Zero - directions[ring]));
            }
        }

        return new BillFace(skin, columns, directions, radius, forward);
    }
}
