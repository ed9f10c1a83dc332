using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>A triangle one corner of which is pulled to another place.</summary>
internal static class CornerPull
{
    /// <summary>Cosine of the largest turn of a triangle in one step: about 70°.</summary>
    private const double MinTurn = 0.35;

    /// <summary>Twice the area of a triangle relative to the square of its longest edge: thinner ones are only made of those that are as thin.</summary>
    private const double MinShape = 0.06;

    /// <summary>Whether the triangle turns far, away from the normals of its corners, or into a sliver.</summary>
    /// <param name="before">Where the corner is.</param>
    /// <param name="after">Where it is pulled to.</param>
    /// <param name="a">The corner after it.</param>
    /// <param name="b">The corner before it.</param>
    /// <param name="facingBefore">Sum of the normals of the corners as it is.</param>
    /// <param name="facingAfter">Sum of the normals of the corners as it is to be.</param>
    public static bool Spoils(Vector3 before, Vector3 after, Vector3 a, Vector3 b, Vector3 facingBefore, Vector3 facingAfter)
    {
        Vector3 old = Vec.Cross(a - before, b - before);
        Vector3 turned = Vec.Cross(a - after, b - after);
        double oldLength = Vec.Length(old);
        double newLength = Vec.Length(turned);
        double shape = Math.Min(MinShape, 0.9 * oldLength / Longest(before, a, b));
        bool turnsAway = Vec.Dot(turned, facingAfter) <= 0f && Vec.Dot(old, facingBefore) > 0f;
        return turnsAway || !(newLength > shape * Longest(after, a, b)) || !(Vec.Dot(old, turned) > MinTurn * oldLength * newLength);
    }

    private static double Longest(Vector3 a, Vector3 b, Vector3 c) =>
        Math.Max(Vec.LengthSquared(a - b), Math.Max(Vec.LengthSquared(b - c), Vec.LengthSquared(c - a)));
}
