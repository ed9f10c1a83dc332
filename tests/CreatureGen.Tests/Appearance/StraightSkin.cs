using System;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Bodies;
using CreatureGen.Geometry;

namespace CreatureGen.Tests.Appearance;

/// <summary>A straight round body to paint, its nose at z = 1.2, and places on it.</summary>
internal static class StraightSkin
{
    /// <summary>A place on the left side of the body, or of what grows from it.</summary>
    public static VertexAddress Address(SurfaceRegion region, float ring, float segment) =>
        new() { Region = region, Appendage = -1, Sign = 1, Ring = ring, Segment = segment, Around = segment * MathF.PI / 16f };

    /// <summary>The body, with nothing that a coat has to know of.</summary>
    public static CoatSubject Subject()
    {
        var body = new BodyShape();
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            body.Y[i] = 1;
            body.Arc[i] = 0.04 * i;
            body.Z[i] = 1.2 - body.Arc[i];
            body.Width[i] = body.Top[i] = body.Bottom[i] = 0.2;
        }

        return new CoatSubject(body);
    }
}
