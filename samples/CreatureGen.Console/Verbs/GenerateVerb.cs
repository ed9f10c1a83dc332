using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Writes the creatures of seeds.</summary>
internal sealed class GenerateVerb : IVerb
{
    private static readonly OptionSyntax folder = new("--out", "DIR", "folder for the files, made if it is missing (default: the current one)");
    private static readonly OptionSyntax failFast = new("--fail-fast", null, "end at the first seed that gives no creature (default: tell, go on, and exit with 1)");
    private static readonly OptionSyntax noPicture = new("--no-picture", null, "write no PNG");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "generate",
        null,
        "write creature-<seed>.glb, .png and .json for each seed, creature-<seed>-<individual> for individuals",
        [
            new("generate --seed 7", "one creature in the current folder"),
            new("generate --seed 7 --textures none", "small: colours in the vertices alone"),
            new("generate --seed 7 --clips all", "with its motion: idle, every gait, flight, swimming, crawling"),
            new("generate --seeds 1-100 --kind flying --out birds", "a hundred fliers in a folder"),
            new("generate --seeds 1-20 --plans hexapod=1000 --palette vivid --ornaments rich", "mostly six legs, bright, with horns and spikes"),
            new("generate --seed 101 --individuals 1-12 --out herd", "twelve individuals of one species, young and old"),
            new("generate --seeds 0xBEEF,12 --options herd.json --no-picture --json", "options from a file, results as JSON"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, SeedOptions.Individual, SeedOptions.Individuals, folder, .. CreatureArguments.Syntax, .. ExportOptions.Syntax, noPicture, failFast, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        int threads = CommonOptions.ReadThreads(arguments);
        SpecimenList specimens = SeedOptions.Specimens(arguments, seeds, options);
        bool one = specimens.Count == 1;
        var task = new Task(
            surroundings.Locate(arguments.Value(folder.Name) ?? "."),
            options,
            ExportOptions.Read(arguments, GlbExport.Default),
            ExportOptions.ReadClips(arguments, ClipChoice.None),
            arguments.Has(noPicture.Name) ? PictureChoice.None : PictureChoice.Portrait,
            one ? threads : 1);
        FileSet.MakeFolder(task.Folder, surroundings);

        // On a terminal the report itself shows how far the work is.
        using var progress = new ProgressLine(surroundings, "creatures", specimens.Count, surroundings.OutIsTerminal ? ProgressKind.Hidden : ProgressKind.Shown);
        using IGenerationReport report = arguments.Has(CommonOptions.Json.Name) ? new GenerationJson(surroundings.Out)
            : one ? new GenerationSummary(surroundings.Out) : new GenerationList(surroundings);
        bool goesOn = !one && !arguments.Has(failFast.Name);
        int missing = 0;
        OrderedWork<Specimen, GenerationResult>.Run(specimens, one ? 1 : threads, specimen => goesOn ? Try(specimen, task, surroundings) : Generate(specimen, task, surroundings), result =>
        {
            missing += result is MissingCreature ? 1 : 0;
            report.Add(result);
            progress.Step();
        }, surroundings.Cancellation);
        progress.Dispose();
        report.End();
        return missing == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static GenerationResult Try(Specimen specimen, Task task, Surroundings surroundings)
    {
        try
        {
            return Generate(specimen, task, surroundings);
        }
        catch (ImpossibleSeed problem)
        {
            return new MissingCreature(specimen, problem.Message);
        }
        catch (InvalidOperationException defect)
        {
            // The library refuses to finish or to write a creature that is not whole.
            return new MissingCreature(specimen, "a defect of CreatureGen: " + defect.Message);
        }
    }

    private static GeneratedCreature Generate(Specimen specimen, Task task, Surroundings surroundings)
    {
        var times = new StageTimes();
        CreatureOptions options = specimen.Of(task.Options);
        CreatureBlueprint blueprint = Growing.Sample(specimen.Seed, options);
        times.Finished("blueprint");
        Creature creature = CreatureAssembler.Assemble(blueprint, times);
        GltfOptions export = CreatureFiles.WithAtlas(creature, task.Export with { Provenance = OptionsJson.Write(options) });
        var contents = new List<(string Form, byte[] Content)> { ("glb", CreatureFiles.Glb(creature, export, task.Clips)) };
        times.Finished("glb");
        if (task.Picture == PictureChoice.Portrait)
        {
            contents.Add(("png", CreatureFiles.Png(creature, export, task.PictureThreads)));
            times.Finished("picture");
        }

        contents.Add(("json", CreatureFiles.Json(blueprint)));
        IReadOnlyList<CreatureFile> files = CreatureFiles.Write(task.Folder, specimen.Name, contents, surroundings);
        times.Finished("files");
        return new GeneratedCreature(CreatureFacts.Of(creature, specimen), files, times);
    }

    private sealed record Task(string Folder, CreatureOptions Options, GltfOptions Export, ClipChoice Clips, PictureChoice Picture, int PictureThreads);
}
