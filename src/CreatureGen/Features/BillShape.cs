using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>One half of a beak: a closed sheath of horn over the skin of a jaw that begins with an edge, has a cutting edge along the lip, and goes on beyond the nose to a tip.</summary>
/// <remarks>Its inner side lies in the flesh as far as there is any, and is the palate beyond. Sections are loops of one number of points, exactly mirrored.</remarks>
internal sealed class BillShape
{
    // Where sections lie between the root and the nose, and between the nose and the tip.
    private static readonly float[] onFace = { 0f, 0.07f, 0.2f, 0.36f, 0.53f, 0.7f, 0.86f, 1f };
    private static readonly float[] ahead = { 0.2f, 0.4f, 0.58f, 0.74f, 0.87f, 0.96f };

    /// <summary>How far behind the edge the sheath dips below the skin, rings, and how deep, in radii.</summary>
    private const float DipRings = 0.22f;
    private const float Dip = 0.05f;

    // How far the rim stands off, in thicknesses of the horn ahead of it, and how far soft skin at the root swells.
    private const float Rim = 1.15f;
    private const float Swell = 0.35f;

    /// <summary>The section that thickness is measured by is at least as large as this share of that at the root: at the nose faces are thinner than horn.</summary>
    private const float Slimmest = 0.42f;

    /// <summary>Where the cutting edge is, in thicknesses of the horn from the lip.</summary>
    private const float Sharp = 0.35f;

    // Where the inner side is between the mouth and the skin: in the flesh of the face, and beyond the nose.
    private const float InFlesh = 0.8f;
    private const float Palate = 0.18f;

    /// <summary>Room for the nose in the horn ahead of it, in its bulges.</summary>
    private const float Room = 1.3f;

    // How far ahead a bill does not turn: so much of the nose below it, and so much of its own length at most. What turned in its last part alone would end in a nib.
    private const float OverNose = 0.6f;
    private const float LongestStraight = 0.4f;

    /// <summary>Breadth of the step from soft skin to horn, as a share of the way from root to nose.</summary>
    private const float Step = 0.035f;

    private readonly BillFace face;
    private readonly BillForm form;
    private readonly float girth;

    /// <summary>Prepares a bill.</summary>
    /// <param name="face">The jaw that it lies on.</param>
    /// <param name="form">Its half of the family's form.</param>
    /// <param name="girth">Factor on its thickness.</param>
    public BillShape(BillFace face, BillForm form, float girth)
    {
        this.face = face;
        this.form = form;
        this.girth = girth;
    }

    /// <summary>Ring at which it begins along the middle line and along the lip.</summary>
    public (float Middle, float Lip) Root { get; init; }

    /// <summary>How far the tip is from the nose, metres.</summary>
    public float Length { get; init; }

    /// <summary>How far the nose below it bulges ahead, metres; less than the length.</summary>
    public float Nose { get; init; }

    /// <summary>How far it turns towards the other jaw from the nose to its tip, radians: down for the upper bill, up for the lower one.</summary>
    public float Turn { get; init; }

    /// <summary>How far the cutting edge laps over the lip, in radii of the section.</summary>
    public float Lap { get; init; }

    /// <summary>Thickness along the lip, relative to that of the side: less where the other bill laps over it.</summary>
    public float Tuck { get; init; } = 1f;

    /// <summary>Share of the way from the root to the nose that soft skin covers.</summary>
    public float Cere { get; init; }

    /// <summary>Its last column, at the lip.</summary>
    public int Lip => face.Columns - 1;

    /// <summary>How far a lower bill turns with the upper one that lies over it, radians: as much on each part of the way, and so less in all where it is shorter.</summary>
    /// <param name="turn">How far the upper bill turns, radians.</param>
    /// <param name="reach">How far they reach, metres.</param>
    /// <param name="nose">How far the nose bulges ahead, metres.</param>
    public static float TurnOf(float turn, BillReach reach, float nose) =>
        turn * reach.Lower * (1f - Straight(nose, reach.Lower)) / (reach.Upper * (1f - Straight(nose, reach.Upper)));

    /// <summary>A place of the outer side between the root (0) and the nose (1), on the left, as the facets there lie.</summary>
    /// <param name="along">0..1.</param>
    /// <param name="column">0 on the middle line, the last column at the lip.</param>
    public SurfacePoint Place(float along, float column)
    {
        List<float> stations = Stations();
        int i = 0;
        while (i < stations.Count - 2 && stations[i + 1] < along)
        {
            i++;
        }

        int k = Math.Min((int)column, face.Columns - 2);
        Vector3 a = Outer(stations[i], k), b = Outer(stations[i], k + 1), c = Outer(stations[i + 1], k), d = Outer(stations[i + 1], k + 1);
        float u = (along - stations[i]) / (stations[i + 1] - stations[i]);
        Vector3 at = Vec.Lerp(Vec.Lerp(a, b, column - k), Vec.Lerp(c, d, column - k), u);
        Vector3 outward = face.At(RingOf(along, column), column).Normal;
        Vector3 normal = Vec.Normalize(Vec.Cross(d - a, c - b), outward);
        return new SurfacePoint(at, Vec.Dot(normal, outward) < 0f ? Vector3.Zero - normal : normal);
    }

