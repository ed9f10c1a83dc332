using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class VisibilityTests
{
    private static readonly Vector3 red = new(1, 0, 0);
    private static readonly Vector3 green = new(0, 1, 0);
    private static readonly Camera front = new(new Vector3(0, 0, 5), Vector3.Zero, 40);

    [Theory]
    [InlineData(SampleCount.One)]
    [InlineData(SampleCount.Four)]
    [InlineData(SampleCount.Eight)]
    public void A_square_before_the_camera_covers_the_middle_and_not_the_corners(SampleCount samples)
    {
        Picture picture = Renderer.Render(TestMeshes.Square(1, 0, red), front, TestMeshes.Plain with { Samples = samples });
        Assert.Equal(new Pixel(255, 0, 0, 255), picture[32, 32]);
        foreach ((int x, int y) in new[] { (0, 0), (63, 0), (0, 63), (63, 63) })
        {
            Assert.Equal(0, picture[x, y].A);
        }
    }

    [Fact]
    public void A_square_that_fills_the_frame_leaves_no_gap_along_its_diagonal()
    {
        foreach (SampleCount samples in Enum.GetValues<SampleCount>())
        {
            Picture picture = Renderer.Render(TestMeshes.Square(3, 0, red), front, TestMeshes.Plain with { Samples = samples, Width = 101, Height = 77 });
            Assert.All(Enumerable.Range(0, 101 * 77), i => Assert.Equal(new Pixel(255, 0, 0, 255), picture[i % 101, i / 101]));
        }
    }

    [Fact]
    public void Opacity_at_edges_is_the_part_of_the_pixel_that_is_covered()
    {
        // A square of 21.75 pixels, whose area is found again in the sum of opacities.
        var options = TestMeshes.Plain with { Samples = SampleCount.Eight };
        Vector3 side = front.Project(new Vector3(1, 0, 0), 64, 64) - front.Project(Vector3.Zero, 64, 64);
        float half = 21.75f / 2f / side.X;
        Picture picture = Renderer.Render(TestMeshes.Square(half, 0, red), front, options);
        double sum = Enumerable.Range(0, 64 * 64).Sum(i => picture[i % 64, i / 64].A / 255.0);
        Assert.Equal(21.75 * 21.75, sum, 1.0);
    }

    [Fact]
    public void The_nearer_triangle_hides_the_farther_in_either_order()
    {
        RenderMesh near = TestMeshes.Square(0.5f, 1, red);
        RenderMesh far = TestMeshes.Square(1, 0, green);
        foreach (RenderMesh both in new[] { TestMeshes.Together(near, far), TestMeshes.Together(far, near) })
        {
            Picture picture = Renderer.Render(both, front, TestMeshes.Plain);
            Assert.Equal(new Pixel(255, 0, 0), picture[32, 32]);
            Assert.Equal(new Pixel(0, 255, 0), picture[16, 32]);
        }
    }

    [Fact]
    public void Skin_is_not_seen_from_behind_and_membranes_are()
    {
        var behind = new Camera(new Vector3(0, 0, -5), Vector3.Zero, 40);
        Picture skin = Renderer.Render(TestMeshes.Square(1, 0, red), behind, TestMeshes.Plain);
        Assert.All(Enumerable.Range(0, 64 * 64), i => Assert.Equal(0, skin[i % 64, i / 64].A));
        Picture membrane = Renderer.Render(TestMeshes.Square(1, 0, red, Facing.Both), behind, TestMeshes.Plain);
        Assert.Equal(new Pixel(255, 0, 0), membrane[32, 32]);
    }

    [Fact]
    public void The_back_of_a_membrane_is_lit_as_a_front_that_faces_the_camera()
    {
        RenderOptions flat = TestMeshes.Plain with { Shading = ShadingMode.Flat, FlatLightDirection = new Vector3(0, 0, -3) };
        Picture back = Renderer.Render(TestMeshes.Square(1, 0, red, Facing.Both), new Camera(new Vector3(0, 0, -5), Vector3.Zero, 40), flat);
        Picture turnedAway = Renderer.Render(TestMeshes.Square(1, 0, red, Facing.Both), front, flat);
        Assert.Equal(new Pixel(255, 0, 0), back[32, 32]);
        Assert.Equal(new Pixel(0, 0, 0), turnedAway[32, 32]);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2, Explicit = true)]
    [InlineData(3, Explicit = true)]
    public void Every_pixel_shows_what_a_ray_through_its_middle_meets_first(int seed)
    {
        // Triangles of all sizes around the camera's target; some reach behind the camera or pierce each other.
        var random = new Random(seed);
        var corners = new Vector3[60 * 3];
        for (int i = 0; i < corners.Length; i++)
        {
            float spread = i % 9 == 0 ? 9f : 2f;
            corners[i] = new Vector3(Place() * spread, Place() * spread, Place() * spread);
        }

        Vector3[] colours = corners.Select(_ => new Vector3(random.NextSingle(), random.NextSingle(), random.NextSingle())).ToArray();
        RenderMesh mesh = TestMeshes.Soup(corners, i => colours[i], Facing.Both);
        var camera = new Camera(new Vector3(1, 2, 5), new Vector3(0.2f, 0, 0), 50);
        RenderOptions options = TestMeshes.Plain with { Width = 90, Height = 70 };
        Picture picture = Renderer.Render(mesh, camera, options);
        int compared = 0;
        for (int i = 0; i < 90 * 70; i++)
        {
            int x = i % 90;
            int y = i / 90;
            RayHit hit = RayHit.Through(mesh, camera, x + 0.5, y + 0.5, 90, 70);

            // Beside an edge, corners moved to the grid of 1/256 pixel decide.
            const double Beside = 0.02;
            if (new[] { (-Beside, 0.0), (Beside, 0), (0, -Beside), (0, Beside) }.Any(d => RayHit.Through(mesh, camera, x + 0.5 + d.Item1, y + 0.5 + d.Item2, 90, 70).Triangle != hit.Triangle))
            {
                continue;
            }

            compared++;
            Pixel expected = hit.Triangle < 0 ? new Pixel(0, 0, 0, 0) : TestMeshes.Srgb(hit.Colour);
            Pixel seen = picture[x, y];
            Assert.True(
                Math.Abs(expected.R - seen.R) <= 1 && Math.Abs(expected.G - seen.G) <= 1 && Math.Abs(expected.B - seen.B) <= 1 && expected.A == seen.A,
                $"pixel ({x}, {y}) is {seen}; expected {expected} of triangle {hit.Triangle}");
        }

        Assert.True(compared > 90 * 70 * 0.9, $"only {compared} pixels were compared");

        float Place() => random.NextSingle() - 0.5f;
    }

    [Fact]
    public void A_hard_change_of_colour_within_one_smooth_surface_has_a_soft_edge()
    {
        // Two halves of one plane that meet along a slanting line, as the iris and the pupil of an eye do.
        Vector3[] corners = [new(-3, -3, 0), new(3, -3, 0), new(2, 3, 0), new(-3, -3, 0), new(2, 3, 0), new(-3, 3, 0)];
        RenderMesh mesh = TestMeshes.Soup(corners, i => i < 3 ? Vector3.One : Vector3.Zero);
        RenderOptions options = TestMeshes.Plain with { Samples = SampleCount.Eight };
        foreach (ShadingMode shading in new[] { ShadingMode.Unlit, ShadingMode.Smooth })
        {
            Picture picture = Renderer.Render(mesh, front, options with { Shading = shading });
            int bright = picture[63, 63].G;
            int dark = picture[0, 0].G;
            Assert.True(bright > dark + 80);
            int between = Enumerable.Range(0, 64 * 64).Count(i => picture[i % 64, i / 64].G > dark + 20 && picture[i % 64, i / 64].G < bright - 20);
            Assert.InRange(between, 40, 140);
        }
    }
}
