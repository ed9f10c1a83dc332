using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class TriangleCrossingTests
{
    /// <summary>Two sheets that stand across one another, and cut along one of the axes or between all of them.</summary>
    [Theory]
    [InlineData(1f, 0f, 0f)]
    [InlineData(0f, 1f, 0f)]
    [InlineData(0f, 0f, 1f)]
    [InlineData(0.1f, 0.2f, 1f)]
    [InlineData(1f, -0.9f, 0.8f)]
    public void Sheets_that_cut_along_any_line_cross(float x, float y, float z)
    {
        Vector3 line = Vec.Normalize(new Vector3(x, y, z), Vector3.UnitX);
        Vector3 up = Vec.Perpendicular(line);
        Vector3 aside = Vec.Cross(line, up);
        Assert.True(Cross(line, up, aside, 0f));
        Assert.False(Cross(line, up, aside, 2.1f));

        // Of the second only a corner touches the first, from the side that is in front of it.
        Assert.False(TriangleCrossing.Cross(-line, line, up, 0.2f * up, (0.2f * up) + aside + line, (0.2f * up) + aside - line, 1e-6));
    }

    private static bool Cross(Vector3 line, Vector3 up, Vector3 aside, float along) =>
        TriangleCrossing.Cross(-line - up, line - up, up, (along * line) - line - aside, (along * line) + line - aside, (along * line) + aside, 1e-6);
}
