using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The axis of a horn-like feature: from a point of the skin along a direction, bending with the square of the way.</summary>
internal readonly struct FeatureCurve
{
    /// <summary>The curve of a feature on the left side or on the midline.</summary>
    /// <param name="feature">Direction, length and bend.</param>
    /// <param name="skin">The surface at the ring and segment of the feature.</param>
    /// <param name="forward">Unit direction that the feature's front components follow: the body's forward direction at the ring.</param>
    /// <param name="up">Unit direction that its upward components follow: up.</param>
    /// <param name="scale">Factor from the blueprint's metres to the metres of <paramref name="skin"/>.</param>
    public FeatureCurve(FeatureBlueprint feature, SurfacePoint skin, Vector3 forward, Vector3 up, float scale)
    {
        // A single part stands on the sagittal plane and leans to neither side.
        bool median = feature.Segment == 0 || feature.Segment == BodyGrid.Segments / 2;
        float side = median ? 0f : 1f;
        if (median)
        {
            skin = new SurfacePoint(OnMidline(skin.Position), Vec.Normalize(OnMidline(skin.Normal), up));
        }

        Skin = skin;
        Forward = forward;
        Length = (float)feature.Length * scale;
        Direction = Vec.Normalize(
            (skin.Normal * (float)feature.Outward)
                + (up * (float)feature.Upward)
                + (forward * (float)feature.Forward)
                + (Vector3.UnitX * (side * (float)feature.Sideward)),
            skin.Normal);
        Root = Vec.Normalize(Direction + skin.Normal, skin.Normal);
        Bend = ((up * (float)feature.BendUp) + (forward * (float)feature.BendForward) + (Vector3.UnitX * (side * (float)feature.BendSide))) * Length;
    }

    /// <summary>Where the axis leaves the skin.</summary>
    public SurfacePoint Skin { get; }

    /// <summary>Unit forward direction of the body.</summary>
    public Vector3 Forward { get; }

    /// <summary>Unit direction at the skin.</summary>
    public Vector3 Direction { get; }

    /// <summary>Unit direction below the skin: steeper than <see cref="Direction"/>, so that a leaning root stays covered.</summary>
    public Vector3 Root { get; }

    /// <summary>Displacement of the tip by the bend, metres.</summary>
    public Vector3 Bend { get; }

    /// <summary>Length of the unbent axis, metres.</summary>
    public float Length { get; }

    /// <summary>The axis at <paramref name="t"/>, 0 at the skin and 1 at the tip; below the skin where negative.</summary>
    public Vector3 Point(float t) => t > 0f
        ? Skin.Position + (Direction * (Length * t)) + (Bend * (t * t))
        : Skin.Position + (Root * (Length * t));

    /// <summary>Root, middle and tip, the joints of a feature that moves.</summary>
    public Vector3[] JointPoints() => new[] { Point(0f), Point(0.5f), Point(1f) };

    /// <summary>
    /// How far below the skin, along the axis, a root of the given radius has to start for its whole rim to be covered, metres.
    /// </summary>
    public float RootDepth(float radius)
    {
        // The rim of a root that leans over by the angle a between axis and normal rises by radius · sin a.
        float cos = Scalar.Clamp(Vec.Dot(Root, Skin.Normal), 0f, 1f);
        float sin = (float)System.Math.Sqrt(1f - (cos * cos));
        float depth = (radius * sin) + Scalar.Clamp(0.6f * radius, 0.25f * SmallestCover, SmallestCover);
        return depth / System.Math.Max(cos, 0.4f);
    }

    private static Vector3 OnMidline(Vector3 v) => new(0f, v.Y, v.Z);

    // Metres at the size of a creature with a torso of one metre.
    private const float SmallestCover = 0.025f;
}
