using System;
using System.Threading;
using System.Threading.Tasks;

namespace CreatureGen.Preview.Rendering;

/// <summary>Shares independent jobs between threads. Each job writes only what is its own, so that the result is the same for any number of threads.</summary>
internal static class Work
{
    /// <summary>Does jobs 0..<paramref name="count"/> − 1, each with the scratch memory of the thread that does it.</summary>
    public static void Share<TScratch>(int count, int threads, Func<TScratch> scratch, Action<int, TScratch> job)
    {
        if (threads <= 1 || count <= 1)
        {
            TScratch own = scratch();
            for (int i = 0; i < count; i++)
            {
                job(i, own);
            }

            return;
        }

        int next = -1;
        Parallel.For(0, Math.Min(threads, count), new ParallelOptions { MaxDegreeOfParallelism = threads }, _ =>
        {
            TScratch own = scratch();
            for (int i = Interlocked.Increment(ref next); i < count; i = Interlocked.Increment(ref next))
            {
                job(i, own);
            }
        });
    }

    /// <summary>Does jobs 0..<paramref name="count"/> − 1.</summary>
    public static void Share(int count, int threads, Action<int> job) => Share(count, threads, () => 0, (i, _) => job(i));
}
