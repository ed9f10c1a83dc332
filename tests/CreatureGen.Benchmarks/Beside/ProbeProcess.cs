using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>A running probe of one build of a library; the others wait meanwhile.</summary>
internal sealed class ProbeProcess : IDisposable
{
    private readonly Process process;

    private ProbeProcess(ProcessStartInfo start)
    {
        start.RedirectStandardInput = true;
        start.RedirectStandardOutput = true;
        process = Process.Start(start) ?? throw new InvalidOperationException(start.FileName + " does not start");
    }

    /// <summary>Starts a probe of a build of this library.</summary>
    /// <param name="program">Its assembly.</param>
    /// <param name="tiered">Whether the just-in-time compiler may begin with quick code and profile it, as it does by default.</param>
    public static ProbeProcess Dotnet(string program, bool tiered)
    {
        var start = new ProcessStartInfo("dotnet", [program]);
        start.Environment["DOTNET_TieredCompilation"] = tiered ? "1" : "0";
        return new ProbeProcess(start);
    }

    /// <summary>Starts a program that obeys the same lines.</summary>
    public static ProbeProcess Native(string program) => new(new ProcessStartInfo(program));

    /// <summary>Writes the blueprints that all probes work on.</summary>
    public void Write(string folder, int count) => Ask(FormattableString.Invariant($"write {folder} {count}"));

    /// <summary>Writes creatures for programs of other libraries.</summary>
    public void Export(string folder, int count) => Ask(FormattableString.Invariant($"export {folder} {count}"));

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
