using System;
using System.Diagnostics;
using System.Globalization;
using System.Threading;

namespace CreatureGen.Console.Text;

/// <summary>Whether progress is to be seen.</summary>
internal enum ProgressKind
{
    /// <summary>It is, on a terminal.</summary>
    Shown,

    /// <summary>It is not.</summary>
    Hidden,
}

/// <summary>A line that counts on while work goes on, and goes when it ends. Only people see it: nothing is written to a file or a pipe, nor to a terminal that is to have plain lines alone.</summary>
internal sealed class ProgressLine : IDisposable
{
    private const int MillisecondsBetween = 100;

    private readonly Surroundings surroundings;
    private readonly string what;
    private readonly UInt128 total;
    private readonly bool shown;
    private readonly long start = Stopwatch.GetTimestamp();
    private readonly Lock gate = new();
    private long done;
    private long told;
    private int width;

    /// <summary>Starts at 0 of <paramref name="total"/>.</summary>
    public ProgressLine(Surroundings surroundings, string what, UInt128 total, ProgressKind kind)
    {
        this.surroundings = surroundings;
        this.what = what;
        this.total = total;
        shown = kind == ProgressKind.Shown && surroundings.ErrorIsTerminal && surroundings.AllowsColour && surroundings.ShowsProgress;
    }

    /// <summary>One more is done. Safe to call from several threads.</summary>
    public void Step()
    {
        if (!shown)
        {
            return;
        }

        lock (gate)
        {
            done++;
            double elapsed = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
            if ((long)elapsed - told >= MillisecondsBetween)
            {
                told = (long)elapsed;
                Show(string.Create(CultureInfo.InvariantCulture, $"{done:N0} of {total:N0} {what}, {done * 1000 / elapsed:N0} a second"));
            }
        }
    }

    /// <summary>Clears the line.</summary>
    public void Dispose()
    {
        if (width > 0)
        {
            Show("");
            surroundings.Error.Write('\r');
            width = 0;
        }
    }

    private void Show(string text)
    {
        surroundings.Error.Write("\r" + text.PadRight(width));
        width = text.Length;
    }
}
