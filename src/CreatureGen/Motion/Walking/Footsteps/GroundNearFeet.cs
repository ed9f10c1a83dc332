using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Ground that feet find around where they stand at rest, however little of it there is below the body itself: stones, beams, the edges of a gap.</summary>
internal static class GroundNearFeet
{
    /// <summary>How far from its home a foot looks, leg lengths, and in how many directions.</summary>
    private static readonly float[] rings = { 0.2f, 0.4f, 0.6f };
    private const int Directions = 8;

    /// <summary>How many places of these a body is carried by; the others it has to come to.</summary>
    private const int Near = 1 + (2 * Directions);

    private static readonly Vector3[] around = Around();

    /// <summary>Whether a foot finds ground where it stands at rest, beside that or ahead of it.</summary>
    /// <param name="body">Whose foot.</param>
    /// <param name="leg">Which.</param>
    /// <param name="direction">Where it goes, model space.</param>
    /// <param name="range">Where ground is looked for.</param>
    public static bool Reaches(LeggedBody body, int leg, Vector3 direction, in GroundRange range)
    {
        Vector3 home = body.Legs[leg].Home;
        for (int i = 0; i < around.Length; i++)
        {
            if (Vec.Dot(around[i], direction) >= 0f && range.Has(home + (around[i] * body.LegLength), out _))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Spreads a footing over all ground that feet find there, until it carries the body.</summary>
    /// <param name="body">Whose feet.</param>
    /// <param name="range">Where ground is looked for.</param>
    /// <param name="spread">What is known of it already.</param>
    /// <param name="height">The highest of it, metres of the model above the root.</param>
    /// <returns>Whether it carries the body.</returns>
    public static bool Carries(LeggedBody body, in GroundRange range, ref FootingSpread spread, out float height)
    {
        height = float.MinValue;
        for (int i = 0; i < Near; i++)
        {
            foreach (LegRig leg in body.Legs)
            {
                Vector3 place = leg.Home + (around[i] * body.LegLength);
                if (range.Has(place, out float there))
                {
                    spread.Add(place);
                    height = Math.Max(height, there);
                }
            }

            if (spread.Carries(body))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The home itself, and rings around it, leg lengths: the nearest first.</summary>
    private static Vector3[] Around()
    {
        var places = new Vector3[1 + (rings.Length * Directions)];
        for (int i = 1; i < places.Length; i++)
        {
            double angle = 2 * Math.PI * (i - 1) / Directions;
            PortableMath.SinCos(angle, out double sine, out double cosine);
            places[i] = new Vector3((float)sine, 0f, (float)cosine) * rings[(i - 1) / Directions];
        }

        return places;
    }
}
