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
        double oldSquare = Vec.LengthSquared(old);
        double square = Vec.LengthSquared(turned);

        // Squares of lengths say the same as lengths and cost no roots.
        double longest = Longest(after, a, b);
        double longestSquare = longest * longest;
        double oldLongest = Longest(before, a, b);
        bool isSliver = !(square > MinShape * MinShape * longestSquare) && !(square * oldLongest * oldLongest > 0.81 * oldSquare * longestSquare);
        bool turnsAway = Vec.Dot(turned, facingAfter) <= 0f && Vec.Dot(old, facingBefore) > 0f;
        double turn = Vec.Dot(old, turned);
        return turnsAway || isSliver || !(turn > 0 && turn * turn > MinTurn * MinTurn * oldSquare * square);
    }

    private static float Longest(Vector3 a, Vector3 b, Vector3 c) =>
        Math.Max(Vec.LengthSquared(a - b), Math.Max(Vec.LengthSquared(b - c), Vec.LengthSquared(c - a)));
}