    /// <summary>Appends the bill.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="upper">Whether it is the upper one, whose middle line is on top.</param>
    /// <param name="shade">Linear RGB by place: share of the way to the nose 0..1, beyond it 1..2 to the tip; and the column.</param>
    public void Append(PieceBuilder builder, bool upper, Func<float, float, Vector3> shade)
    {
        int first = builder.VertexCount;
        int sides = (2 * face.Columns) + 4;
        Span<Vector3> outer = stackalloc Vector3[face.Columns];
        Span<Vector3> inner = stackalloc Vector3[3];

        // The sheath begins below the skin, so that its edge stands on it.
        for (int k = 0; k < outer.Length; k++)
        {
            float ring = RingOf(0f, k) + DipRings;
            outer[k] = face.At(ring, k).Position - (face.At(ring, k).Normal * (Dip * face.Radius(ring)));
        }

        inner[0] = Vec.Lerp(outer[outer.Length - 1], Middle(outer[outer.Length - 1]), Dip);
        Fill(outer, InFlesh, inner);
        Loop(builder, upper, outer, inner, _ => shade(0f, 0f) * 0.45f);
        Vector3 root = Vec.Lerp(inner[2], Middle(outer[0]), 0.5f);
        foreach (float along in Stations())
        {
            for (int k = 0; k < outer.Length; k++)
            {
                outer[k] = Outer(along, k);
            }

            Inner(along, outer, InFlesh, inner);
            Loop(builder, upper, outer, inner, column => shade(along, column));
        }

        Vector3 tip = Ahead(builder, upper, outer, inner, shade);
        LoopLoft.Close(builder, first, sides, root, shade(0f, 0f) * 0.45f, tip, shade(2f, 0f), face.Columns - 1);
    }

    /// <summary>The sections beyond the nose: the last one of the face, carried on along an arc and drawn together; returns the tip.</summary>
    private Vector3 Ahead(PieceBuilder builder, bool upper, Span<Vector3> last, Span<Vector3> edge, Func<float, float, Vector3> shade)
    {
        Span<Vector3> outer = stackalloc Vector3[last.Length];
        Span<Vector3> inner = stackalloc Vector3[3];
        Vector3 toMouth = face.ToMouth(0f);
        Vector3 forward = face.Forward;
        Vector3 seam = Middle(edge[0]);
        Vector3 centre = seam;
        float before = 0f;
        float straight = Straight(Nose, Length);
        for (int i = 0; i <= ahead.Length; i++)
        {
            float v = i < ahead.Length ? ahead[i] : 1f;
            float turned = Turn * Math.Max(0f, (v - straight) / (1f - straight));
            float angle = 0.5f * (turned + (Turn * Math.Max(0f, (before - straight) / (1f - straight))));
            centre += ((forward * (float)PortableMath.Cos(angle)) + (toMouth * (float)PortableMath.Sin(angle))) * (Length * (v - before));
            before = v;
            if (i == ahead.Length)
            {
                break;
            }

            // No narrower than the nose below it.
            float within = Math.Min(1f, v * Length / (Room * Nose));
            float round = (float)Math.Sqrt(1f - (within * within));
            float breadth = Math.Max(round, 1f - (float)PortableMath.Pow(v, form.Close.Breadth));
            float height = Math.Max(round, 1f - (float)PortableMath.Pow(v, form.Close.Height));
            PortableMath.SinCos(turned, out double sine, out double cosine);
            Vector3 across = (toMouth * (float)cosine) - (forward * (float)sine);
            for (int k = 0; k < outer.Length; k++)
            {
                outer[k] = Carried(last[k]);
            }

            edge.CopyTo(inner);
            inner[0] = Carried(edge[0]);
            float flesh = Scalar.Lerp(Palate, InFlesh, Scalar.Smooth(1f - (3f * v)));
            Fill(outer, flesh, inner);
            Loop(builder, upper, outer, inner, column => shade(1f + v, column));

            Vector3 Carried(Vector3 p) => centre + (Vector3.UnitX * (p.X * breadth)) + (across * (Vec.Dot(p - seam, toMouth) * height));
        }

        return centre;
    }

