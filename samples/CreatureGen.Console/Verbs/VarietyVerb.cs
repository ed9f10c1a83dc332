using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Preview.Sheets;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Measures how different the creatures of seeds are from one another.</summary>
internal sealed class VarietyVerb : IVerb
{
    private const int CellWidth = 240;

    private static readonly OptionSyntax plot = new("--plot", "FILE", "draw the most alike pairs, each side by side (PNG)");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "variety",
        null,
        "measure how different the creatures of seeds are",
        [
            new("variety --seeds 1-200 --kind walking", "doubles, effective combinations, chimeras among 200 walkers"),
            new("variety --seeds 1-200 --strangeness 0 --plot pairs.png", "the same of animals, and a picture of the most alike"),
            new("variety --seeds 1-1000 --kind flying --json > variety.json", "for a script"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, plot, .. CreatureArguments.Syntax, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        SpecimenList specimens = SeedOptions.Specimens(arguments, seeds, options);
        int threads = CommonOptions.ReadThreads(arguments);
        string? path = arguments.Value(plot.Name) is string file ? surroundings.Locate(file) : null;
        if (path != null)
        {
            FileSet.RequireWritable(path, surroundings);
        }

        var study = new VarietyStudy();
        var added = new List<Specimen>();
        using (var progress = new ProgressLine(surroundings, "creatures", specimens.Count, ProgressKind.Shown))
        {
            OrderedWork<Specimen, (Specimen Specimen, Creature Creature)>.Run(specimens, threads, specimen => (specimen, Grow(specimen, options)), grown =>
            {
                study.Add(grown.Creature);
                added.Add(grown.Specimen);
                progress.Step();
            }, surroundings.Cancellation);
        }

        VarietyReport report = study.Report();
        if (arguments.Has(CommonOptions.Json.Name))
        {
            VarietyText.WriteJson(surroundings.Out, report, added);
        }
        else
        {
            VarietyText.Write(surroundings.Out, report, added);
        }

        if (path != null)
        {
            Draw(path, report, added, options, threads, surroundings);
        }

        return ExitCode.Done;
    }

    private static Creature Grow(Specimen specimen, CreatureOptions options) => CreatureAssembler.Assemble(Growing.Sample(specimen.Seed, specimen.Of(options)));

    private static void Draw(string path, VarietyReport report, List<Specimen> added, CreatureOptions options, int threads, Surroundings surroundings)
    {
        SheetCell[] cells = report.Nearest.SelectMany(pair => new[] { Cell(pair.First, pair), Cell(pair.Second, pair) }).ToArray();
        if (cells.Length == 0)
        {
            throw new UsageError("one creature has no pair to draw; expected more seeds");
        }

        Picture sheet = ContactSheet.Render(cells, new ContactSheetOptions { Columns = 6, CellWidth = CellWidth, CellHeight = CellWidth * 14 / 17, Threads = threads, LabelSize = LabelSize.Small }, surroundings.Cancellation);
        byte[] png = PngWriter.ToBytes(sheet);
        FileSet.Write(path, stream => stream.Write(png), surroundings);

        SheetCell Cell(int number, LikePair pair) => new(
            FormattableString.Invariant($"{added[number].Name}  {pair.Likeness:0.00}"),
            (width, height) => Portrait.Take(Grow(added[number], options), View.ThreeQuarter, new RenderOptions { Width = width, Height = height, Threads = 1 }));
    }
}
