using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Where an eye of the left side sits, how large it is and where it looks. The right eye is its mirror image.</summary>
internal readonly struct EyeFrame
{
    // Share of the skin's outward direction in the gaze.
    private const float SkinFraction = 0.75f;

    /// <summary>Levels the frame of an eye with the given gaze, which must not be vertical.</summary>
    /// <param name="centre">Centre of the eyeball, model space, metres.</param>
    /// <param name="radius">Radius of the eyeball, metres.</param>
    /// <param name="gaze">Unit direction of the gaze.</param>
    public EyeFrame(Vector3 centre, float radius, Vector3 gaze)
    {
        Centre = centre;
        Radius = radius;
        Gaze = gaze;
        Outward = Vec.Normalize(Vec.Cross(Vector3.UnitY, gaze), Vector3.UnitX);
        Up = Vec.Cross(gaze, Outward);
    }

    private EyeFrame(Vector3 centre, float radius, Vector3 gaze, Vector3 outward, Vector3 up)
    {
        Centre = centre;
        Radius = radius;
        Gaze = gaze;
        Outward = outward;
        Up = up;
    }

    /// <summary>Centre of the eyeball, model space, metres.</summary>
    public Vector3 Centre { get; }

    /// <summary>Radius of the eyeball, metres.</summary>
    public float Radius { get; }

    /// <summary>Unit direction of the gaze.</summary>
    public Vector3 Gaze { get; }

    /// <summary>Whether it is a single eye in the sagittal plane.</summary>
    public bool IsMedian => Centre.X == 0f && Gaze.X == 0f;

    /// <summary>Unit direction across the gaze towards the outer corner of the eye: away from the nose.</summary>
    public Vector3 Outward { get; }

    /// <summary>Unit direction across the gaze towards the brow.</summary>
    public Vector3 Up { get; }

    /// <summary>The frame that a blueprint asks for at its point of the skin.</summary>
    /// <param name="eye">The eyes of the creature.</param>
    /// <param name="skin">The body's surface at the ring and segment of the eye, left side.</param>
    /// <param name="headForward">Unit forward direction of the head there.</param>
    /// <param name="scale">Factor from the blueprint's metres to the metres of <paramref name="skin"/>.</param>
    public static EyeFrame On(SurfacePoint skin, EyeBlueprint eye, Vector3 headForward, float scale)
    {
        float radius = (float)eye.Radius * scale;
        Vector3 gaze = Vec.Normalize((skin.Normal * SkinFraction) + (headForward * (float)eye.Forward), skin.Normal);
        return new EyeFrame(skin.Position - (skin.Normal * (radius * (float)eye.Sink)), radius, gaze);
    }

    /// <summary>The same eye with its axes turned about the gaze; a positive angle raises the outer corner (and so lowers the inner one).</summary>
    public EyeFrame Rolled(double angle)
    {
        float c = (float)PortableMath.Cos(angle);
        float s = (float)PortableMath.Sin(angle);
        return new EyeFrame(Centre, Radius, Gaze, (Outward * c) + (Up * s), (Up * c) - (Outward * s));
    }

    /// <summary>
    /// The unit direction at a point of the azimuthal equidistant chart around the gaze: <paramref name="chart"/> holds the angle from the gaze,
    /// radians, split into its outward and its upward part.
    /// </summary>
    public Vector3 Direction(Vector2 chart)
    {
        float angle = (float)System.Math.Sqrt((chart.X * chart.X) + (chart.Y * chart.Y));
        if (angle < 1e-6f)
        {
            return Gaze;
        }

        float across = (float)PortableMath.Sin(angle) / angle;
        return (Gaze * (float)PortableMath.Cos(angle)) + (Outward * (across * chart.X)) + (Up * (across * chart.Y));
    }
}
