using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Evolving;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Genetics.Populations;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using CreatureGen.Seeding;

namespace CreatureGen.Console.Verbs;

/// <summary>Breeds a population on towards a goal.</summary>
internal sealed class EvolveVerb : IVerb
{
    private const int MaxGenerations = 100_000;

    /// <summary>Generations from a sheet to the next.</summary>
    private const int SheetEvery = 10;

    /// <summary>Seeds that are tried for each founder where options rule some out.</summary>
    private const int SeedsPerFounder = 50;

    private static readonly ISelection[] selections = [new TournamentSelection(), new NoveltySelection(), new NicheSelection()];
    private static readonly string[] selectionWords = Array.ConvertAll(selections, one => one.Name);

    private static readonly OptionSyntax population = new("--population", "N", "creatures of a generation, 2 to 10000 (default 64)");
    private static readonly OptionSyntax generations = new("--generations", "N", "generations after the founders, 0 to 100000 (default 40)");
    private static readonly OptionSyntax selection = new("--selection", "WAY", "tournament (the default), novelty (the default towards distinct alone), or niches: the best of each size, number of legs and length") { Words = selectionWords };
    private static readonly OptionSyntax mutation = new("--mutation", "M", "how much children differ from what they inherit, 0 to 1 (default 0.35)");
    private static readonly OptionSyntax seed = new("--seed", "N", "which founders, and which course of evolution (default 1)");
    private static readonly OptionSyntax parents = new("--parents", "LIST", "founders of one's own with commas between them: seeds, ranges of seeds, blueprints, GLB files");
    private static readonly OptionSyntax picks = new("--picks", "LIST", "creatures that you like, for --towards picks: first digits of their numbers on the sheets, seeds or files");
    private static readonly OptionSyntax folder = new("--out", "DIR", "folder of the run, made if it is missing; a run that is there already goes on") { Short = "-o" };

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "evolve",
        null,
        "breed a population on towards a goal: a sheet of each tenth generation, a family tree, a curve, lineage.json and the blueprint of everybody",
        [
            new("evolve --towards fast --kind walking --out runners", "64 walkers, 40 generations; stopped, it goes on where it was"),
            new("evolve --towards like:giraffe.png,stable=0.5 --generations 80 --out giraffes", "towards an outline from the side, without falling over"),
            new("evolve --towards tall --selection niches --out zoo", "the tallest of each size, number of legs and length"),
            new("evolve --towards picks --picks 3fa2,91c0 --generations 3 --out garden", "go on with what you like on the last sheet"),
        ],
        [GoalReader.Option, population, generations, selection, mutation, seed, parents, picks, folder, .. CreatureArguments.Syntax, CommonOptions.View, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        var place = new EvolutionFolder(surroundings.Locate(arguments.Required(folder.Name)), surroundings);
        int last = arguments.Whole(generations.Name, 0, MaxGenerations, 40);
        IReadOnlyList<CreatureBlueprint> liked = ReadPicks(arguments, place, surroundings);
        WantedGoal wanted = GoalReader.Read(arguments, liked, surroundings);
        EvolutionSettings settings = ReadSettings(arguments, wanted.Goal);
        CreatureBlueprint[] founders = ReadFounders(arguments, settings, surroundings);
        var work = new EvolutionWork { Threads = CommonOptions.ReadThreads(arguments), Cancellation = surroundings.Cancellation };
        var pictures = new EvolutionPictures(wanted.Text, CommonOptions.ReadView(arguments), work.Threads, surroundings);
        IReadOnlyList<(string Name, string Value)> told = Told(settings, wanted, founders);
        EvolutionRun? run = place.HasRun ? TakeUp(place, wanted.Goal, told, liked, last, work) : null;
        place.Make();
        place.Keep(liked);
        ulong[] likedNumbers = liked.Select(BlueprintIdentity.Of).ToArray();
        int missing = (last - (run?.Now.Number ?? -1)) * settings.Population;
        using (var progress = new ProgressLine(surroundings, "creatures", (UInt128)missing, ProgressKind.Shown))
        {
            EvolutionWork shown = work with { Progress = progress.Step };
            run = run ?? Save(place, EvolutionRun.Started(told, likedNumbers, Found(founders, wanted.Goal, settings, shown)), pictures);
            while (run.Now.Number < last)
            {
                run = Save(place, run.With(Evolution.Next(run.Now, wanted.Goal, settings, shown)), pictures);
            }
        }

        IReadOnlyList<CreatureFile> files = Finish(place, run, pictures);
        if (arguments.Has(CommonOptions.Json.Name))
        {
            EvolutionText.WriteJson(surroundings.Out, run, files);
        }
        else
        {
            EvolutionText.Write(surroundings.Out, run, files, SheetEvery);
        }

        return ExitCode.Done;
    }

