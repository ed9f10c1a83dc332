using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics.Populations;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Plots;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Preview.Sheets;

namespace CreatureGen.Console.Evolving;

/// <summary>The pictures of a run.</summary>
/// <param name="Goal">What was wanted, for the titles.</param>
/// <param name="View">From where creatures are looked at.</param>
/// <param name="Threads">Threads that draw.</param>
/// <param name="Surroundings">Can stop the work.</param>
internal sealed record EvolutionPictures(string Goal, View View, int Threads, Surroundings Surroundings)
{
    private const int SheetCells = 30;
    private const int SheetColumns = 6;
    private const int CellWidth = 260;
    private const int CellHeight = CellWidth * 14 / 17;

    /// <summary>Rows of a family tree above the champion, and creatures in each.</summary>
    private const int TreeRows = 4;
    private const int TreeColumns = 6;

    /// <summary>Least part of a pedigree that is worth a line.</summary>
    private const double MinFraction = 0.1;

    private static readonly Pixel best = new(190, 40, 30);
    private static readonly Pixel median = new(38, 112, 201);

    /// <summary>The best of a generation.</summary>
    public byte[] Sheet(Generation generation)
    {
        SheetCell[] cells = generation.Individuals.Take(SheetCells).Select(one => Cell(string.Create(CultureInfo.InvariantCulture, $"{HashText.ShortOf(one.Identity)}  {one.Score:0.###}"), one.Blueprint)).ToArray();
        var layout = new ContactSheetOptions
        {
            Columns = SheetColumns,
            CellWidth = CellWidth,
            CellHeight = CellHeight,
            Threads = Threads,
            Title = string.Create(CultureInfo.InvariantCulture, $"{Goal}: generation {generation.Number}, {cells.Length} of {generation.Individuals.Count}"),
        };
        return PngWriter.ToBytes(ContactSheet.Render(cells, layout, Surroundings.Cancellation));
    }

    /// <summary>Best and median by generation.</summary>
    public byte[] Curve(EvolutionRun run) => PngWriter.ToBytes(CurvePlot.Draw(
        Goal,
        "generation",
        [new Curve("best", run.Rows.Select(row => row.Best).ToArray(), best), new Curve("median", run.Rows.Select(row => row.Median).ToArray(), median)],
        900,
        420));

    /// <summary>The champion at the bottom, and above it its ancestors a quarter, half, three quarters of the way back from its birth, and the founders.</summary>
    public byte[] FamilyTree(EvolutionRun run, Func<ulong, CreatureBlueprint> find)
    {
        var pedigree = new Pedigree(run);
        ulong champion = run.Now.Best.Identity;
        int last = run.Ancestors.First(one => one.Identity == champion).Born;
        int[] generations = Enumerable.Range(0, TreeRows).Select(row => last * row / TreeRows).Distinct().Where(generation => generation < last).ToArray();
        var rows = new List<DescentRow>();
        IReadOnlyList<PedigreeEntry> above = [];
        foreach (int generation in generations.Append(last))
        {
            PedigreeEntry[] entries = generation == last
                ? [.. pedigree.AncestorsAt(champion, last)]
                : [.. pedigree.AncestorsAt(champion, generation).Take(TreeColumns)];
            Descent[] descents = entries.SelectMany((entry, place) => DescentsOf(pedigree, above, entry, place, rows.Count == 0 ? -1 : generations[rows.Count - 1])).ToArray();
            string name = generation == last ? "champion" : generation == 0 ? "founders" : string.Create(CultureInfo.InvariantCulture, $"generation {generation}");
            rows.Add(new DescentRow(name, entries.Select(entry => Cell(LabelOf(entry), find(entry.Ancestor.Identity))).ToArray(), descents));
            above = entries;
        }

        return PngWriter.ToBytes(DescentChart.Draw(rows, CellWidth, CellHeight, Threads, Surroundings.Cancellation));
    }

    private static IEnumerable<Descent> DescentsOf(Pedigree pedigree, IReadOnlyList<PedigreeEntry> above, PedigreeEntry entry, int place, int generation) =>
        above.Count == 0 ? [] : pedigree.AncestorsAt(entry.Ancestor.Identity, generation)
            .Select(older => new Descent(above.ToList().FindIndex(one => one.Ancestor == older.Ancestor), place, older.Share))
            .Where(descent => descent.Ancestor >= 0 && (descent.Fraction >= MinFraction || above.Count == 1));

    private static string LabelOf(PedigreeEntry entry) =>
        string.Create(CultureInfo.InvariantCulture, $"{HashText.ShortOf(entry.Ancestor.Identity)}  {entry.Ancestor.Score:0.###}  {100 * entry.Share:0} %");

    private SheetCell Cell(string label, CreatureBlueprint blueprint) =>
        new(label, (width, height) => Portrait.Take(CreatureAssembler.Assemble(blueprint), View, new RenderOptions { Width = width, Height = height, Threads = 1 }));
}
