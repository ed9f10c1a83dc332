using System.Numerics;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class InertiaTests
{
    /// <summary>The corner of a box, cut off: legs a, b and c along the axes, wherever it is. ∫xy about the centroid is −a²b²c/480, and so on.</summary>
    [Theory]
    [InlineData(0f, 0f, 0f)]
    [InlineData(5f, -3f, 2f)]
    public void Products_and_moments_of_a_skew_body_are_those_of_the_textbook(float x, float y, float z)
    {
        const double A = 1;
        const double B = 2;
        const double C = 3;
        var o = new Vector3(x, y, z);
        Vector3[] corners = { o, o + new Vector3((float)A, 0, 0), o + new Vector3(0, (float)B, 0), o + new Vector3(0, 0, (float)C) };
        SolidProperties body = SolidProperties.Of(corners, [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
        Assert.Equal(A * B * C / 6, body.Volume, 1e-6);
        Assert.True(Vector3.Distance(o + new Vector3((float)A / 4, (float)B / 4, (float)C / 4), body.Centroid) < 1e-5f);
        Assert.Equal(A * A * B * B * C / 480, body.InertiaXY, 1e-5);
        Assert.Equal(A * B * B * C * C / 480, body.InertiaYZ, 1e-5);
        Assert.Equal(A * A * B * C * C / 480, body.InertiaZX, 1e-5);
        Assert.Equal(A * B * C * ((B * B) + (C * C)) / 160, body.InertiaXX, 1e-5);
        Assert.Equal(A * B * C * ((C * C) + (A * A)) / 160, body.InertiaYY, 1e-5);
        Assert.Equal(A * B * C * ((A * A) + (B * B)) / 160, body.InertiaZZ, 1e-5);
    }
}
