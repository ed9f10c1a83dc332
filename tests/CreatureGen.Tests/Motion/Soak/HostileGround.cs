using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Motion.Soak;

/// <summary>Ground that lies as bad game code does: now and then its hits are not finite, not unit, far away, or missing, its platforms come and go, and it throws.</summary>
internal sealed class HostileGround(IGround inner, RandomStream random) : IMovingGround
{
    /// <summary>What it throws, made beforehand.</summary>
    public static InvalidOperationException Thrown { get; } = new("the ground has thrown");

    /// <summary>The share of rays that get a bad answer.</summary>
    public double Malice { get; set; }

    /// <summary>The share of rays for which it throws.</summary>
    public double Fury { get; set; }

    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        if (random.Chance(Fury))
        {
            throw Thrown;
        }

        bool there = inner.Cast(origin, direction, distance, out hit);
        if (!random.Chance(Malice))
        {
            return there;
        }

        hit = random.Integer(0, 9) switch
        {
            0 => new GroundHit(new Vector3(float.NaN, 0f, 0f), Vector3.UnitY),
            1 => new GroundHit(hit.Point, new Vector3(0f, float.NaN, 0f)),
            2 => new GroundHit(hit.Point, Vector3.Zero),
            3 => new GroundHit(hit.Point, new Vector3(3f, 4f, 0f)),
            4 => new GroundHit(new Vector3(1e30f, -1e30f, 1e30f), Vector3.UnitY),
            5 => new GroundHit(new Vector3(float.PositiveInfinity), Vector3.UnitY),
            6 => new GroundHit(origin + (direction * distance * 5f), -direction),
            7 => new GroundHit(hit.Point, -Vector3.UnitY, int.MinValue, 7),
            _ => new GroundHit(origin, Vector3.UnitX, 3, 8),
        };
        return random.Chance(0.9);
    }

    public bool TryLocate(int platform, out RootPlace placement)
    {
        placement = random.Chance(0.1) ? default : new RootPlace(new Vector3((float)random.Uniform(-5, 5), 0f, 0f), Quaternion.Identity);
        return random.Chance(0.7);
    }
}