    /// <summary>Shares of the way from the root to the nose at which sections lie; where soft skin ends there are two.</summary>
    private List<float> Stations()
    {
        var stations = new List<float>(onFace);
        if (Cere > 0f)
        {
            stations.RemoveAll(along => Math.Abs(along - Cere) < 2f * Step);
            stations.Add(Cere - Step);
            stations.Add(Cere + Step);
            stations.Sort();
        }

        return stations;
    }

    /// <summary>Share of the way from the nose to the tip on which a bill does not turn: it turns ahead of the nose that it lies on.</summary>
    private static float Straight(float nose, float length) => Math.Min(OverNose * nose / length, LongestStraight);

    private float RingOf(float along, float column)
    {
        float part = column / (face.Columns - 1);
        float sine = (float)PortableMath.Sin(PortableMath.Pi * part);
        float notch = form.Notch * sine * sine;
        return (Scalar.Lerp(Root.Middle, Root.Lip, part) - notch) * (1f - along);
    }

    /// <summary>Thickness of the horn, in radii.</summary>
    private float Thickness(float along, float column)
    {
        float across = column * 2f / form.Keel;
        float ridge = (float)PortableMath.Exp(-(across * across));
        float thickness = Scalar.Lerp(Along(form.Side, along), Along(form.Ridge, along), ridge);
        if (Cere > 0f && along < Cere)
        {
            return thickness * (0.8f + (Swell * (float)PortableMath.Sin(PortableMath.Pi * along / Cere)));
        }

        return thickness * (along < 0.1f || (along < Cere + 0.1f && Cere > 0f) ? Rim : 1f);
    }

    private static float Along((float Root, float Middle, float Nose) value, float along) =>
        along < 0.5f ? Scalar.Lerp(value.Root, value.Middle, Scalar.Smooth(2f * along)) : Scalar.Lerp(value.Middle, value.Nose, Scalar.Smooth((2f * along) - 1f));

    private Vector3 Outer(float along, float column)
    {
        float ring = RingOf(along, column);
        SurfacePoint skin = face.At(ring, column);
        float radius = Math.Max(face.Radius(ring), Slimmest * face.Radius(Root.Middle));
        float lip = Scalar.Clamp(column - (face.Columns - 2), 0f, 1f);
        return skin.Position + (skin.Normal * (girth * radius * Thickness(along, column) * Scalar.Lerp(1f, Tuck, lip))) + (face.ToMouth(ring) * (0.6f * lip * Lap * radius));
    }

    /// <summary>The cutting edge and the inner side of a section of the face.</summary>
    private void Inner(float along, ReadOnlySpan<Vector3> outer, float flesh, Span<Vector3> inner)
    {
        int lip = face.Columns - 1;
        float ring = RingOf(along, lip);
        SurfacePoint skin = face.At(ring, lip);
        float radius = Math.Max(face.Radius(ring), Slimmest * face.Radius(Root.Middle));
        inner[0] = skin.Position + (skin.Normal * (Sharp * girth * radius * Thickness(along, lip))) + (face.ToMouth(ring) * (Lap * radius));
        Fill(outer, flesh, inner);
    }

    /// <summary>Inner points between the level of the cutting edge and the outer side: one to the side, one in the middle.</summary>
    private static void Fill(ReadOnlySpan<Vector3> outer, float flesh, Span<Vector3> inner)
    {
        Vector3 seam = Middle(inner[0]);
        Vector3 aside = outer[outer.Length - 2];
        inner[1] = Vec.Lerp(new Vector3(0.72f * inner[0].X, seam.Y, seam.Z), new Vector3(0.72f * aside.X, aside.Y, aside.Z), flesh);
        inner[2] = Vec.Lerp(seam, Middle(outer[0]), flesh);
    }

    private static Vector3 Middle(Vector3 p) => new(0f, p.Y, p.Z);

    /// <summary>Adds a loop, counter-clockwise as seen from the tip: the outer side from lip to lip, then the inner one back.</summary>
    private static void Loop(PieceBuilder builder, bool upper, ReadOnlySpan<Vector3> outer, ReadOnlySpan<Vector3> inner, Func<float, Vector3> shade)
    {
        int lip = outer.Length - 1;
        float side = upper ? 1f : -1f;
        for (int k = lip; k > -lip - 1; k--)
        {
            Add(outer[Math.Abs(k)], k < 0 ? -side : side, shade(Math.Abs(k)));
        }

        Add(inner[0], -side, shade(lip) * 0.8f);
        Add(inner[1], -side, shade(lip) * 0.45f);
        Add(inner[2], side, shade(lip) * 0.4f);
        Add(inner[1], side, shade(lip) * 0.45f);
        Add(inner[0], side, shade(lip) * 0.8f);

        void Add(Vector3 p, float s, Vector3 colour) => builder.Vertex(new Vector3(p.X * s, p.Y, p.Z), Vector3.UnitY, colour);
    }
}
