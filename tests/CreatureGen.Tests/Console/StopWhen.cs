using System;
using System.Threading;

namespace CreatureGen.Tests.Console;

/// <summary>Asks to stop as soon as a condition holds, looked at every millisecond on another thread. When it is disposed of no look is under way any more: a late one would find what it looks at gone.</summary>
internal sealed class StopWhen : IDisposable
{
    private readonly CancellationTokenSource stop = new();
    private readonly Timer timer;

    public StopWhen(Func<bool> condition) => timer = new Timer(_ =>
    {
        if (condition())
        {
            stop.Cancel();
        }
    }, null, 0, 1);

    public CancellationToken Token => stop.Token;

    public void Dispose()
    {
        using var ended = new ManualResetEvent(false);
        timer.Dispose(ended);
        ended.WaitOne();
        stop.Dispose();
    }
}
