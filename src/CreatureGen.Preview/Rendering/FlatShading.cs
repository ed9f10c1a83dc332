using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// Low-poly shading with one colour per face: ((ddx × ddy) · lightDirection) · materialColour, where ddx and ddy are the changes of the
/// position across the picture, rightwards and upwards, and their product is taken at unit length.
/// </summary>
/// <remarks>
/// Within a face both changes lie in its plane, so that their product is the face's normal; a face turned away from the light is black.
/// Based on: Christo 2022, "Procedural Creature Generation and Animation for Games".
/// </remarks>
public static class FlatShading
{
    /// <summary>The colour of a face.</summary>
    /// <param name="ddx">Change of the position per pixel to the right.</param>
    /// <param name="ddy">Change of the position per pixel upwards.</param>
    /// <param name="lightDirection">Direction to the light, any length but zero.</param>
    /// <param name="materialColour">Linear RGB.</param>
    /// <returns>Linear RGB.</returns>
    public static Vector3 Colour(Vector3 ddx, Vector3 ddy, Vector3 lightDirection, Vector3 materialColour) =>
        Lit(Vec.Normalize(Vec.Cross(ddx, ddy), Vector3.UnitY), lightDirection, materialColour);

    /// <summary>The same for a face whose unit normal, turned to the viewer, is known.</summary>
    internal static Vector3 Lit(Vector3 normal, Vector3 lightDirection, Vector3 materialColour) =>
        materialColour * Math.Max(0f, Vec.Dot(normal, Vec.Normalize(lightDirection, Vector3.UnitY)));

    /// <summary>The unit normal of the side on which the corners run counter-clockwise; +Y for a triangle without area.</summary>
    internal static Vector3 FaceNormal(Vector3 a, Vector3 b, Vector3 c)
    {
        // At unit size first: the product of short edges would be lost below the tolerance.
        Vector3 ab = Vec.Normalize(b - a, Vector3.Zero);
        Vector3 ac = Vec.Normalize(c - a, Vector3.Zero);
        return Vec.Normalize(Vec.Cross(ab, ac), Vector3.UnitY);
    }
}
