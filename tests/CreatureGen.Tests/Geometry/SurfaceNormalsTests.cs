using System;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class SurfaceNormalsTests
{
    /// <summary>A sliver whose height is rounding looks anywhere: it must not tilt what is beside it.</summary>
    [Fact]
    public void A_sliver_of_nearly_no_area_does_not_tilt_the_normals_of_its_corners()
    {
        Vector3[] positions = [new(0, 0, 0), new(1, 0, 0), new(0, 0, -1), new(0.5f, 1e-12f, 0f)];
        var normals = new Vector3[4];
        SurfaceNormals.Smooth(positions, [0, 1, 2, 0, 3, 1], normals);
        Assert.Equal(Vector3.UnitY, normals[0]);
        Assert.Equal(Vector3.UnitY, normals[1]);
    }

    [Fact]
    public void Angles_and_not_areas_weigh_the_triangles_at_a_corner()
    {
        // A cube's corner: one of its three faces is cut into two triangles there.
        Vector3[] positions = [new(0, 0, 0), new(1, 0, 0), new(1, 0, 1), new(0, 0, 1), new(0, 1, 0)];
        var normals = new Vector3[5];
        SurfaceNormals.Smooth(positions, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1], normals);
        Vector3 diagonal = -Vector3.Normalize(Vector3.One);
        Assert.True(Vector3.Distance(diagonal, normals[0]) < 1e-4f, normals[0].ToString());
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void Normals_of_a_mirrored_surface_are_the_same_bits_whether_one_side_is_copied_or_not(RequestedKind kind)
    {
        for (ulong seed = 40; seed < 46; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind })).Surface;
            var whole = new Vector3[surface.Positions.Length];
            var copied = new Vector3[surface.Positions.Length];
            SurfaceNormals.Smooth(surface.Positions, surface.Triangles, whole);
            SurfaceNormals.Smooth(surface.Positions, surface.Triangles, surface.Mirror, copied);
            Assert.Equal(MemoryMarshal.AsBytes(whole.AsSpan()).ToArray(), MemoryMarshal.AsBytes(copied.AsSpan()).ToArray());
        }
    }

    [Fact]
    public void Mirror_images_that_are_not_one_per_vertex_are_refused()
    {
        Vector3[] positions = [new(0, 0, 0), new(1, 0, 0), new(0, 0, -1)];
        Assert.StartsWith("2 mirror images; expected 3", Assert.Throws<ArgumentException>(() => SurfaceNormals.Smooth(positions, [0, 1, 2], [0, 1], new Vector3[3])).Message, StringComparison.Ordinal);
    }
}
