using System;
using System.IO;
using System.Linq;
using System.Management.Automation;
using System.Management.Automation.Runspaces;

namespace CreatureGen.PowerShell;

/// <summary>Runs a script in PowerShell's engine, then completes each of the other arguments as Tab does at its end: a line of words for each. What the engine complains of ends it with 1.</summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        using Runspace space = RunspaceFactory.CreateRunspace(InitialSessionState.CreateDefault2());
        space.Open();
        using var shell = System.Management.Automation.PowerShell.Create(space);
        shell.AddScript(File.ReadAllText(arguments[0])).Invoke();
        foreach (string line in arguments.Skip(1))
        {
            shell.Commands.Clear();
            Console.WriteLine(string.Join(' ', CommandCompletion.CompleteInput(line, line.Length, [], shell).CompletionMatches.Select(match => match.CompletionText)));
        }

        foreach (ErrorRecord problem in shell.Streams.Error)
        {
            Console.Error.WriteLine(problem);
        }

        return shell.Streams.Error.Count == 0 ? 0 : 1;
    }
}