    private static EvolutionSettings ReadSettings(ParsedArguments arguments, Goal goal)
    {
        string word = arguments.Value(selection.Name) ?? (goal.Parts.All(part => part.Criterion.Input == CriterionInput.Company) ? "novelty" : "tournament");
        ISelection chosen = Array.Find(selections, one => one.Name == word) ?? throw arguments.Wrong(selection.Name, word, "one of " + string.Join(", ", selectionWords) + Suggestion.For(word, selectionWords));
        ulong number = arguments.Value(seed.Name) is not string text ? 1 : SeedText.TryRead(text, out ulong read) ? read : throw arguments.Wrong(seed.Name, text, SeedText.Expectation);
        return new EvolutionSettings
        {
            Population = arguments.Whole(population.Name, 2, EvolutionSettings.MaxIndividuals, 64),
            Seed = number,
            Breeding = new BreedingSettings { Mutation = arguments.Number(mutation.Name, 0, 1, 0.35) },
            Selection = chosen,
        };
    }

    private static CreatureBlueprint[] ReadFounders(ParsedArguments arguments, EvolutionSettings settings, Surroundings surroundings)
    {
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        if (arguments.Value(parents.Name) is not string list)
        {
            return Sampled(options, settings).ToArray();
        }

        var founders = new List<CreatureBlueprint>();
        foreach (string item in list.Split(',').Select(item => item.Trim()))
        {
            bool isSeeds = item.Length > 0 && (char.IsAsciiDigit(item[0]) || item[0] == '-') && !item.Contains('.', StringComparison.Ordinal);
            founders.AddRange(isSeeds ? SeedList.Read(item).Take(settings.Population + 1).Select(number => Growing.Sample(number, options)) : [Parent.Read(item, surroundings).Blueprint]);
        }

        return founders.Count <= settings.Population ? founders.ToArray() : throw arguments.Wrong(parents.Name, list, string.Create(CultureInfo.InvariantCulture, $"at most {settings.Population} creatures, the population"));
    }

    private static IEnumerable<CreatureBlueprint> Sampled(CreatureOptions options, EvolutionSettings settings)
    {
        Seed root = new Seed(settings.Seed).Child("founders");
        int found = 0;
        for (int i = 0; found < settings.Population; i++)
        {
            CreatureBlueprint? founder = null;
            try
            {
                founder = Growing.Sample(root.Child(i).Value, options);
                found++;
            }
            catch (ImpossibleSeed) when (i < SeedsPerFounder * settings.Population)
            {
                // Another seed has a creature that meets the options.
            }

            if (founder != null)
            {
                yield return founder;
            }
        }
    }

    private static IReadOnlyList<CreatureBlueprint> ReadPicks(ParsedArguments arguments, EvolutionFolder place, Surroundings surroundings)
    {
        if (arguments.Value(picks.Name) is not string list)
        {
            return place.Picked();
        }

        var liked = new List<CreatureBlueprint>();
        foreach (string item in list.Split(',').Select(item => item.Trim()))
        {
            bool isNumber = item.Length >= 4 && item.All(char.IsAsciiHexDigitLower);
            liked.Add(isNumber && place.Find(item) is ulong identity ? place.Creature(identity) : Parent.Read(item, surroundings).Blueprint);
        }

        return liked;
    }

