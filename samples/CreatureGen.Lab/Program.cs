using System;
using System.IO;
using System.Threading.Tasks;

namespace CreatureGen.Lab;

/// <summary>The creature lab: serves the page, or writes it to a folder.</summary>
internal static class Program
{
    private static async Task<int> Main(string[] arguments)
    {
        LabArguments? wanted = LabArguments.Read(arguments, out string? problem);
        if (wanted == null)
        {
            await System.Console.Error.WriteLineAsync(problem);
            return 2;
        }

        if (wanted.Task == LabTask.Help)
        {
            await System.Console.Out.WriteLineAsync(LabArguments.Usage);
            return 0;
        }

        var site = new Site(Path.Combine(AppContext.BaseDirectory, "site"));
        try
        {
            site.Prepare();
            if (wanted.Task == LabTask.Export)
            {
                int files = site.Export(wanted.Folder);
                await System.Console.Out.WriteLineAsync(FormattableString.Invariant($"wrote {files} files to {wanted.Folder}; any web server can serve them"));
                return 0;
            }

            await LabServer.RunAsync(site, wanted.Port);
            return 0;
        }
        catch (Exception reason) when (reason is IOException or UnauthorizedAccessException or InvalidOperationException)
        {
            await System.Console.Error.WriteLineAsync(reason.Message);
            return 1;
        }
    }
}
