using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Threading;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Batches;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Verbs;

/// <summary>Writes the creatures of seeds.</summary>
internal sealed class GenerateVerb : IVerb
{
    private const int MaxMeasured = 4;

    private static readonly OptionSyntax folder = new("--out", "DIR", "folder for the files, made if it is missing (default: the current one); - for the GLB alone of one creature, to the standard output") { Short = "-o" };
    private static readonly OptionSyntax failFast = new("--fail-fast", null, "end at the first seed that gives no creature (default: tell, go on, and exit with 1)");
    private static readonly OptionSyntax dryRun = new("--dry-run", null, "tell which files would be written, how large and how soon by the measure of a few, and write none");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "generate",
        null,
        "write creature-<seed>.glb, .png and .json for each seed, creature-<seed>-<individual> for individuals",
        [
            new("generate --seed 7", "one creature in the current folder"),
            new("generate --seed 7 --textures none", "small: colours in the vertices alone"),
            new("generate --seed 7 --clips all", "with its motion: idle, every gait, turns, starts and stops, flight, swimming, every act"),
            new("generate --seeds 1-100 --kind flying --out birds", "a hundred fliers in a folder"),
            new("generate --seeds 1-20 --plans hexapod=1000 --palette vivid --ornaments rich", "mostly six legs, bright, with horns and spikes"),
            new("generate --seed 101 --individuals 1-12 --out herd", "twelve individuals of one species, young and old"),
            new("generate -s 7 --views all --picture-size 512x512 --transparent", "its pictures from five sides, to be put on anything"),
            new("generate -s 7 -k flying -o - > flier.glb", "one GLB to the standard output"),
            new("generate --seeds 0xBEEF,12 --options herd.json --no-picture --json", "options from a file, results as JSON"),
            new("generate --seeds 1-1000 --dataset 8 --out set", "a data set: eight sides of each with depth, normals, parts and joints"),
            new("generate --seeds 1-100000 --out farm --shard 3/64 --resume", "one of 64 tasks; what it did before it was ended stays"),
        ],
        [
            SeedOptions.Seed, SeedOptions.Seeds, SeedOptions.Individual, SeedOptions.Individuals, folder, .. CreatureArguments.Syntax, .. ExportOptions.Syntax, .. PictureOptions.Syntax,
            .. BatchOptions.Syntax, dryRun, failFast, CommonOptions.Threads, CommonOptions.Json, CommonOptions.Quiet,
        ]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        SeedList seeds = SeedOptions.Read(arguments);
        var task = new CreatureTask(CreatureArguments.Read(arguments, surroundings), ExportOptions.Read(arguments, GlbExport.Default), ExportOptions.ReadClips(arguments, ClipChoice.None), PictureOptions.Read(arguments), PictureOptions.ReadDataset(arguments));
        var work = new Work(
            SeedOptions.Specimens(arguments, seeds, task.Options),
            task,
            surroundings.Locate(arguments.Value(folder.Name) ?? "."),
            BatchOptions.Read(arguments, PictureOptions.WantsDataset(arguments) ? ManifestNeed.Always : ManifestNeed.AsAskedFor, surroundings),
            CommonOptions.ReadThreads(arguments),
            arguments.Has(failFast.Name) ? AtProblem.End : AtProblem.GoOn,
            arguments.Has(CommonOptions.Json.Name) ? ReportForm.Json : ReportForm.Text);
        return work.Folder == Surroundings.Standard ? Pipe(arguments, work, surroundings) : arguments.Has(dryRun.Name) ? Plan(work, surroundings) : Run(work, surroundings);
    }

    private static int Run(Work work, Surroundings surroundings)
    {
        FileSet.MakeFolder(work.Folder, surroundings);
        using ManifestJournal? journal = work.Batch.Shard is Shard shard ? ManifestJournal.Begin(work.Folder, Batch.Of(work.Specimens, work.Task), shard, work.Batch.Existing, surroundings) : null;

        // On a terminal the report itself shows how far the work is.
        using var progress = new ProgressLine(surroundings, "creatures", work.Count, surroundings.OutIsTerminal ? ProgressKind.Hidden : ProgressKind.Shown);
        using IGenerationReport report = work.Report == ReportForm.Json ? new GenerationJson(surroundings.Out) : work.IsPlain ? new GenerationSummary(surroundings.Out) : new GenerationList(surroundings);
        int missing = 0;
        OrderedWork<Specimen, GenerationResult>.Run(work.Share, work.Count == 1 ? 1 : work.Threads, specimen => Keeps(specimen, work, journal) ? new KeptCreature(specimen) : Generate(specimen, work, surroundings), result =>
        {
            missing += result is MissingCreature ? 1 : 0;
            journal?.Add(result);
            report.Add(result);
            progress.Step();
        }, surroundings.Cancellation);
        journal?.Complete();
        progress.Dispose();
        report.End();
        return missing == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static int Pipe(ParsedArguments arguments, Work work, Surroundings surroundings)
    {
        if (!work.IsPlain || arguments.Has(dryRun.Name) || work.Report == ReportForm.Json)
        {
            throw arguments.Wrong($"{folder.Name} {Surroundings.Standard} takes one GLB; expected one seed, and neither a batch, {dryRun.Name} nor {CommonOptions.Json.Name}");
        }

        MadeCreature made = (work.Task with { Pictures = PictureOrder.None }).Make(work.Specimens.First(), work.Threads, surroundings.Abandonment);
        FileSet.Write(Surroundings.Standard, stream => stream.Write(made.Contents.First(content => content.Form == "glb").Content), surroundings);
        return ExitCode.Done;
    }

    private static bool Keeps(Specimen specimen, Work work, ManifestJournal? journal) =>
        work.Batch.Existing == Existing.Skip ? work.Paths(specimen).All(File.Exists) : journal?.Keeps(specimen) == true;

    private static GenerationResult Generate(Specimen specimen, Work work, Surroundings surroundings)
    {
        int threads = work.Count == 1 ? work.Threads : 1;
        Surroundings place = surroundings with { Durability = work.Batch.Shard is null ? Durability.OnDisk : Durability.LookedAtLater };
        return work.IsPlain || work.AtProblem == AtProblem.End ? CreatureMaking.Make(specimen, work.Task, work.Folder, threads, place) : CreatureMaking.Try(specimen, work.Task, work.Folder, threads, place);
    }

    /// <summary>Tells the files that are not there yet, a line each, and how large they will be, by a few creatures that are made and not written.</summary>
    private static int Plan(Work work, Surroundings surroundings)
    {
        Func<Specimen, bool> isKept = work.Batch switch
        {
            { Existing: Existing.Skip } => specimen => work.Paths(specimen).All(File.Exists),
            { Shard: Shard shard } => ManifestJournal.Foresee(work.Folder, Batch.Of(work.Specimens, work.Task), shard, work.Batch.Existing, surroundings),
            _ => _ => false,
        };
        long creatures = 0;
        var measured = new List<Specimen>();
        foreach (Specimen specimen in work.Share.Where(specimen => !isKept(specimen)))
        {
            surroundings.Cancellation.ThrowIfCancellationRequested();
            foreach (string path in work.Paths(specimen))
            {
                surroundings.Out.WriteLine(path);
            }

            // The first, the second, the fourth, the eighth…
            if (BitOperations.IsPow2(++creatures))
            {
                measured.Add(specimen);
            }
        }

        PlanText.Write(surroundings.Telling(Surroundings.Standard), creatures, creatures * work.Task.Forms.Count(), measured.TakeLast(MaxMeasured).Select(specimen => Measure(specimen, work, surroundings.Abandonment)).OfType<MadeCreature>().ToArray());
        return ExitCode.Done;
    }

    private static MadeCreature? Measure(Specimen specimen, Work work, CancellationToken cancellation)
    {
        try
        {
            return work.Task.Make(specimen, 1, cancellation);
        }
        catch (ImpossibleSeed)
        {
            return null;
        }
    }

    /// <summary>What becomes of a batch when a seed gives no creature.</summary>
    private enum AtProblem
    {
        GoOn,
        End,
    }

    private enum ReportForm
    {
        Text,
        Json,
    }

    private sealed record Work(SpecimenList Specimens, CreatureTask Task, string Folder, BatchOptions Batch, int Threads, AtProblem AtProblem, ReportForm Report)
    {
        private Shard Shard => Batch.Shard ?? Shard.Whole;

        /// <summary>The creatures of this run.</summary>
        public IEnumerable<Specimen> Share => Shard.Of(Specimens);

        /// <summary>How many they are.</summary>
        public UInt128 Count => Shard.CountOf(Specimens.Count);

        /// <summary>Whether it is no batch: one creature, of which all is told.</summary>
        public bool IsPlain => Specimens.Count == 1 && Batch is { Shard: null, Existing: Existing.Replace };

        /// <summary>The files of a creature.</summary>
        public IEnumerable<string> Paths(Specimen specimen) => Task.Forms.Select(form => CreatureFiles.PathOf(Folder, specimen.Name, form));
    }
}
