using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class TextureTests
{
    private static readonly Camera front = new(new Vector3(0, 0, 5), Vector3.Zero, 40);

    [Fact]
    public void A_square_shows_its_texture_the_right_way_up()
    {
        var picture = new Picture(2, 2, PixelLayout.Rgb)
        {
            [0, 0] = new Pixel(250, 10, 20),
            [1, 0] = new Pixel(30, 240, 40),
            [0, 1] = new Pixel(50, 60, 230),
            [1, 1] = new Pixel(200, 210, 70),
        };
        float half = HalfOfPixels(32);
        Picture seen = Renderer.Render(Textured(half, picture), front, TestMeshes.Plain);

        // Outside the middles of the texels, which are at 24 and 40, there is one colour alone.
        foreach ((int x, int y) in new[] { (0, 0), (1, 0), (0, 1), (1, 1) })
        {
            Pixel expected = picture[x, y];
            Pixel found = seen[x == 0 ? 20 : 43, y == 0 ? 20 : 43];
            Assert.True(Math.Abs(expected.R - found.R) <= 1 && Math.Abs(expected.G - found.G) <= 1 && Math.Abs(expected.B - found.B) <= 1, $"{found}; expected {expected}");
        }
    }

    [Fact]
    public void One_texel_per_pixel_is_copied()
    {
        var random = new Random(5);
        var picture = new Picture(40, 40, PixelLayout.Rgb);
        for (int y = 0; y < 40; y++)
        {
            random.NextBytes(picture.Row(y));
        }

        Picture seen = Renderer.Render(Textured(HalfOfPixels(40), picture), front, TestMeshes.Plain);
        for (int y = 0; y < 40; y++)
        {
            for (int x = 0; x < 40; x++)
            {
                Pixel expected = picture[x, y];
                Pixel found = seen[x + 12, y + 12];
                Assert.True(Math.Abs(expected.R - found.R) <= 2 && Math.Abs(expected.G - found.G) <= 2 && Math.Abs(expected.B - found.B) <= 2, $"({x}, {y}) is {found}; expected {expected}");
            }
        }
    }

    [Fact]
    public void A_fine_chequerboard_seen_from_afar_is_even_grey()
    {
        var picture = new Picture(256, 256, PixelLayout.Rgb);
        for (int i = 0; i < 256 * 256; i++)
        {
            picture[i % 256, i / 256] = ((i % 256) + (i / 256)) % 2 == 0 ? new Pixel(255, 255, 255) : new Pixel(0, 0, 0);
        }

        Picture seen = Renderer.Render(Textured(HalfOfPixels(32), picture), front, TestMeshes.Plain);
        byte grey = TestMeshes.Srgb(0.5);
        for (int i = 0; i < 30 * 30; i++)
        {
            Assert.InRange(seen[17 + (i % 30), 17 + (i / 30)].G, grey - 1, grey + 1);
        }
    }

    [Theory]
    [InlineData(-3f, 0)]
    [InlineData(0f, 0)]
    [InlineData(1f, 2)]
    [InlineData(9f, 2)]
    public void Beyond_the_edge_its_colour_goes_on(float u, int column)
    {
        var picture = new Picture(3, 1, PixelLayout.Rgba) { [0, 0] = new Pixel(10, 20, 30), [1, 0] = new Pixel(99, 99, 99), [2, 0] = new Pixel(200, 100, 50, 0) };
        Assert.Equal(picture[column, 0] with { A = 255 }, TestMeshes.Srgb(new Texture(picture).Sample(u, 0.5f, 0)));
    }

    [Fact]
    public void The_smallest_copy_is_the_mean()
    {
        var picture = new Picture(8, 4, PixelLayout.Rgb);
        picture.Fill(new Pixel(255, 255, 255), 0, 0, 4, 4);
        var texture = new Texture(picture);
        Assert.Equal(0.5f, texture.Sample(0.1f, 0.9f, 99).X, 1e-6f);
    }

    [Fact]
    public void A_texture_without_coordinates_is_refused() =>
        Assert.Throws<ArgumentException>(() => TestMeshes.Square(1, 0, Vector3.One).WithTexture(new Texture(new Picture(1, 1, PixelLayout.Rgb))));

    [Fact]
    public void A_normal_map_without_coordinates_is_refused()
    {
        RenderMesh square = TestMeshes.Square(1, 0, Vector3.One);
        var level = new Texture([128, 128, 255], 1, 1, TexelMeaning.Number);
        Assert.Throws<ArgumentException>(() => new RenderMesh(square.Positions.ToArray(), square.Normals.ToArray(), square.Colours.ToArray(), square.Triangles.ToArray(), square.Parts, normalMap: level));
    }

    [Theory]
    [InlineData(1, 0, TexelMeaning.Colour, 2)]
    [InlineData(0, 1, TexelMeaning.Colour, 0)]
    [InlineData(2, 2, TexelMeaning.Number, 11)]
    public void Bytes_that_do_not_fit_the_size_are_refused(int width, int height, TexelMeaning meaning, int length) =>
        Assert.Throws<ArgumentException>(() => new Texture(new byte[length], width, height, meaning));

    [Fact]
    public void Vertex_colours_tint_the_texture()
    {
        var half = new Picture(1, 1, PixelLayout.Rgb) { [0, 0] = new Pixel(TestMeshes.Srgb(0.5), 255, 0) };
        RenderMesh mesh = Textured(HalfOfPixels(32), half);
        var tinted = new RenderMesh(mesh.Positions.ToArray(), mesh.Normals.ToArray(), mesh.Positions.ToArray().Select(_ => new Vector3(0.5f, 0.25f, 1f)).ToArray(), mesh.Triangles.ToArray(), mesh.Parts, null, mesh.Texcoords.ToArray(), mesh.Texture);
        Pixel seen = Renderer.Render(tinted, front, TestMeshes.Plain)[32, 32];
        Assert.InRange(seen.R, TestMeshes.Srgb(0.25) - 1, TestMeshes.Srgb(0.25) + 1);
        Assert.Equal((TestMeshes.Srgb(0.25), (byte)0), (seen.G, seen.B));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(-1, 0)]
    [InlineData(0, 1)]
    public void A_normal_map_turns_the_normal_to_the_right_with_red_and_upwards_with_green(int right, int up)
    {
        // As glTF has it. The surface is brighter under the map that turns it to the light, which stands at the side or above.
        RenderMesh plain = TestMeshes.Square(1, 0, new Vector3(0.4f));
        Vector2[] places = plain.Positions.ToArray().Select(p => new Vector2((p.X + 1) / 2, (1 - p.Y) / 2)).ToArray();
        Lighting lamp = Lighting.Studio with { KeyDirection = new Vector3(right, 0.5f + up, 1.2f), Sky = Vector3.Zero, Bounce = Vector3.Zero, Fill = Vector3.Zero, Rim = Vector3.Zero };
        var level = new Camera(new Vector3(0, 0, 5), Vector3.Zero, 40);
        int towards = Brightness(right, up);
        int away = Brightness(-right, -up);
        Assert.True(towards > away + 10, $"{towards} towards the light and {away} away from it");

        int Brightness(int x, int y)
        {
            var map = new Texture([(byte)(128 + (70 * x)), (byte)(128 + (70 * y)), 230], 1, 1, TexelMeaning.Number);
            var mesh = new RenderMesh(plain.Positions.ToArray(), plain.Normals.ToArray(), plain.Colours.ToArray(), plain.Triangles.ToArray(), plain.Parts, null, places, null, map);
            return Renderer.Render(mesh, level, TestMeshes.Plain with { Shading = ShadingMode.Smooth, Lighting = lamp })[32, 32].G;
        }
    }

    private static RenderMesh Textured(float half, Picture picture)
    {
        RenderMesh square = TestMeshes.Square(half, 0, Vector3.One);
        Vector2[] places = square.Positions.ToArray().Select(p => new Vector2(((p.X / half) + 1) / 2, (1 - (p.Y / half)) / 2)).ToArray();
        return new RenderMesh(square.Positions.ToArray(), square.Normals.ToArray(), square.Colours.ToArray(), square.Triangles.ToArray(), square.Parts, null, places, new Texture(picture));
    }

    // Half the side of a square at z = 0 that is seen as so many pixels of 64.
    private static float HalfOfPixels(int pixels) => pixels * 0.5f / (front.Project(Vector3.UnitX, 64, 64).X - 32f);
}
