using System;
using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>The plane that stands for the ground near a ball of a ragdoll: that through the first hit of a ray from above.</summary>
internal static class RagdollFloor
{
    /// <summary>How far above a ball the ray begins, at least, sizes of the creature: deeper in the ground than that it is not found.</summary>
    private const float Rise = 0.25f;

    /// <summary>The same in radii, and how far below the middle of the ball the ray ends: slopes of up to 75° touch it before that.</summary>
    private const float RiseRadii = 2f;
    private const float FallRadii = 4f;

    /// <summary>Finds it.</summary>
    /// <param name="ground">World space.</param>
    /// <param name="centre">Middle of the ball, world space.</param>
    /// <param name="radius">Of the ball, metres.</param>
    /// <param name="size">Of the creature, metres.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="hit">Receives a point of the plane and its normal.</param>
    /// <returns>False where there is no ground in reach.</returns>
    public static bool TryFind<TGround>(TGround ground, Vector3 centre, float radius, float size, Vector3 up, out GroundHit hit)
        where TGround : IGround
    {
        float rise = Math.Max(RiseRadii * radius, Rise * size);
        return ground.Cast(centre + (up * rise), -up, rise + (FallRadii * radius), out hit);
    }
}
