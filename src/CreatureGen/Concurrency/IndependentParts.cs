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
    /// <summary>Runs all parts and returns when the last is done. What a part throws is thrown here.</summary>
    /// <param name="count">Number of parts.</param>
    /// <param name="part">Does the part of a number 0 up to <paramref name="count"/>.</param>
    public static void Run(int count, Action<int> part)
    {
        if (count < 2 || Environment.ProcessorCount < 2)
        {
            for (int i = 0; i < count; i++)
            {
                part(i);
            }

            return;
        }

        try
        {
            Parallel.For(0, count, part);
        }
        catch (AggregateException all)
        {
            ExceptionDispatchInfo.Capture(all.InnerExceptions[0]).Throw();
        }
    }
}
