using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>A running probe of one build of the library; the other program of the same kind waits meanwhile.</summary>
internal sealed class ProbeProcess : IDisposable
{
    private readonly Process process;

    /// <summary>Starts a probe.</summary>
    /// <param name="program">Its assembly.</param>
    /// <param name="tiered">Whether the just-in-time compiler may begin with quick code and profile it, as it does by default.</param>
    public ProbeProcess(string program, bool tiered = true)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardInput = true, RedirectStandardOutput = true };
        start.ArgumentList.Add(program);
        start.Environment["DOTNET_TieredCompilation"] = tiered ? "1" : "0";
        process = Process.Start(start) ?? throw new InvalidOperationException("dotnet does not start");
    }

    /// <summary>Writes the blueprints that all probes work on.</summary>
    public void Write(string folder, int count) => Ask(FormattableString.Invariant($"write {folder} {count}"));

    /// <summary>Reads them.</summary>
    public void Read(string folder) => Ask("read " + folder);

    /// <summary>Nanoseconds of one operation of each item of a row, done once.</summary>
    public double[] Round(string row) => Array.ConvertAll(Ask("round " + row).Split(' '), word => double.Parse(word, CultureInfo.InvariantCulture));

    /// <summary>Ends the probe.</summary>
    public void Dispose()
    {
        process.StandardInput.Close();
        process.WaitForExit();
        process.Dispose();
    }

    private string Ask(string line)
    {
        process.StandardInput.WriteLine(line);
        return process.StandardOutput.ReadLine() ?? throw new IOException($"the probe ended at '{line}'; expected an answer");
    }
}
