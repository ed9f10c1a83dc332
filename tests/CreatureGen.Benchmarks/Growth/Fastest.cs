using System;
using System.Diagnostics;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>Times of work of which the fastest of several rounds counts, so that other programs on the machine do not.</summary>
internal static class Fastest
{
    /// <summary>Microseconds of the fastest round.</summary>
    public static double Of(int rounds, Action round)
    {
        double fastest = double.MaxValue;
        for (int i = 0; i < rounds; i++)
        {
            long start = Stopwatch.GetTimestamp();
            round();
            fastest = Math.Min(fastest, Stopwatch.GetElapsedTime(start).TotalMicroseconds);
        }

        return fastest;
    }

    /// <summary>What a measurement gives the second time: the first is for the compiler, whose code of whatever is measured first would otherwise be the slower the earlier its turn comes.</summary>
    public static T Warm<T>(Func<T> measure)
    {
        measure();
        return measure();
    }
}
