using System;
using System.Numerics;

namespace CreatureGen.Motion.Grounds;

/// <summary>A ray over a square grid, in cells along x and z and in metres along y, in double precision.</summary>
internal readonly struct GridRay
{
    /// <summary>Sees a ray from the corner of a grid.</summary>
    public GridRay(Vector3 origin, Vector3 direction, Vector3 corner, double cell)
    {
        U = ((double)origin.X - corner.X) / cell;
        Y = (double)origin.Y - corner.Y;
        V = ((double)origin.Z - corner.Z) / cell;
        AlongU = direction.X / cell;
        AlongY = direction.Y;
        AlongV = direction.Z / cell;
    }

    /// <summary>Where it begins along x, cells.</summary>
    public double U { get; }

    /// <summary>Where it begins along y, metres.</summary>
    public double Y { get; }

    /// <summary>Where it begins along z, cells.</summary>
    public double V { get; }

    /// <summary>Cells along x for each unit of the ray.</summary>
    public double AlongU { get; }

    /// <summary>Metres along y for each unit of the ray.</summary>
    public double AlongY { get; }

    /// <summary>Cells along z for each unit of the ray.</summary>
    public double AlongV { get; }

    /// <summary>Cuts a stretch of a ray to where one coordinate is from 0 to <paramref name="size"/>; false if nothing is left.</summary>
    public static bool Clip(double start, double rate, double size, ref double enter, ref double leave)
    {
        if (rate == 0)
        {
            return start >= 0 && start <= size;
        }

        double a = -start / rate;
        double b = (size - start) / rate;
        enter = Math.Max(enter, Math.Min(a, b));
        leave = Math.Min(leave, Math.Max(a, b));
        return enter <= leave;
    }

    /// <summary>Where a ray leaves a cell along one coordinate.</summary>
    public static double Border(double start, double rate, int cell) =>
        rate > 0 ? (cell + 1 - start) / rate : rate < 0 ? (cell - start) / rate : double.PositiveInfinity;
}
