using System;
using System.Numerics;

namespace CreatureGen.Tests.Features;

internal static class RayCast
{
    /// <summary>Möller and Trumbore 1997, both sides of the triangle.</summary>
    public static bool Hit(Vector3 origin, Vector3 direction, Vector3 a, Vector3 b, Vector3 c, out float distance, out float u, out float v)
    {
        Vector3 e1 = b - a;
        Vector3 e2 = c - a;
        Vector3 p = Vector3.Cross(direction, e2);
        float det = Vector3.Dot(e1, p);
        distance = u = v = 0f;
        if (Math.Abs(det) < 1e-12f)
        {
            return false;
        }

        Vector3 s = origin - a;
        u = Vector3.Dot(s, p) / det;
        Vector3 q = Vector3.Cross(s, e1);
        v = Vector3.Dot(direction, q) / det;
        distance = Vector3.Dot(e2, q) / det;
        return u >= 0f && v >= 0f && u + v <= 1f && distance > 0f;
    }
}
