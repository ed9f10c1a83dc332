using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Xunit;

namespace CreatureGen.Tests.Gltf;

/// <summary>The programs of tests/gltf-tools, which run on Node. Their packages are installed when they are first needed.</summary>
internal static class GltfTools
{
    /// <summary>The folder of the programs, found upwards from that of the tests.</summary>
    public static string Folder { get; } = Find();

    /// <summary>Runs a script on a folder and returns its exit code and what it printed. Skips the test where Node or the packages cannot be had, but fails it when the environment variable CI is set.</summary>
    public static async Task<(int ExitCode, string Output, string Errors)> RunAsync(string script, string argument, CancellationToken cancellation)
    {
        await RequireAsync("node", "Node is not installed; it runs the glTF validator and the independent reader", cancellation);
        await InstallAsync(cancellation);
        return await StartAsync("node", [script, argument], cancellation);
    }

    private static async Task InstallAsync(CancellationToken cancellation)
    {
        // Other tests, also of other processes, may want the same at the same time: one of them installs.
        await using FileStream alone = await LockAsync(Path.Combine(Folder, ".installing"), cancellation);

        // npm writes this file last.
        if (File.Exists(Path.Combine(Folder, "node_modules", ".package-lock.json")))
        {
            return;
        }

        string npm = OperatingSystem.IsWindows() ? "npm.cmd" : "npm";
        await RequireAsync(npm, "npm is not installed; it installs the glTF validator and the independent reader", cancellation);
        (int code, string output, string errors) = await StartAsync(npm, ["ci", "--prefer-offline", "--no-audit", "--no-fund"], cancellation);
        if (code != 0)
        {
            Miss("npm ci failed in tests/gltf-tools: " + output + errors);
        }
    }

    private static async Task RequireAsync(string program, string missing, CancellationToken cancellation)
    {
        try
        {
            await StartAsync(program, ["--version"], cancellation);
        }
        catch (Win32Exception)
        {
            Miss(missing);
        }
    }

    private static void Miss(string reason)
    {
        Assert.True(string.IsNullOrEmpty(Environment.GetEnvironmentVariable("CI")), reason);
        Assert.Skip(reason);
    }

    private static async Task<FileStream> LockAsync(string path, CancellationToken cancellation)
    {
        while (true)
        {
            try
            {
                return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1, FileOptions.DeleteOnClose);
            }
            catch (IOException)
            {
                await Task.Delay(50, cancellation);
            }
        }
    }

    private static async Task<(int ExitCode, string Output, string Errors)> StartAsync(string program, IEnumerable<string> arguments, CancellationToken cancellation)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            WorkingDirectory = Folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            UseShellExecute = false,
        };
        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(cancellation);
        Task<string> errors = process.StandardError.ReadToEndAsync(cancellation);
        await process.WaitForExitAsync(cancellation);
        return (process.ExitCode, await output, await errors);
    }

    private static string Find()
    {
        for (string? folder = AppContext.BaseDirectory; folder != null; folder = Path.GetDirectoryName(folder))
        {
            string tools = Path.Combine(folder, "tests", "gltf-tools");
            if (File.Exists(Path.Combine(tools, "package.json")))
            {
                return tools;
            }
        }

        throw new DirectoryNotFoundException("no tests/gltf-tools above " + AppContext.BaseDirectory);
    }
}
