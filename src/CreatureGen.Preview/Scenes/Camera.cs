using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Scenes;

/// <summary>A perspective camera: a place, a direction and an angle of view. Model space, metres.</summary>
public sealed class Camera
{
    /// <summary>Vertical angle of view of fitted cameras, degrees: that of a portrait lens.</summary>
    public const double PortraitFieldOfView = 24;

    /// <summary>Part of the frame that fitted cameras leave free at each edge.</summary>
    public const float DefaultMargin = 0.07f;

    // Part of the distance to the target in front of which nothing is drawn.
    private const float NearPart = 0.01f;

    // Within half a degree of straight up or down, +Y gives no picture direction.
    private const float SteepCosine = 0.99996f;

    /// <summary>A camera at <paramref name="eye"/> that looks at <paramref name="target"/> with +Y upwards, or with +Z upwards when it looks straight down or up.</summary>
    /// <param name="eye">Where it is.</param>
    /// <param name="target">What is in the middle of the picture.</param>
    /// <param name="fieldOfViewDegrees">Vertical angle of view, degrees, above 0 and below 170.</param>
    /// <exception cref="ArgumentException">The two points are the same or not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The angle is out of its range.</exception>
    public Camera(Vector3 eye, Vector3 target, double fieldOfViewDegrees)
    {
        if (!(fieldOfViewDegrees > 0 && fieldOfViewDegrees < 170))
        {
            throw new ArgumentOutOfRangeException(nameof(fieldOfViewDegrees), fieldOfViewDegrees, "expected degrees above 0 and below 170");
        }

        float distance = Vec.Distance(eye, target);
        if (!(distance > 0f && float.IsFinite(distance)))
        {
            throw new ArgumentException(FormattableString.Invariant($"eye {eye} and target {target}; expected two different finite points"), nameof(target));
        }

        Eye = eye;
        Target = target;
        FieldOfViewDegrees = fieldOfViewDegrees;
        Forward = (target - eye) / distance;
        Right = RightOf(Forward);
        Up = Vec.Cross(Right, Forward);
        Near = distance * NearPart;
    }

    /// <summary>Where it is.</summary>
    public Vector3 Eye { get; }

    /// <summary>What is in the middle of the picture.</summary>
    public Vector3 Target { get; }

    /// <summary>Vertical angle of view, degrees.</summary>
    public double FieldOfViewDegrees { get; }

    /// <summary>Unit direction into the picture.</summary>
    public Vector3 Forward { get; }

    /// <summary>Unit direction to the right edge of the picture, always level.</summary>
    public Vector3 Right { get; }

    /// <summary>Unit direction to the upper edge of the picture.</summary>
    public Vector3 Up { get; }

    /// <summary>Distance along <see cref="Forward"/> before which nothing is drawn, metres.</summary>
    public float Near { get; }

    /// <summary>The camera of a named view in which the box just fits the frame.</summary>
    public static Camera Fit(View view, BoundingBox box, float aspect, float margin = DefaultMargin) => Fit(Views.Angle(view), box, aspect, margin);

    /// <summary>The nearest camera at the given angle for which all corners of the box are inside the frame less its margin.</summary>
    /// <param name="angle">From where it looks.</param>
    /// <param name="box">What to show.</param>
    /// <param name="aspect">Width of the picture divided by its height.</param>
    /// <param name="margin">Part of the frame left free at each edge, 0 to below 0.5.</param>
    public static Camera Fit(CameraAngle angle, BoundingBox box, float aspect, float margin = DefaultMargin)
    {
        Span<Vector3> corners = stackalloc Vector3[8];
        for (int i = 0; i < corners.Length; i++)
        {
            corners[i] = box.Corner(i);
        }

        return Fit(angle, corners, aspect, margin);
    }