    /// <summary>What makes a run the run that it is. The number of generations may grow, threads and view may change, and so may picks.</summary>
    private static (string Name, string Value)[] Told(EvolutionSettings settings, WantedGoal wanted, CreatureBlueprint[] founders) =>
    [
        ("towards", wanted.Text),
        ("target", wanted.Target),
        ("population", settings.Population.ToString(CultureInfo.InvariantCulture)),
        ("mutation", settings.Breeding.Mutation.ToString(CultureInfo.InvariantCulture)),
        ("selection", settings.Selection.Name),
        ("seed", SeedText.Of(settings.Seed)),
        ("founders", string.Join(' ', founders.Select(founder => HashText.Of(BlueprintIdentity.Of(founder))))),
        ("algorithm", CreatureBlueprint.CurrentAlgorithm.ToString(CultureInfo.InvariantCulture)),
    ];

    private static EvolutionRun TakeUp(EvolutionFolder place, Goal goal, IReadOnlyList<(string Name, string Value)> told, IReadOnlyList<CreatureBlueprint> liked, int last, EvolutionWork work)
    {
        EvolutionRun run = place.Load(goal);
        foreach ((string name, string value) in told)
        {
            string there = run.Settings.FirstOrDefault(setting => setting.Name == name).Value ?? "nothing";
            if (there != value)
            {
                throw new UsageError(name is "founders" or "target"
                    ? $"the run in '{place.Lineage}' has other {(name == "target" ? "outlines" : "founders")}; expected the same, or another folder"
                    : $"the run in '{place.Lineage}' has {name} {there}; expected the same instead of {value}, or another folder");
            }
        }

        if (run.Now.Number > last)
        {
            throw new UsageError(string.Create(CultureInfo.InvariantCulture, $"the run in '{place.Lineage}' has {run.Now.Number} generations; expected --generations {run.Now.Number} or more, or another folder"));
        }

        ulong[] numbers = liked.Select(BlueprintIdentity.Of).ToArray();
        return numbers.Length == 0 || numbers.SequenceEqual(run.Picks) ? run : run with { Picks = numbers, Now = Evolution.Judge(run.Now, goal, work) };
    }

    private static Generation Found(CreatureBlueprint[] founders, Goal goal, EvolutionSettings settings, EvolutionWork work)
    {
        try
        {
            return Evolution.Found(founders, goal, settings, work);
        }
        catch (ArgumentException problem)
        {
            throw new UsageError(problem.Message.Split(" (Parameter", 2)[0]);
        }
    }

    private static EvolutionRun Save(EvolutionFolder place, EvolutionRun run, EvolutionPictures pictures)
    {
        var files = new List<(string Name, byte[] Content)>();
        if (run.Now.Number % SheetEvery == 0)
        {
            files.Add((SheetOf(run.Now.Number), pictures.Sheet(run.Now)));
        }

        place.Save(run, files);
        return run;
    }

    private static string SheetOf(int generation) => string.Create(CultureInfo.InvariantCulture, $"generation-{generation:000}.png");

    private static CreatureFile[] Finish(EvolutionFolder place, EvolutionRun run, EvolutionPictures pictures)
    {
        Creature best = CreatureAssembler.Assemble(run.Now.Best.Blueprint);
        (string Form, string Name, byte[] Content)[] files =
        [
            ("sheet", SheetOf(run.Now.Number), pictures.Sheet(run.Now)),
            ("tree", "family-tree.png", pictures.FamilyTree(run, place.Creature)),
            ("curve", "curve.png", pictures.Curve(run)),
            ("glb", "best.glb", CreatureFiles.Glb(best, GltfOptions.Default, ClipChoice.None)),
            ("json", "best.json", CreatureFiles.Json(best.Blueprint)),
        ];
        place.Save(run, files.Select(file => (file.Name, file.Content)).ToArray());
        return [.. files.Select(file => CreatureFile.Of(file.Form, place.PathOf(file.Name), file.Content)), CreatureFile.Of("lineage", place.Lineage, System.IO.File.ReadAllBytes(place.Lineage))];
    }
}
