using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class FlatShadingTests
{
    private static readonly Vector3 material = new(0.8f, 0.4f, 0.2f);

    [Fact]
    public void A_face_at_60_degrees_to_the_light_has_half_its_colour()
    {
        // The light stands 60° above the z axis; the face looks along it.
        var light = new Vector3(0, MathF.Sqrt(3) / 2, 0.5f);
        Vector3 colour = FlatShading.Colour(Vector3.UnitX, Vector3.UnitY, light, material);
        Assert.True(Vec.Distance(material * 0.5f, colour) < 1e-6f);
    }

    [Fact]
    public void A_face_turned_away_is_black_and_lengths_do_not_count()
    {
        Assert.Equal(Vector3.Zero, FlatShading.Colour(Vector3.UnitY, Vector3.UnitX, Vector3.UnitZ, material));
        Vector3 unit = FlatShading.Colour(Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, material);
        Vector3 scaled = FlatShading.Colour(Vector3.UnitX * 0.01f, Vector3.UnitY * 0.02f, Vector3.UnitZ * 7f, material);
        Assert.True(Vec.Distance(unit, scaled) < 1e-6f);
    }

    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(0.3f, 2, 1)]
    [InlineData(-1, 0.5f, 2)]
    public void A_picture_has_in_each_pixel_the_product_of_the_changes_across_it_times_light_times_material(float x, float y, float z)
    {
        var light = new Vector3(x, y, z);
        RenderMesh mesh = TestMeshes.Soup([new(-2, -2, 0.7f), new(2, -1.5f, -0.4f), new(0.3f, 2, -1)], _ => material);
        var camera = new Camera(new Vector3(0.5f, 1, 6), Vector3.Zero, 40);
        Picture picture = Renderer.Render(mesh, camera, TestMeshes.Plain with { Shading = ShadingMode.Flat, FlatLightDirection = light });
        foreach ((int px, int py) in new[] { (32, 32), (28, 40), (36, 36) })
        {
            Vector3 here = Seen(0, 0);
            Vector3 ddx = Seen(1, 0) - here;
            Vector3 ddy = Seen(0, -1) - here;
            Pixel expected = TestMeshes.Srgb(FlatShading.Colour(ddx, ddy, light, material));
            Pixel found = picture[px, py];
            Assert.True(Math.Abs(expected.R - found.R) <= 1 && Math.Abs(expected.G - found.G) <= 1 && Math.Abs(expected.B - found.B) <= 1, $"{found}; expected {expected}");

            Vector3 Seen(int dx, int dy)
            {
                RayHit hit = RayHit.Through(mesh, camera, px + dx + 0.5, py + dy + 0.5, 64, 64);
                Assert.Equal(0, hit.Triangle);
                return hit.Point;
            }
        }
    }

    [Fact]
    public void A_face_has_one_colour_even_where_its_corners_differ()
    {
        RenderMesh mesh = TestMeshes.Soup([new(-2, -2, 0), new(2, -2, 0), new(0, 2, 0)], i => i == 0 ? new Vector3(0.9f, 0, 0) : i == 1 ? new Vector3(0, 0.6f, 0) : Vector3.Zero);
        Picture picture = Renderer.Render(mesh, new Camera(new Vector3(0, 0, 6), Vector3.Zero, 40), TestMeshes.Plain with { Shading = ShadingMode.Flat, FlatLightDirection = Vector3.UnitZ });
        var mean = new Pixel(TestMeshes.Srgb(0.3), TestMeshes.Srgb(0.2), 0);
        int covered = 0;
        for (int i = 0; i < 64 * 64; i++)
        {
            Pixel seen = picture[i % 64, i / 64];
            if (seen.A > 0)
            {
                covered++;
                Assert.Equal(mean, seen);
            }
        }

        Assert.True(covered > 500);
    }
}
