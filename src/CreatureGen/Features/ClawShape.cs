using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Claws: hooked cones at the tips of toes.</summary>
internal static class ClawShape
{
    private const int Sides = 5;

    /// <summary>Appends a claw.</summary>
    /// <param name="builder">Where the claw goes.</param>
    /// <param name="toeTip">Centre of the end of the toe, model space, metres.</param>
    /// <param name="direction">Unit direction of the toe's end.</param>
    /// <param name="toeRadius">Radius of the toe's end, metres.</param>
    /// <param name="length">How far the claw reaches beyond the toe, metres; positive.</param>
    /// <param name="floor">No vertex goes below this height, metres; negative infinity for a free toe.</param>
    /// <param name="colour">Linear RGB of its middle.</param>
    public static void Append(PieceBuilder builder, Vector3 toeTip, Vector3 direction, float toeRadius, float length, float floor, Vector3 colour)
    {
        Vector3 up = Vec.Normalize(Vec.Reject(Vector3.UnitY, direction), Vector3.UnitZ);
        Vector3 root = toeTip - (direction * (0.55f * toeRadius)) + (up * (0.12f * toeRadius));
        Vector3 knuckle = root + (direction * (0.62f * (length + toeRadius))) + (up * (0.16f * length));
        Vector3 tip = toeTip + (direction * length) - (up * ((0.18f * length) + (0.30f * toeRadius)));
        Span<TubeRow> rows = stackalloc TubeRow[3];
        for (int i = 0; i < rows.Length; i++)
        {
            float t = 0.40f * i;
            float u = 1f - t;
            Vector3 centre = (root * (u * u)) + (knuckle * (2f * u * t)) + (tip * (t * t));
            float height = toeRadius * 0.84f * (float)PortableMath.Pow(u, 0.72);
            centre.Y = Math.Max(centre.Y, floor + (1.02f * height));
            rows[i] = new TubeRow(centre, height, 0.74f * height, colour * (i == 0 ? 0.7f : 1f));
        }

        tip.Y = Math.Max(tip.Y, floor);
        SweptTube.Append(builder, rows, tip, colour * 0.55f, up, Sides);
    }
}
