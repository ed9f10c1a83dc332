using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Verbs;

namespace CreatureGen.Console;

/// <summary>Finds the verb and turns what comes of it into an exit code.</summary>
internal static class Application
{
    /// <summary>The program's name in its own words.</summary>
    public const string Name = "creaturegen";

    /// <summary>All verbs, in the order of the help.</summary>
    public static IReadOnlyList<IVerb> Verbs { get; } = [new GenerateVerb(), new BuildVerb(), new BreedVerb(), new EvolveVerb(), new InspectVerb(), new SheetVerb(), new GalleryVerb(), new AnimateVerb(), new VerifyVerb(), new MergeVerb(), new VarietyVerb(), new MetricsVerb(), new EventsVerb(), new TeachVerb(), new CompletionVerb(), new ManualVerb()];

    /// <summary>Runs the program.</summary>
    /// <returns>One of <see cref="ExitCode"/>.</returns>
    public static int Run(IReadOnlyList<string> arguments, Surroundings surroundings)
    {
        try
        {
            int code = Dispatch(arguments, surroundings);
            Flush(surroundings.Out);
            return code;
        }
        catch (UsageError error)
        {
            return Complain(surroundings, error.Lines, ExitCode.BadInput);
        }
        catch (WriteFailure failure)
        {
            return Complain(surroundings, [failure.Message], ExitCode.CannotWrite);
        }
        catch (OperationCanceledException) when (surroundings.Cancellation.IsCancellationRequested)
        {
            return Complain(surroundings, ["interrupted; no unfinished file is left"], ExitCode.Interrupted);
        }
        catch (InvalidOperationException defect)
        {
            // The library refuses to finish or to write a creature that is not whole.
            return Complain(surroundings, ["a defect of CreatureGen: " + defect.Message], ExitCode.CheckFailed);
        }
    }

    private static int Dispatch(IReadOnlyList<string> arguments, Surroundings surroundings)
    {
        if (arguments.Count == 0)
        {
            return FirstCreature.Run(surroundings);
        }

        string word = arguments[0];
        if (word is "--help" or "-h" or "help")
        {
            return Help(arguments, surroundings);
        }

        if (word == "--version")
        {
            surroundings.Out.WriteLine(HelpText.Version);
            return ExitCode.Done;
        }

        IVerb verb = Find(word);
        string[] rest = arguments.Skip(1).ToArray();
        if (ArgumentReader.AsksForHelp(rest))
        {
            HelpText.Write(surroundings.Out, verb.Syntax, Ink.For(surroundings, surroundings.OutIsTerminal));
            return ExitCode.Done;
        }

        ParsedArguments parsed = ArgumentReader.Read(verb.Syntax, rest);
        return verb.Run(parsed, CommonOptions.IsQuiet(parsed) ? surroundings.Hushed() : surroundings);
    }

    private static int Help(IReadOnlyList<string> arguments, Surroundings surroundings)
    {
        Ink ink = Ink.For(surroundings, surroundings.OutIsTerminal);
        if (arguments.Count > 1 && !arguments[1].StartsWith('-'))
        {
            HelpText.Write(surroundings.Out, Find(arguments[1]).Syntax, ink);
        }
        else
        {
            HelpText.Write(surroundings.Out, Verbs.Select(verb => verb.Syntax).ToArray(), ink);
        }

        return ExitCode.Done;
    }

    private static IVerb Find(string word)
    {
        string[] names = Verbs.Select(verb => verb.Syntax.Name).ToArray();
        int index = Array.IndexOf(names, word);
        if (index >= 0)
        {
            return Verbs[index];
        }

        if (Forgotten(word) is string verb)
        {
            throw new UsageError($"no verb before '{word}'; did you mean {Name} {verb} {word}?");
        }

        string what = word.StartsWith('-') ? "option" : "verb";
        string[] known = word.StartsWith('-') ? ["--help", "--version"] : names;
        throw new UsageError($"unknown {what} '{word}'; expected one of {string.Join(", ", known)}{Suggestion.For(word, known)}");
    }

    /// <summary>The verb that was left out before an option, a seed or a file; null if it cannot be told.</summary>
    private static string? Forgotten(string word)
    {
        string option = word.Split('=')[0];
        return Verbs.FirstOrDefault(verb => verb.Syntax.Options.Any(known => known.Is(option)))?.Syntax.Name
            ?? (SeedText.TryRead(word, out _) ? "generate --seed" : word.EndsWith(".glb", StringComparison.OrdinalIgnoreCase) || word.EndsWith(".json", StringComparison.OrdinalIgnoreCase) ? "inspect" : null);
    }

    private static void Flush(TextWriter output)
    {
        try
        {
            output.Flush();
        }
        catch (IOException problem)
        {
            throw new WriteFailure("cannot write to the standard output: " + Reason.Of(problem), problem);
        }
    }

    private static int Complain(Surroundings surroundings, IReadOnlyList<string> lines, int code)
    {
        try
        {
            surroundings.Out.Flush();
        }
        catch (Exception problem) when (problem is IOException or WriteFailure)
        {
            // What went wrong before is told below; a closed output can be told nothing.
        }

        Complaint.Tell(surroundings, lines);
        return code;
    }
}
