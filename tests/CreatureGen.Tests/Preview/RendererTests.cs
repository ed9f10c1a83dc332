using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class RendererTests
{
    private static readonly Camera front = new(new Vector3(0, 1, 5), Vector3.Zero, 40);

    [Theory]
    [InlineData(ShadingMode.Smooth)]
    [InlineData(ShadingMode.Faceted)]
    [InlineData(ShadingMode.Flat)]
    [InlineData(ShadingMode.Unlit)]
    public void A_picture_is_the_same_for_any_number_of_threads(ShadingMode shading)
    {
        RenderMesh mesh = RenderMesh.From(PreviewSubjects.Of(1));
        Camera camera = Camera.Fit(Views.Angle(View.ThreeQuarter), mesh.Positions, 1.3f);
        RenderOptions options = new() { Width = 182, Height = 140, Shading = shading };
        byte[] one = Renderer.Render(mesh, camera, options).Bytes.ToArray();
        foreach (int threads in new[] { 2, 3, 16 })
        {
            Assert.Equal(one, Renderer.Render(mesh, camera, options with { Threads = threads }).Bytes.ToArray());
        }
    }

    [Theory]
    [InlineData(ShadingMode.Smooth)]
    [InlineData(ShadingMode.Faceted)]
    [InlineData(ShadingMode.Flat)]
    [InlineData(ShadingMode.Unlit)]
    public void Triangles_without_area_change_nothing(ShadingMode shading)
    {
        RenderMesh square = TestMeshes.Square(1, 0, Vector3.One);
        Vector3 a = square.Positions[0];
        Vector3 b = square.Positions[2];
        RenderMesh empty = TestMeshes.Soup([a, a, a, a, b, b, a, b, (a + b) * 0.5f, b, a, b], _ => new Vector3(1, 0, 0), Facing.Both);
        RenderOptions options = new() { Width = 90, Height = 80, Shading = shading };
        Assert.Equal(
            Renderer.Render(square, front, options).Bytes.ToArray(),
            Renderer.Render(TestMeshes.Together(square, empty), front, options).Bytes.ToArray());
    }

    [Theory]
    [InlineData(ShadingMode.Smooth)]
    [InlineData(ShadingMode.Faceted)]
    [InlineData(ShadingMode.Flat)]
    [InlineData(ShadingMode.Unlit)]
    public void A_mesh_of_nothing_shows_the_bare_studio(ShadingMode shading)
    {
        var nothing = new RenderMesh([], [], [], [], []);
        RenderMesh point = TestMeshes.Soup([Vector3.Zero, Vector3.Zero, Vector3.Zero], _ => Vector3.One);
        foreach (RenderMesh mesh in new[] { nothing, point })
        {
            foreach (GroundKind ground in Enum.GetValues<GroundKind>())
            {
                RenderOptions options = new() { Width = 33, Height = 31, Shading = shading, Ground = ground };
                Picture studio = Renderer.Render(mesh, front, options);
                Assert.All(Enumerable.Range(0, 33 * 31), i => Assert.InRange(studio[i % 33, i / 33].G, 120, 240));
                Picture clear = Renderer.Render(mesh, front, options with { Backdrop = BackdropKind.Transparent });
                Assert.All(Enumerable.Range(0, 33 * 31), i => Assert.Equal(0, clear[i % 33, i / 33].A));
            }
        }
    }

    [Theory]
    [InlineData(1 / 64f)]
    [InlineData(1 / 16f)]
    [InlineData(16f)]
    public void A_larger_or_smaller_creature_gives_the_same_picture(float scale)
    {
        foreach (ulong seed in new ulong[] { 1, 3 })
        {
            RenderMesh mesh = RenderMesh.From(PreviewSubjects.Of(seed));
            RenderMesh scaled = TestMeshes.Scaled(mesh, scale);
            RenderOptions options = new() { Width = 150, Height = 150 };
            Picture expected = Renderer.Render(mesh, Camera.Fit(Views.Angle(View.ThreeQuarter), mesh.Positions, 1f), options);
            Picture found = Renderer.Render(scaled, Camera.Fit(Views.Angle(View.ThreeQuarter), scaled.Positions, 1f), options);
            Assert.InRange(TestMeshes.LargestDifference(expected, found), 0, 2);
        }
    }

    [Fact]
    public void A_mirrored_creature_has_the_mirrored_outline_from_the_front()
    {
        foreach (ulong seed in new ulong[] { 1, 2, 3, 5 })
        {
            // One side grows, so that a picture that only shows symmetry would be caught.
            RenderMesh mesh = RenderMesh.From(PreviewSubjects.Of(seed));
            mesh = TestMeshes.Together(mesh, TestMeshes.Soup([mesh.Bounds.Centre, mesh.Bounds.Max, mesh.Bounds.Max - new Vector3(0, mesh.Bounds.Size.Y * 0.3f, 0)], _ => Vector3.One, Facing.Both));
            RenderMesh mirrored = TestMeshes.Mirrored(mesh);
            RenderOptions options = TestMeshes.Plain with { Width = 200, Height = 200 };
            Picture right = Renderer.Render(mesh, Camera.Fit(Views.Angle(View.Front), mesh.Positions, 1f), options);
            Picture left = Renderer.Render(mirrored, Camera.Fit(Views.Angle(View.Front), mirrored.Positions, 1f), options);
            int covered = 0;
            int different = 0;
            int asymmetric = 0;
            for (int i = 0; i < 200 * 200; i++)
            {
                int x = i % 200;
                int y = i / 200;
                covered += right[x, y].A > 0 ? 1 : 0;
                different += right[x, y].A != left[199 - x, y].A ? 1 : 0;
                asymmetric += right[x, y].A != right[199 - x, y].A ? 1 : 0;
            }

            // Middles of pixels that lie on an edge belong to its left side in both.
            Assert.True(different <= 3, $"{different} of {covered} pixels differ");
            Assert.True(asymmetric > 100);
        }
    }

    [Fact]
    public void A_square_above_the_floor_throws_its_shadow_on_it()
    {
        // Lies level, half a metre up.
        RenderMesh plate = TestMeshes.Soup([new(-0.5f, 0.5f, -0.5f), new(-0.5f, 0.5f, 0.5f), new(0.5f, 0.5f, 0.5f), new(-0.5f, 0.5f, -0.5f), new(0.5f, 0.5f, 0.5f), new(0.5f, 0.5f, -0.5f)], _ => Vector3.One);
        var camera = new Camera(new Vector3(0, 4, 5), Vector3.Zero, 40);
        RenderOptions options = new() { Width = 120, Height = 120, Lighting = Lighting.Studio with { KeyDirection = new Vector3(-1, 1, 0) } };
        Picture with = Renderer.Render(plate, camera, options);
        Picture without = Renderer.Render(plate, camera, options with { Ground = GroundKind.None });
        Vector3 shadow = camera.Project(new Vector3(0.6f, 0, 0), 120, 120);
        Vector3 open = camera.Project(new Vector3(-1.5f, 0, 0), 120, 120);
        Assert.True(with[(int)shadow.X, (int)shadow.Y].G < without[(int)shadow.X, (int)shadow.Y].G - 30);
        Assert.InRange(without[(int)open.X, (int)open.Y].G - with[(int)open.X, (int)open.Y].G, 0, 8);
    }

    [Fact]
    public void A_ball_has_no_stripes_of_its_own_shadow()
    {
        // Along the light's great circle brightness may only fall from the brightest place on.
        RenderMesh ball = Ball(48, 96);
        var camera = new Camera(new Vector3(0, 0, 8), Vector3.Zero, 24);
        RenderOptions options = new() { Width = 512, Height = 512, Ground = GroundKind.None, Lighting = Lighting.Studio with { KeyDirection = new Vector3(-1, 0.7f, 0.5f), Rim = Vector3.Zero } };
        Picture picture = Renderer.Render(ball, camera, options);
        foreach (int y in new[] { 220, 256, 300 })
        {
            int[] row = Enumerable.Range(0, 512).Where(x => Distance(x, y) < 130).Select(x => (int)picture[x, y].G).ToArray();
            int brightest = Array.IndexOf(row, row.Max());
            for (int i = brightest + 1; i < row.Length; i++)
            {
                Assert.True(row[i] <= row[i - 1] + 2, $"row {y}: {row[i - 1]} and then {row[i]} at {i} of {row.Length}");
            }
        }

        static double Distance(int x, int y) => Math.Sqrt(((x - 255.5) * (x - 255.5)) + ((y - 255.5) * (y - 255.5)));
    }

    [Fact]
    public void Options_out_of_range_are_refused()
    {
        RenderMesh square = TestMeshes.Square(1, 0, Vector3.One);
        foreach (RenderOptions bad in new RenderOptions[]
        {
            new() { Width = 0 },
            new() { Height = 8193 },
            new() { Threads = 0 },
            new() { Opacity = 1.1f },
            new() { Opacity = float.NaN },
            new() { Samples = (SampleCount)3 },
        })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => Renderer.Render(square, front, bad));
        }
    }

    private static RenderMesh Ball(int rings, int segments)
    {
        var points = new Vector3[(rings + 1) * segments];
        for (int i = 0; i < points.Length; i++)
        {
            double latitude = Math.PI * (i / segments) / rings;
            double longitude = 2 * Math.PI * (i % segments) / segments;
            points[i] = new Vector3((float)(Math.Sin(latitude) * Math.Sin(longitude)), (float)Math.Cos(latitude), (float)(Math.Sin(latitude) * Math.Cos(longitude)));
        }

        int[] triangles = Enumerable.Range(0, rings * segments).SelectMany(i =>
        {
            int next = (i / segments * segments) + ((i + 1) % segments);
            return new[] { i, i + segments, next + segments, i, next + segments, next };
        }).ToArray();
        return new RenderMesh(points, [.. points], points.Select(_ => new Vector3(0.4f)).ToArray(), triangles, [new RenderPart(new SurfaceMaterial(Facing.Front, 0f, 0f), 0, triangles.Length)]);
    }
}
