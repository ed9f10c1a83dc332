using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Horns, spikes, tusks, tufts and mandibles: a tapered, curved body whose root is sunk into the skin.</summary>
internal static class HornShape
{
    private const int MaxRows = 12;

    /// <summary>Appends one feature of the left side or of the midline; antennae have their own shape, <see cref="AntennaShape"/>.</summary>
    /// <param name="builder">Where the feature goes.</param>
    /// <param name="feature">Radius, taper, flatness and kind.</param>
    /// <param name="curve">Its axis.</param>
    /// <param name="scale">Factor from the blueprint's metres to those of the curve.</param>
    /// <param name="colour">Linear RGB of its middle; root and tip are shaded from it by kind.</param>
    public static void Append(PieceBuilder builder, FeatureBlueprint feature, in FeatureCurve curve, float scale, Vector3 colour)
    {
        Form form = FormOf(feature.Kind);
        float radius = (float)feature.Radius * scale;
        float taper = Scalar.Clamp((float)feature.Taper, 0.2f, 3f);
        float flatness = Scalar.Clamp((float)feature.Flatness, 0.1f, 4f);
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[MaxRows];
        for (int i = 0; i < form.Rows; i++)
        {
            // Rows gather towards the tip, where a blunt profile bends most.
            float x = (float)i / form.Rows;
            float s = 1f - ((1f - x) * (1f - (0.35f * x)));
            float t = start + ((1f - start) * s);
            float ridge = form.Ridge * ((i & 1) == 0 ? 1f : -1f) * (1f - x);
            float r = radius * (form.Dome ? (float)Math.Sqrt(1f - (s * s)) : (float)PortableMath.Pow(1f - s, taper)) * (1f + ridge);
            Vector3 shade = Shade(form, colour, s) * (1f + (1.6f * ridge));
            rows[i] = new TubeRow(curve.Point(t), r, r * flatness, Clamp(shade));
        }

        SweptTube.Append(builder, rows.Slice(0, form.Rows), curve.Point(1f), Clamp(Shade(form, colour, 1f)), MajorHint(curve), form.Sides);
    }

    /// <summary>The direction along the body, or away from it where the feature itself points along the body.</summary>
    internal static Vector3 MajorHint(in FeatureCurve curve)
    {
        Vector3 along = Vec.Reject(curve.Forward, curve.Direction);
        return Vec.LengthSquared(along) > 0.1f ? along : Vec.Cross(Vector3.UnitX, curve.Direction);
    }

    private static Vector3 Shade(in Form form, Vector3 colour, float s)
    {
        float root = Scalar.Smooth((0.30f - s) / 0.30f);
        float tip = Scalar.Smooth((s - 0.35f) / 0.65f);
        return colour * Scalar.Lerp(1f, form.Root, root) * Scalar.Lerp(1f, form.Tip, tip);
    }

    private static Vector3 Clamp(Vector3 c) => new(Scalar.Clamp(c.X, 0f, 1f), Scalar.Clamp(c.Y, 0f, 1f), Scalar.Clamp(c.Z, 0f, 1f));

    private static Form FormOf(FeatureKind kind) => kind switch
    {
        FeatureKind.Horn => new Form(sides: 8, rows: 8, ridge: 0.07f, tip: 0.45f),
        FeatureKind.Spike => new Form(sides: 6, rows: 2, ridge: 0f, tip: 1.15f),
        FeatureKind.Mandible => new Form(sides: 6, rows: 6, ridge: 0f, tip: 0.35f),
        FeatureKind.Tusk => new Form(sides: 7, rows: 6, ridge: 0f, tip: 1.1f, root: 0.4f),
        FeatureKind.Tuft => new Form(sides: 6, rows: 5, ridge: 0f, tip: 0.55f),
        FeatureKind.Scute => new Form(sides: 6, rows: 2, ridge: 0f, tip: 0.7f),
        FeatureKind.Ocellus => new Form(sides: 10, rows: 5, ridge: 0f, tip: 7f, dome: true),
        FeatureKind.Plate => new Form(sides: 10, rows: 5, ridge: 0f, tip: 0.7f),
        FeatureKind.Club => new Form(sides: 9, rows: 6, ridge: 0.06f, tip: 0.75f),
        _ => throw new ArgumentException("feature kind " + kind + "; expected a horn, spike, mandible, tusk or tuft", nameof(kind)),
    };

    /// <summary>Resolution and shading of one kind.</summary>
    private readonly struct Form
    {
        public Form(int sides, int rows, float ridge, float tip, float root = 0.62f, bool dome = false)
        {
            Sides = sides;
            Rows = rows;
            Ridge = ridge;
            Tip = tip;
            Root = root;
            Dome = dome;
        }

        public int Sides { get; }

        public int Rows { get; }

        /// <summary>Height of the growth rings relative to the radius.</summary>
        public float Ridge { get; }

        /// <summary>Factor on the colour at the tip.</summary>
        public float Tip { get; }

        /// <summary>Factor on the colour at the root: tusks are stained where they leave the gum.</summary>
        public float Root { get; }

        /// <summary>Whether it is half a ball, whatever its taper: small eyes are.</summary>
        public bool Dome { get; }
    }
}