    /// <summary>The nearest camera at the given angle for which all points are inside the frame less its margin: they touch two opposite edges of it.</summary>
    /// <remarks>It stays a quarter of the points' depth away from the nearest, so that points in one long line of sight leave more room at the edges.</remarks>
    /// <param name="angle">From where it looks.</param>
    /// <param name="points">What to show, at least one point.</param>
    /// <param name="aspect">Width of the picture divided by its height.</param>
    /// <param name="margin">Part of the frame left free at each edge, 0 to below 0.5.</param>
    /// <param name="fieldOfViewDegrees">Vertical angle of view, degrees, above 0 and below 170: the smaller it is, the farther away the camera.</param>
    /// <exception cref="ArgumentException">There is no point, or one is not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The aspect is not positive, the margin or the angle out of its range.</exception>
    public static Camera Fit(CameraAngle angle, ReadOnlySpan<Vector3> points, float aspect, float margin = DefaultMargin, double fieldOfViewDegrees = PortraitFieldOfView)
    {
        CheckFrame(aspect, margin);
        Vector3 back = angle.TowardsCamera;
        Vector3 forward = -back;
        Vector3 right = RightOf(forward);
        Vector3 up = Vec.Cross(right, forward);
        double tanY = HalfTangent(fieldOfViewDegrees) * (1 - (2 * margin));
        double tanX = tanY * aspect;

        // Each edge plane of the frame, pushed against the points: a camera (cx, cy, cz) sees all when
        // left + tanX·cz ≤ cx ≤ right − tanX·cz, and likewise in y; the largest such cz is the nearest camera.
        double left = double.NegativeInfinity;
        double bottom = double.NegativeInfinity;
        double rightmost = double.PositiveInfinity;
        double top = double.PositiveInfinity;
        double nearest = double.PositiveInfinity;
        double farthest = double.NegativeInfinity;
        foreach (Vector3 p in points)
        {
            double x = Vec.Dot(p, right);
            double y = Vec.Dot(p, up);
            double z = Vec.Dot(p, forward);
            left = Math.Max(left, x - (tanX * z));
            rightmost = Math.Min(rightmost, x + (tanX * z));
            bottom = Math.Max(bottom, y - (tanY * z));
            top = Math.Min(top, y + (tanY * z));
            nearest = Math.Min(nearest, z);
            farthest = Math.Max(farthest, z);
        }

        double eyeZ = Math.Min((rightmost - left) / (2 * tanX), (top - bottom) / (2 * tanY));
        if (!double.IsFinite(eyeZ) || !double.IsFinite(nearest))
        {
            throw new ArgumentException("no points, or points that are not finite; expected at least one finite point", nameof(points));
        }

        // One lone point, or points in one line of sight, would put the camera onto them.
        double depth = Math.Max(farthest - nearest, 1e-3);
        eyeZ = Math.Min(eyeZ, nearest - (0.25 * depth));
        double middle = (nearest + farthest) / 2;
        float eyeX = (float)((left + rightmost) / 2);
        float eyeY = (float)((bottom + top) / 2);
        Vector3 level = (right * eyeX) + (up * eyeY);
        return new Camera(level + (forward * (float)eyeZ), level + (forward * (float)middle), fieldOfViewDegrees);
    }

    /// <summary>The camera of a named view in which a sphere just fits the frame.</summary>
    public static Camera CloseUp(View view, Vector3 centre, float radius, float aspect, float margin = DefaultMargin) =>
        CloseUp(Views.Angle(view), centre, radius, aspect, margin);

    /// <summary>The nearest camera at the given angle for which a sphere is inside the frame less its margin.</summary>
    /// <param name="angle">From where it looks.</param>
    /// <param name="centre">Middle of the sphere.</param>
    /// <param name="radius">Metres, above 0.</param>
    /// <param name="aspect">Width of the picture divided by its height.</param>
    /// <param name="margin">Part of the frame left free at each edge, 0 to below 0.5.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static Camera CloseUp(CameraAngle angle, Vector3 centre, float radius, float aspect, float margin = DefaultMargin)
    {
        CheckFrame(aspect, margin);
        if (!(radius > 0f && float.IsFinite(radius)))
        {
            throw new ArgumentOutOfRangeException(nameof(radius), radius, "expected metres above 0");
        }

        double tangent = HalfTangent(PortraitFieldOfView) * (1 - (2 * margin)) * Math.Min(1, aspect);
        double distance = radius * Math.Sqrt(1 + (1 / (tangent * tangent)));
        return new Camera(centre + (angle.TowardsCamera * (float)distance), centre, PortraitFieldOfView);
    }

    /// <summary>Where a point is in a picture: x from the left and y from the top in pixels, z the distance along <see cref="Forward"/> in metres.</summary>
    /// <remarks>Only points with z above 0 are before the camera.</remarks>
    public Vector3 Project(Vector3 point, int width, int height)
    {
        Vector3 q = point - Eye;
        float z = Vec.Dot(q, Forward);
        float scale = PixelsPerTangent(height) / z;
        return new Vector3((width * 0.5f) + (Vec.Dot(q, Right) * scale), (height * 0.5f) - (Vec.Dot(q, Up) * scale), z);
    }

    /// <summary>Pixels between the middle of a picture of the given height and a point one metre beside the axis at a distance of one metre.</summary>
    internal float PixelsPerTangent(int height) => (float)(height * 0.5 / HalfTangent(FieldOfViewDegrees));

    private static double HalfTangent(double degrees)
    {
        double half = Scalar.Radians(degrees) / 2;
        return PortableMath.Sin(half) / PortableMath.Cos(half);
    }

    private static Vector3 RightOf(Vector3 forward) =>
        Math.Abs(forward.Y) > SteepCosine
            ? Vec.Normalize(Vec.Cross(forward, Vector3.UnitZ))
            : Vec.Normalize(Vec.Cross(forward, Vector3.UnitY));

    private static void CheckFrame(float aspect, float margin)
    {
        if (!(aspect > 0f && float.IsFinite(aspect)))
        {
            throw new ArgumentOutOfRangeException(nameof(aspect), aspect, "expected width divided by height, above 0");
        }

        if (!(margin >= 0f && margin < 0.5f))
        {
            throw new ArgumentOutOfRangeException(nameof(margin), margin, "expected 0 to below 0.5");
        }
    }
}
