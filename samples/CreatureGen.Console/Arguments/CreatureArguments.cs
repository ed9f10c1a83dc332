using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Files;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Arguments;

/// <summary>The options that say which creatures are wanted: the library's <see cref="CreatureOptions"/>.</summary>
internal static class CreatureArguments
{
    private static readonly WordList<RequestedKind> kinds = WordList<RequestedKind>.Instance;
    private static readonly WordList<BodyPlan> plans = WordList<BodyPlan>.Instance;
    private static readonly WordList<PaletteMood> palettes = WordList<PaletteMood>.Instance;
    private static readonly WordList<OrnamentLevel> ornaments = WordList<OrnamentLevel>.Instance;

    public static readonly OptionSyntax Kind = new("--kind", "KIND", "walking, flying, swimming or any (each seed's natural kind; the default)") { Short = "-k", Words = kinds.All };

    public static readonly OptionSyntax File = new("--options", "FILE.json", "all of these options as JSON; those on the command line go before them");

    /// <summary>All of them, in the order of the help.</summary>
    public static IReadOnlyList<OptionSyntax> Syntax { get; } =
    [
        Kind,
        new("--scale", "MIN-MAX", "size of the creature, 0.05 to 20; at 1 a torso is about one metre long (default 0.5-2)"),
        new("--leg-pairs", "MIN-MAX", "pairs of legs and arms, 0 to 16 (default 0-16)"),
        new("--plans", "PLAN=W,...", "how much oftener body plans come, 0 to 1000: hexapod=5,legless=0"),
        new("--bodies", "BODY=W,...", "how much oftener base bodies come, 0 to 1000: feline=8,insect=0"),
        new("--strangeness", "0..1", "how far from any animal: 0 animals, 1 anything of anything (default 0.6)"),
        new("--palette", "MOOD", "any, natural, vivid, pale or dark") { Words = palettes.All },
        new("--ornaments", "LEVEL", "none, sparse, normal or rich") { Words = ornaments.All },
        new("--triangles", "N", "triangle budget, 6000 to 100000 (default 20000)"),
        File,
    ];

    /// <summary>The options asked for.</summary>
    /// <exception cref="UsageError">They cannot be read, or contradict one another.</exception>
    public static CreatureOptions Read(ParsedArguments arguments, Surroundings surroundings)
    {
        CreatureOptions options = arguments.Value(File.Name) is string path ? ReadFile(surroundings.Locate(path), surroundings) : CreatureOptions.Default;
        options = options with
        {
            Kind = arguments.Choice("--kind", kinds, options.Kind),
            Palette = arguments.Choice("--palette", palettes, options.Palette),
            Ornaments = arguments.Choice("--ornaments", ornaments, options.Ornaments),
            TriangleBudget = arguments.Whole("--triangles", 0, int.MaxValue, options.TriangleBudget),
        };
        if (arguments.Value("--strangeness") is string strangeness)
        {
            options = options with { Strangeness = Number(strangeness) ?? throw arguments.Wrong("--strangeness", strangeness, "a number 0..1") };
        }

        if (arguments.Value("--scale") is string scale)
        {
            (double least, double most) = Ends(arguments, "--scale", scale, Number);
            options = options with { MinScale = least, MaxScale = most };
        }

        if (arguments.Value("--leg-pairs") is string pairs)
        {
            (int least, int most) = Ends(arguments, "--leg-pairs", pairs, Whole);
            options = options with { MinLegPairs = least, MaxLegPairs = most };
        }

        if (arguments.Value("--plans") is string planWeights)
        {
            options = options with { BodyPlans = new ValueList<BodyPlanWeight>(Weights(arguments, "--plans", planWeights, plans.All).Select(pair => PlanWeight(pair.Word, pair.Weight))) };
        }

        if (arguments.Value("--bodies") is string bodyWeights)
        {
            options = options with { BaseBodies = new ValueList<BaseBodyWeight>(Weights(arguments, "--bodies", bodyWeights, BaseBodyNames.All).Select(pair => new BaseBodyWeight(pair.Word, pair.Weight))) };
        }

        Require(arguments, options);
        return options;
    }

    private static CreatureOptions ReadFile(string path, Surroundings surroundings)
    {
        OptionsReading reading;
        using (Stream stream = SourceFile.Open(path, "options as JSON", surroundings))
        {
            reading = OptionsJson.Read(stream);
        }

        return reading.Options ?? throw new UsageError($"'{path}' holds no options that can be used:", reading.Problems.Select(problem => problem.ToString()));
    }

    private static BodyPlanWeight PlanWeight(string word, double weight) =>
        new(plans.TryFind(word, out BodyPlan plan) ? plan : throw new InvalidOperationException(word), weight);

    private static (T Min, T Max) Ends<T>(ParsedArguments arguments, string option, string text, Func<string, T?> read)
        where T : struct, IComparable<T>
    {
        string[] ends = text.Split('-', 3);
        T? least = read(ends[0].Trim());
        T? most = read(ends[^1].Trim());
        if (ends.Length > 2 || least is not T first || most is not T last)
        {
            throw arguments.Wrong(option, text, "a number, or the least and the greatest with a dash between them");
        }

        return first.CompareTo(last) <= 0 ? (first, last) : throw arguments.Wrong(option, text, "the smaller number first");
    }

    private static List<(string Word, double Weight)> Weights(ParsedArguments arguments, string option, string text, IReadOnlyList<string> words)
    {
        var weights = new List<(string Word, double Weight)>();
        foreach (string part in text.Split(','))
        {
            string[] sides = part.Split('=', 2);
            string word = sides[0].Trim();
            if (!words.Contains(word))
            {
                throw arguments.Wrong(option, word, "one of " + string.Join(", ", words) + Suggestion.For(word, words));
            }

            if (sides.Length < 2 || Number(sides[1].Trim()) is not double weight)
            {
                throw arguments.Wrong(option, part.Trim(), $"a weight 0..1000, such as {word}=5");
            }

            if (weights.Any(pair => pair.Word == word))
            {
                throw arguments.Wrong(option, text, $"{word} once");
            }

            weights.Add((word, weight));
        }

        return weights;
    }

    private static double? Number(string text) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number) ? number : null;

    private static int? Whole(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : null;

    private static void Require(ParsedArguments arguments, CreatureOptions options)
    {
        IReadOnlyList<Problem> problems = options.Validate();
        if (problems.Count == 1)
        {
            throw arguments.Wrong(Told(problems[0]));
        }

        if (problems.Count > 1)
        {
            throw new UsageError(arguments.Wrong("the options are not valid:").Message, problems.Select(Told));
        }
    }

    /// <summary>A problem by the name of its option on the command line.</summary>
    private static string Told(Problem problem)
    {
        string field = problem.Path.Split('[', '.')[0];
        string option = field switch
        {
            "kind" => "--kind",
            "minScale" or "maxScale" => "--scale",
            "minLegPairs" or "maxLegPairs" => "--leg-pairs",
            "bodyPlans" => "--plans",
            "baseBodies" => "--bodies",
            "palette" => "--palette",
            "ornaments" => "--ornaments",
            "triangleBudget" => "--triangles",
            _ => problem.Path,
        };
        return option + ": " + problem;
    }
}
