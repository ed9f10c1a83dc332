using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;

namespace CreatureGen.Console.Evolving;

/// <summary>What somebody wants creatures to become.</summary>
/// <param name="Goal">The criteria.</param>
/// <param name="Text">What was typed.</param>
/// <param name="Target">The number of what creatures are to be like, so that a changed file is noticed; empty where they are to be like nothing.</param>
internal sealed record WantedGoal(Goal Goal, string Text, string Target);

/// <summary>Reads criteria as people write them: <c>fast</c>, <c>fast,stable=0.5</c>, <c>like:giraffe.png</c>.</summary>
internal static class GoalReader
{
    /// <summary>The criterion that needs a file, and the one that needs picks.</summary>
    public const string Like = "like:";
    public const string Picks = "picks";

    /// <summary>The option.</summary>
    public static readonly OptionSyntax Option = new("--towards", "LIST", "what is wanted: " + string.Join(", ", Names) + " (an outline as PNG, or a creature), each with a weight 0 to 1 if it is not 1: fast,stable=0.5")
    {
        Words = CriterionCatalogue.All.Select(criterion => criterion.Name).Append(Picks).ToArray(),
    };

    private static IEnumerable<string> Names => CriterionCatalogue.All.Select(criterion => criterion.Name).Append(Picks).Append(Like + "FILE");

    /// <summary>Reads the criteria.</summary>
    /// <param name="arguments">Which hold the option.</param>
    /// <param name="picks">The creatures that somebody picked.</param>
    /// <param name="surroundings">Where files are.</param>
    /// <exception cref="UsageError">A criterion is unknown, a weight is out of its range, or a file cannot be used.</exception>
    public static WantedGoal Read(ParsedArguments arguments, IReadOnlyList<CreatureBlueprint> picks, Surroundings surroundings)
    {
        string text = arguments.Required(Option.Name);
        var parts = new List<WeightedCriterion>();
        string target = "";
        foreach (string item in text.Split(',').Select(item => item.Trim()))
        {
            int equals = item.LastIndexOf('=');
            string name = equals < 0 ? item : item[..equals];
            double weight = equals < 0 ? 1 : WeightOf(arguments, item[(equals + 1)..], item);
            if (parts.Any(part => part.Criterion.Name == name || (part.Criterion.Name == "like" && name.StartsWith(Like, StringComparison.Ordinal))))
            {
                throw arguments.Wrong(Option.Name, text, (name.StartsWith(Like, StringComparison.Ordinal) ? Like + "FILE" : name) + " once");
            }

            ICriterion criterion;
            if (name.StartsWith(Like, StringComparison.Ordinal) && name.Length > Like.Length)
            {
                (criterion, target) = LikenessTo(name[Like.Length..], surroundings);
            }
            else
            {
                criterion = name == Picks ? new PicksCriterion(picks) : CriterionCatalogue.Find(name) ?? throw arguments.Wrong(Option.Name, name, "of " + string.Join(", ", Names) + Suggestion.For(name, Option.Words));
            }

            parts.Add(new WeightedCriterion(criterion, weight));
        }

        return new WantedGoal(new Goal(parts), text, target);
    }

    private static double WeightOf(ParsedArguments arguments, string weight, string item) =>
        double.TryParse(weight, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double number) && number is > 0 and <= 1
            ? number
            : throw arguments.Wrong(Option.Name, item, "a weight above 0 and up to 1 after =");

    private static (ICriterion Criterion, string Target) LikenessTo(string file, Surroundings surroundings)
    {
        if (SeedText.TryRead(file, out _))
        {
            return LikenessTo(Parent.Read(file, surroundings).Blueprint);
        }

        byte[] content;
        using (Stream stream = SourceFile.Open(surroundings.Locate(file), "an outline (.png) or a creature (.json, .glb)", surroundings))
        {
            using var memory = new MemoryStream();
            stream.CopyTo(memory);
            content = memory.ToArray();
        }

        if (!PngReader.IsPng(content) && !file.EndsWith(".png", StringComparison.OrdinalIgnoreCase))
        {
            return LikenessTo(CreatureSource.Read(file, surroundings).Blueprint);
        }

        try
        {
            return (new SilhouetteCriterion(Cutout.Of(PngReader.Read(content))), Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(content)));
        }
        catch (Exception problem) when (problem is InvalidDataException or ArgumentException)
        {
            string reason = problem.Message.Split(" (Parameter", 2)[0];
            throw new UsageError($"cannot use '{file}' as an outline: {reason}");
        }
    }

    private static (ICriterion Criterion, string Target) LikenessTo(CreatureBlueprint blueprint) =>
        (new ProportionsCriterion(BodyMeasures.Of(CreatureAssembler.Assemble(blueprint))), HashText.Of(BlueprintIdentity.Of(blueprint)));
}
