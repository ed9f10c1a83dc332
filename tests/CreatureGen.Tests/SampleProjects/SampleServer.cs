using System;
using System.Diagnostics;
using System.IO;
using System.Net;
using System.Net.Http;
using System.Threading.Tasks;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The server of the samples as a process of its own: one at work, two may wait.</summary>
public sealed class SampleServer : IAsyncLifetime
{
    private Process? process;

    /// <summary>Asks it.</summary>
    public HttpClient Client { get; } = new();

    public async ValueTask InitializeAsync()
    {
        string configuration = new DirectoryInfo(AppContext.BaseDirectory).Parent!.Name;
        string program = SampleFiles.At($"samples/CreatureGen.Server/bin/{configuration}/net10.0/CreatureGen.Server.dll");
        process = SampleFiles.Start(Path.GetTempPath(), "dotnet", [program, "--urls", $"http://{IPAddress.Loopback}:0", "--AtOnce", "1", "--Waiting", "2"]);
        _ = process.StandardError.ReadToEndAsync();
        const string told = "Now listening on: ";
        while (await process.StandardOutput.ReadLineAsync() is string line)
        {
            if (line.Contains(told, StringComparison.Ordinal))
            {
                Client.BaseAddress = new Uri(line[(line.IndexOf(told, StringComparison.Ordinal) + told.Length)..]);
                _ = process.StandardOutput.ReadToEndAsync();
                return;
            }
        }

        throw new InvalidOperationException("the server ended before it listened");
    }

    public ValueTask DisposeAsync()
    {
        process!.Kill();
        process.WaitForExit();
        process.Dispose();
        Client.Dispose();
        return ValueTask.CompletedTask;
    }
}
