using System;
using System.Runtime.ExceptionServices;
using System.Threading.Tasks;

namespace CreatureGen.Concurrency;

/// <summary>
/// Runs the parts of a piece of work side by side where the machine has cores for it. The only place of the library that uses threads.
/// </summary>
/// <remarks>
/// For work whose parts know nothing of each other: each writes memory of its own, none reads what another writes, and how many there are follows from the work and never from the machine.
/// So the result is the same on one core and on many.
/// </remarks>
internal static class IndependentParts
{
    /// <summary>Runs all parts on as many threads as there are cores, and returns when the last is done. What a part throws is thrown here.</summary>
    /// <param name="count">Number of parts.</param>
    /// <param name="part">Does the part of a number 0 up to <paramref name="count"/>.</param>
    public static void Run(int count, Action<int> part) => Run(count, Environment.ProcessorCount, part);

    /// <summary>The same on a number of threads at most.</summary>
    /// <param name="count">Number of parts.</param>
    /// <param name="threads">At least 1.</param>
    /// <param name="part">Does the part of a number 0 up to <paramref name="count"/>.</param>
    public static void Run(int count, int threads, Action<int> part)
    {
        if (count < 2 || threads < 2)
        {
            for (int i = 0; i < count; i++)
            {
                part(i);
            }

            return;
        }

        try
        {
            Parallel.For(0, count, new ParallelOptions { MaxDegreeOfParallelism = threads }, part);
        }
        catch (AggregateException all)
        {
            ExceptionDispatchInfo.Capture(all.InnerExceptions[0]).Throw();
        }
    }
}
