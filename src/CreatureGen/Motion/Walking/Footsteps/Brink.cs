using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Holes without a bottom, before which a body stops by itself. Lower ground is none: who goes over an edge that has some below it comes down there.</summary>
internal static class Brink
{
    /// <summary>How far beyond the place where it could still stop a body looks, leg lengths.</summary>
    private const float Margin = 0.12f;

    /// <summary>How far behind the foremost other feet lead the way too, leg lengths.</summary>
    private const float Leading = 0.15f;

    /// <summary>How far below it there is to be ground, leg lengths, and where rays begin above it; on a slope these begin higher by the way.</summary>
    private const float Deepest = 60f;
    private const float Above = 0.8f;

    /// <summary>Whether the feet that lead the way would find no ground where a body comes to rest that stops at once.</summary>
    /// <param name="body">The body.</param>
    /// <param name="root">Where it is.</param>
    /// <param name="velocity">How it goes.</param>
    /// <param name="asked">Where it is asked to go, model space; of any length.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it goes on.</param>
    public static bool IsAhead(LeggedBody body, in RootPlace root, in RootVelocity velocity, Vector3 asked, Vector3 up, IGround ground)
    {
        if (ground is IPlaneGround || Vec.LengthSquared(asked) == 0f)
        {
            return false;
        }

        Vector3 way = velocity.StoppingWay();
        float margin = Margin * body.LegLength;
        Vector3 direction = Vec.Normalize(Vec.LengthSquared(way) > margin * margin ? way : asked, Vector3.UnitZ);
        if (Vec.Dot(direction, asked) <= 0f)
        {
            return false;
        }

        way += direction * margin;
        float length = Vec.Length(way);
        var range = new GroundRange(new RootPlace(root.ToWorld(way), root.Rotation, root.Scale), up, ground, (Above * body.LegLength) + length, (Deepest * body.LegLength) + length);
        float foremost = float.MinValue;
        foreach (LegRig leg in body.Legs)
        {
            foremost = Math.Max(foremost, Vec.Dot(leg.Home, direction));
        }

        for (int i = 0; i < body.Legs.Length; i++)
        {
            if (Vec.Dot(body.Legs[i].Home, direction) >= foremost - (Leading * body.LegLength) && !GroundNearFeet.Reaches(body, i, direction, range))
            {
                return true;
            }
        }

        return false;
    }
}
