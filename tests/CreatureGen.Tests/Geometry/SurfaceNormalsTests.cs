using System.Numerics;
using CreatureGen.Geometry;
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
}
