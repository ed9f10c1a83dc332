using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Verbs;

/// <summary>Writes a page of creatures and their files, for any web server or none.</summary>
internal sealed class GalleryVerb : IVerb
{
    // So many creatures, each with its picture, still make a page that browsers show at once.
    private const int MaxCreatures = 10_000;
    private const string Page = "index.html";

    private static readonly (int Width, int Height) defaultSize = (640, 480);
    private static readonly OptionSyntax folder = new("--out", "DIR", "folder of the page and the files, made if it is missing") { Short = "-o" };

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "gallery",
        null,
        "write a page of creatures, with the picture, GLB and blueprint of each, that needs nothing but its folder",
        [
            new("gallery --seeds 1-36 --out site", "open site/index.html, or put the folder on any web server"),
            new("gallery --seeds 1-24 --kind flying --clips all --out fliers", "with their motion in the files"),
            new("gallery --seed 101 --individuals 1-12 --out herd", "one species"),
        ],
        [
            SeedOptions.Seed, SeedOptions.Seeds, SeedOptions.Individual, SeedOptions.Individuals, folder, .. CreatureArguments.Syntax, .. ExportOptions.Syntax,
            PictureOptions.Size with { Meaning = "pixels of a picture, 16x16 to 4096x4096 (default 640x480)" }, CommonOptions.Threads, CommonOptions.Quiet,
        ]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string place = surroundings.Locate(arguments.Required(folder.Name));
        (int width, int height) = PictureOptions.ReadSize(arguments, defaultSize);
        var task = new CreatureTask(CreatureArguments.Read(arguments, surroundings), ExportOptions.Read(arguments, GlbExport.Default), ExportOptions.ReadClips(arguments, ClipChoice.None), PictureOrder.Portrait with { Width = width, Height = height }, DatasetOrder.None);
        SpecimenList specimens = SeedOptions.Specimens(arguments, SeedOptions.Read(arguments), task.Options);
        if (specimens.Count > MaxCreatures || place == Surroundings.Standard)
        {
            throw arguments.Wrong(place == Surroundings.Standard ? $"{folder.Name} {place}; expected a folder" : $"a page of {specimens.Count} creatures; expected at most {Units.Count(MaxCreatures)}");
        }

        FileSet.MakeFolder(place, surroundings);
        var made = new List<GeneratedCreature>();
        int missing = 0;
        using var progress = new ProgressLine(surroundings, "creatures", specimens.Count, ProgressKind.Shown);
        OrderedWork<Specimen, GenerationResult>.Run(specimens, CommonOptions.ReadThreads(arguments), specimen => CreatureMaking.Try(specimen, task, place, 1, surroundings), result =>
        {
            if (result is GeneratedCreature creature)
            {
                made.Add(creature);
            }
            else
            {
                Complaint.Tell(surroundings, ((MissingCreature)result).Reason);
                missing++;
            }

            progress.Step();
        }, surroundings.Cancellation);
        progress.Dispose();
        string path = Path.Combine(place, Page);
        FileSet.Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(GalleryPage.Of(made))), surroundings);
        surroundings.Out.WriteLine($"{path}: {Units.Count(made.Count)} creatures, {Units.Bytes(made.Sum(creature => creature.Files.Sum(file => (long)file.Bytes)))}{(missing == 0 ? "" : $", {Units.Count(missing)} missing")}");
        return missing == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }
}
