using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Level ground up to a line across the Z axis, and beyond it flat stones in rows without end, each a little off its place and its height, with nothing between.</summary>
internal sealed class SteppingStones : IGround
{
    // All in leg lengths.
    private const double Every = 0.72;
    private const double HalfSide = 0.25;
    private const double Astray = 0.08;
    private const double HeightSpread = 0.05;

    /// <summary>Leg lengths from probe to probe along rays that do not fall straight.</summary>
    private const float Stride = 0.05f;

    /// <summary>Steps of the hash of a place.</summary>
    private const double Whole = 1.0 / (1UL << 53);

    private readonly Seed seed;
    private readonly double legLength;
    private readonly double start;

    /// <summary>Lays them.</summary>
    /// <param name="seed">Of their places.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="start">z of the line, metres.</param>
    public SteppingStones(Seed seed, float legLength, float start)
    {
        this.seed = seed;
        this.legLength = legLength;
        this.start = start;
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (!(Finite.Is(origin) && Finite.Is(direction) && distance >= 0f))
        {
            return false;
        }

        if (direction.X == 0f && direction.Z == 0f)
        {
            return TryFind(origin, out float height) && Reaches(origin, direction, distance, height, out hit);
        }

        float stride = Stride * (float)legLength;
        for (float way = 0f; way <= distance; way += stride)
        {
            Vector3 point = origin + (direction * way);
            if (TryFind(point, out float height) && point.Y <= height)
            {
                hit = new GroundHit(point with { Y = height }, Vector3.UnitY);
                return true;
            }
        }

        return false;
    }

    private static bool Reaches(Vector3 origin, Vector3 direction, float distance, float height, out GroundHit hit)
    {
        float fall = origin.Y - height;
        hit = new GroundHit(origin with { Y = height }, Vector3.UnitY);
        return fall <= 0f || (direction.Y < 0f && fall <= distance);
    }

    /// <summary>Height of the ground above or below a point; none beside stones.</summary>
    private bool TryFind(Vector3 point, out float height)
    {
        height = 0f;
        if (point.Z <= start)
        {
            return true;
        }

        double x = point.X / (Every * legLength);
        double z = (point.Z - start) / (Every * legLength);
        double column = Math.Floor(x);
        double row = Math.Floor(z);
        Seed stone = seed.Child(unchecked((int)(long)column)).Child(unchecked((int)(long)row));
        double across = (x - column - 0.5) * Every;
        double along = (z - row - 0.5) * Every;
        height = (float)(Part(stone, 2) * HeightSpread * legLength);
        return Math.Abs(across - (Part(stone, 0) * Astray)) <= HalfSide && Math.Abs(along - (Part(stone, 1) * Astray)) <= HalfSide;
    }

    /// <summary>A number of a stone, −1..1.</summary>
    private static double Part(Seed stone, int number) => (2 * (stone.Child(number).Value >> 11) * Whole) - 1;
}
