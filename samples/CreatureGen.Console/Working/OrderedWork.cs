using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace CreatureGen.Console.Working;

/// <summary>Does the same work for many inputs on several threads, and hands over the results in the order of the inputs.</summary>
/// <remarks>Inputs are taken only as they are needed, and threads that are far ahead of the slowest wait for it: there may be any number of inputs.</remarks>
internal sealed class OrderedWork<TInput, TResult>
{
    // Results that each thread may be ahead by.
    private const int Lead = 16;

    private readonly Lock gate = new();
    private readonly SemaphoreSlim room;
    private readonly Dictionary<long, TResult> waiting = [];
    private readonly Func<TInput, TResult> work;
    private readonly Action<TResult> deliver;
    private readonly IEnumerator<TInput> inputs;
    private readonly CancellationTokenSource stop;
    private ExceptionDispatchInfo? failure;
    private long failedAt = long.MaxValue;
    private long taken;
    private long delivered;

    private OrderedWork(IEnumerator<TInput> inputs, int threads, Func<TInput, TResult> work, Action<TResult> deliver, CancellationToken cancellation)
    {
        this.inputs = inputs;
        this.work = work;
        this.deliver = deliver;
        room = new SemaphoreSlim(threads * Lead);
        stop = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
    }

    /// <summary>Does all the work. An exception of one piece ends it and is thrown as it is, when the results before it have been handed over.</summary>
    /// <param name="inputs">Any number.</param>
    /// <param name="threads">At least 1.</param>
    /// <param name="work">Called on any thread.</param>
    /// <param name="deliver">Called for one result at a time, on any thread.</param>
    /// <param name="cancellation">Stops between pieces.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Run(IEnumerable<TInput> inputs, int threads, Func<TInput, TResult> work, Action<TResult> deliver, CancellationToken cancellation)
    {
        using IEnumerator<TInput> enumerator = inputs.GetEnumerator();
        var run = new OrderedWork<TInput, TResult>(enumerator, threads, work, deliver, cancellation);
        var helpers = new Thread[threads - 1];
        for (int i = 0; i < helpers.Length; i++)
        {
            helpers[i] = new Thread(run.Loop) { IsBackground = true };
            helpers[i].Start();
        }

        run.Loop();
        foreach (Thread helper in helpers)
        {
            helper.Join();
        }

        run.failure?.Throw();
        cancellation.ThrowIfCancellationRequested();
    }

    private void Loop()
    {
        try
        {
            while (Take(out TInput input, out long number))
            {
                try
                {
                    TResult result = work(input);
                    lock (gate)
                    {
                        waiting.Add(number, result);
                        Deliver();
                    }
                }
                catch (Exception problem)
                {
                    Fail(number, problem);
                }
            }
        }
        catch (OperationCanceledException)
        {
            // The work ended while this thread waited for room.
        }
        catch (Exception problem)
        {
            Fail(long.MaxValue - 1, problem);
        }
    }

    private bool Take(out TInput input, out long number)
    {
        room.Wait(stop.Token);
        lock (gate)
        {
            if (stop.IsCancellationRequested || failure != null || !inputs.MoveNext())
            {
                room.Release();
                input = default!;
                number = 0;
                return false;
            }

            input = inputs.Current;
            number = taken++;
            return true;
        }
    }

    private void Deliver()
    {
        while (waiting.Remove(delivered, out TResult? result))
        {
            delivered++;
            room.Release();
            deliver(result);
        }
    }

    private void Fail(long number, Exception problem)
    {
        lock (gate)
        {
            if (number < failedAt)
            {
                failedAt = number;
                failure = ExceptionDispatchInfo.Capture(problem);
            }
        }

        // Those before it may still finish; nobody must wait for room that will not come.
        room.Release(Lead);
    }
}
