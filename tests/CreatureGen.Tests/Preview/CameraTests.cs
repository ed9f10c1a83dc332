using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class CameraTests
{
    private const int Height = 600;

    public static TheoryData<double, double, float> Angles { get; } = MakeAngles();

    [Theory]
    [MemberData(nameof(Angles))]
    public void A_fitted_camera_has_all_points_inside_the_frame_less_its_margin_and_two_opposite_edges_touched(double azimuth, double elevation, float aspect)
    {
        int width = (int)(Height * aspect);
        foreach (float margin in new[] { 0f, Camera.DefaultMargin, 0.3f })
        {
            for (int seed = 0; seed < 20; seed++)
            {
                Vector3[] points = Cloud(seed);
                Camera camera = Camera.Fit(new CameraAngle(azimuth, elevation), points, width / (float)Height, margin);
                Vector3[] seen = points.Select(p => camera.Project(p, width, Height)).ToArray();
                float left = seen.Min(p => p.X) - (width * margin);
                float right = (width * (1f - margin)) - seen.Max(p => p.X);
                float top = seen.Min(p => p.Y) - (Height * margin);
                float bottom = (Height * (1f - margin)) - seen.Max(p => p.Y);
                Assert.All(seen, p => Assert.True(p.Z > camera.Near));
                Assert.True(Math.Min(Math.Min(left, right), Math.Min(top, bottom)) > -0.05f, $"{left} {right} {top} {bottom} pixels of room");
                bool touches = Math.Max(Math.Abs(left), Math.Abs(right)) < 0.05f || Math.Max(Math.Abs(top), Math.Abs(bottom)) < 0.05f;
                Assert.True(touches, $"{left} {right} {top} {bottom} pixels of room");
            }
        }
    }

    [Theory]
    [MemberData(nameof(Angles))]
    public void The_target_is_in_the_middle_and_the_axes_are_a_right_handed_frame(double azimuth, double elevation, float aspect)
    {
        Camera camera = Camera.Fit(new CameraAngle(azimuth, elevation), Cloud(1), aspect);
        int width = (int)(Height * aspect);
        Vector3 middle = camera.Project(camera.Target, width, Height);
        Assert.Equal(width / 2f, middle.X, 0.01f);
        Assert.Equal(Height / 2f, middle.Y, 0.01f);
        Assert.Equal(Vec.Distance(camera.Eye, camera.Target), middle.Z, 1e-4f);
        Assert.Equal(1f, Vec.Length(camera.Forward), 1e-5f);
        Assert.Equal(1f, Vec.Length(camera.Right), 1e-5f);
        Assert.True(Vec.Distance(Vec.Cross(camera.Right, camera.Forward), camera.Up) < 1e-5f);
        Assert.Equal(0f, Vec.Dot(camera.Right, camera.Forward), 1e-5f);
        Assert.True(Vec.Distance(camera.Forward, -new CameraAngle(azimuth, elevation).TowardsCamera) < 1e-5f);

        // Within half a degree of straight down or up +Z is upwards, and the frame is as little off level as that.
        Assert.True(Math.Abs(camera.Right.Y) < 0.009f);
        Assert.True(camera.Up.Y > -0.009f);
    }

    [Fact]
    public void A_point_beside_above_and_behind_the_target_is_seen_there()
    {
        var camera = new Camera(new Vector3(0, 0, 10), Vector3.Zero, 90);
        Vector3 close = new(0.01f);
        Assert.True(Vec.Distance(new Vector3(600, 300, 10), camera.Project(new Vector3(10, 0, 0), 600, 600)) < Vec.Length(close));
        Assert.True(Vec.Distance(new Vector3(300, 0, 10), camera.Project(new Vector3(0, 10, 0), 600, 600)) < Vec.Length(close));
        Assert.True(Vec.Distance(new Vector3(450, 300, 20), camera.Project(new Vector3(10, 0, -10), 600, 600)) < Vec.Length(close));
    }

    [Theory]
    [InlineData(View.Front, 1, 0)]
    [InlineData(View.Back, -1, 0)]
    [InlineData(View.Top, -1, 0)]
    [InlineData(View.Side, 0, -1)]
    public void Named_views_turn_the_creature_as_they_say(View view, float rightX, float rightZ)
    {
        Camera camera = Camera.Fit(view, new BoundingBox(-Vector3.One, Vector3.One), 1f);
        Assert.True(Vec.Distance(new Vector3(rightX, 0, rightZ), camera.Right) < 1e-4f, $"right is {camera.Right}");
        if (view == View.Top)
        {
            Assert.True(Vec.Distance(Vector3.UnitZ, camera.Up) < 1e-4f);
        }
    }

    [Theory]
    [InlineData(0.05f)]
    [InlineData(1f)]
    [InlineData(20f)]
    public void A_close_up_has_the_sphere_touch_the_margin(float radius)
    {
        foreach (float aspect in new[] { 0.6f, 1f, 2f })
        {
            var centre = new Vector3(0.3f, 1f, -0.2f);
            Camera camera = Camera.CloseUp(View.ThreeQuarter, centre, radius, aspect, 0.1f);
            int width = (int)(1000 * aspect);

            // The outline of a sphere is the circle in which a cone from the eye touches it.
            double distance = Vec.Distance(camera.Eye, centre);
            double tangent = radius / Math.Sqrt((distance * distance) - (radius * radius));
            double outline = tangent * camera.PixelsPerTangent(1000);
            Assert.Equal(0.4 * Math.Min(width, 1000), outline, 0.5);
        }
    }

    [Fact]
    public void A_long_thin_thing_seen_along_its_length_does_not_reach_into_the_lens()
    {
        Vector3[] points = [new(-0.1f, 0, 0), new(0.1f, 0.1f, -8), new(0, -0.1f, -3)];
        Camera camera = Camera.Fit(new CameraAngle(0, 0), points, 1f);
        Assert.Equal(2f, points.Min(p => camera.Project(p, 100, 100).Z), 1e-4f);
        Assert.All(points, p => Assert.InRange(camera.Project(p, 100, 100).X, 7f, 93f));
    }

    [Fact]
    public void Points_in_one_line_of_sight_or_one_point_alone_are_seen()
    {
        foreach (Vector3[] points in new[] { new[] { Vector3.One }, [Vector3.Zero, new Vector3(0, 0, 3)], [Vector3.Zero, Vector3.Zero] })
        {
            Camera camera = Camera.Fit(new CameraAngle(0, 0), points, 1f);
            foreach (Vector3 point in points)
            {
                Vector3 seen = camera.Project(point, 100, 100);
                Assert.True(seen.Z > camera.Near);
                Assert.Equal(50f, seen.X, 0.1f);
                Assert.Equal(50f, seen.Y, 0.1f);
            }
        }
    }

    [Fact]
    public void Bad_input_is_refused()
    {
        var front = new CameraAngle(0, 0);
        Vector3[] points = [Vector3.One, -Vector3.One];
        Assert.Throws<ArgumentException>(() => Camera.Fit(front, ReadOnlySpan<Vector3>.Empty, 1f));
        Assert.Throws<ArgumentException>(() => Camera.Fit(front, [new Vector3(float.NaN)], 1f));
        Assert.Throws<ArgumentException>(() => Camera.Fit(front, [Vector3.One, new Vector3(0, float.NaN, 0)], 1f));
        Assert.Throws<ArgumentException>(() => Camera.Fit(front, [Vector3.One, new Vector3(float.PositiveInfinity)], 1f));
        Assert.Throws<ArgumentOutOfRangeException>(() => Camera.Fit(front, points, 0f));
        Assert.Throws<ArgumentOutOfRangeException>(() => Camera.Fit(front, points, 1f, 0.5f));
        Assert.Throws<ArgumentOutOfRangeException>(() => Camera.CloseUp(front, Vector3.Zero, 0f, 1f));
        Assert.Throws<ArgumentException>(() => new Camera(Vector3.One, Vector3.One, 30));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Camera(Vector3.Zero, Vector3.One, 170));
    }

    private static Vector3[] Cloud(int seed)
    {
        var random = new Random(seed);
        var size = new Vector3(Side(), Side(), Side());
        var centre = new Vector3(Side(), Side(), Side());
        return Enumerable.Range(0, 50).Select(_ => centre + new Vector3(Place() * size.X, Place() * size.Y, Place() * size.Z)).ToArray();

        float Side() => 0.3f + random.NextSingle();

        float Place() => random.NextSingle() - 0.5f;
    }

    private static TheoryData<double, double, float> MakeAngles()
    {
        var data = new TheoryData<double, double, float>();
        foreach ((double azimuth, double elevation) in new[] { (0.0, 0.0), (38, 14), (90, 6), (180, 6), (-120, -30), (20, 80), (70, 89), (0, 89.6), (0, 90), (45, 90), (0, -90) })
        {
            foreach (float aspect in new[] { 0.5f, 1f, 2f })
            {
                data.Add(azimuth, elevation, aspect);
            }
        }

        return data;
    }
}
