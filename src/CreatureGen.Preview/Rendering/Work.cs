using System;
using System.Runtime.ExceptionServices;
using System.Threading;
using System.Threading.Tasks;

namespace CreatureGen.Preview.Rendering;

/// <summary>Shares independent jobs between threads. Each job writes only what is its own, so that the result is the same for any number of threads.</summary>
internal static class Work
{
    /// <summary>Does jobs 0..<paramref name="count"/> − 1, each with the scratch memory of the thread that does it. The first exception of a job ends the work and is thrown as it is.</summary>
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
        int workers = Math.Min(threads, count);
        try
        {
            Parallel.For(0, workers, new ParallelOptions { MaxDegreeOfParallelism = workers }, (_, state) =>
            {
                TScratch own = scratch();
                for (int i = Interlocked.Increment(ref next); i < count && !state.IsExceptional; i = Interlocked.Increment(ref next))
                {
                    job(i, own);
                }
            });
        }
        catch (AggregateException several)
        {
            ExceptionDispatchInfo.Throw(several.InnerExceptions[0]);
        }
    }

    /// <summary>Does jobs 0..<paramref name="count"/> − 1.</summary>
    public static void Share(int count, int threads, Action<int> job) => Share(count, threads, () => 0, (i, _) => job(i));
}
