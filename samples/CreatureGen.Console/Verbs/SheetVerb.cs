using System;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Preview.Sheets;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Draws many creatures on one picture.</summary>
internal sealed class SheetVerb : IVerb
{
    private const int DefaultColumns = 6;
    private const int DefaultSize = 340;
    private const int MinSize = 32;
    private const int MaxSize = 4096;
    private const int MaxPixels = 100_000_000;

    private static readonly OptionSyntax skeleton = new("--skeleton", null, "show the bones through the skin");
    private static readonly OptionSyntax face = new("--face", null, "show the heads alone, close");
    private static readonly OptionSyntax rest = new("--rest", null, "show them as they were built, instead of on their way");
    private static readonly OptionSyntax columns = new("--columns", "N", "creatures in a row, 1 to 200 (default 6)");
    private static readonly OptionSyntax size = new("--size", "PIXELS", "width of one creature's picture, 32 to 4096 (default 340)");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "sheet",
        null,
        "draw the creatures of seeds on one picture",
        [
            new("sheet --seeds 1-36 --out sheet.png", "a first look at many"),
            new("sheet --seeds 1-24 --kind swimming --view side --out swimmers.png", "swimmers from the side"),
            new("sheet --seed 101 --individuals 1-36 --out family.png", "one species, young and old"),
            new("sheet --seeds 1-12 --face --columns 4 --out faces.png", "their heads"),
            new("sheet --seeds 1-10 --act bite --out bites.png", "ten creatures in an act, six moments of it each"),
            new("sheet --seeds 1-4 --skeleton --columns 2 --size 640 --out bones.png", "four skeletons, large"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, SeedOptions.Individual, SeedOptions.Individuals, CommonOptions.OutFile with { Meaning = "the picture to write (PNG)" }, CommonOptions.View, face, skeleton, rest, ActArguments.Act with { Meaning = "show six moments of an act, a row for each creature that can do it: " + ActArguments.Act.Meaning }, CommonOptions.Flat, columns, size, .. CreatureArguments.Syntax, CommonOptions.Threads, CommonOptions.Quiet]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        SpecimenList specimens = SeedOptions.Specimens(arguments, seeds, options);
        int width = arguments.Whole(size.Name, MinSize, MaxSize, DefaultSize);
        string? act = arguments.Value(ActArguments.Act.Name);
        var layout = new ContactSheetOptions
        {
            Columns = arguments.Whole(columns.Name, 1, 200, act == null ? DefaultColumns : ActRow.Moments),
            CellWidth = width,
            CellHeight = Math.Max(1, width * 14 / 17),
            Threads = CommonOptions.ReadThreads(arguments),
            LabelSize = width >= 2 * DefaultSize ? LabelSize.Medium : LabelSize.Small,
        };
        RequireRoom(arguments, specimens.Count * (UInt128)(act == null ? 1 : ActRow.Moments), layout);
        FileSet.RequireWritable(path, surroundings);
        bool alone = specimens.Count == 1;
        var style = new Style(
            CommonOptions.ReadView(arguments),
            ReadFigure(arguments),
            new RenderOptions { Shading = arguments.Has(CommonOptions.Flat.Name) ? ShadingMode.Faceted : ShadingMode.Smooth, Threads = alone ? layout.Threads : 1 });
        using var progress = new ProgressLine(surroundings, "creatures", specimens.Count, ProgressKind.Shown);
        SheetCell[] cells = act == null
            ? specimens.Select(specimen => Cell(specimen, options, style, progress)).ToArray()
            : specimens.SelectMany(specimen => ActCells(arguments, specimen, options, style, (act, layout), progress)).ToArray();
        Picture sheet = ContactSheet.Render(cells, layout, surroundings.Cancellation);
        byte[] png = PngWriter.ToBytes(sheet);
        progress.Dispose();
        FileSet.Write(path, stream => stream.Write(png), surroundings);
        surroundings.Telling(path).WriteLine(FormattableString.Invariant($"{path}: {cells.Length} {(alone ? "creature" : "creatures")}, {sheet.Width} x {sheet.Height} pixels, {Units.Bytes(png.Length)}"));
        return ExitCode.Done;
    }

    private static Figure ReadFigure(ParsedArguments arguments)
    {
        (OptionSyntax Option, Figure Figure)[] asked = Array.FindAll<(OptionSyntax Option, Figure Figure)>([(face, Figure.Face), (skeleton, Figure.Skeleton), (rest, Figure.SkinAtRest)], one => arguments.Has(one.Option.Name));
        if (asked.Length > 1)
        {
            throw arguments.Wrong($"{asked[0].Option.Name} and {asked[1].Option.Name}; expected one of them");
        }

        if (arguments.Has(ActArguments.Act.Name) && asked.Length > 0)
        {
            throw arguments.Wrong($"--act and {asked[0].Option.Name}; expected one of them");
        }

        return asked.Length > 0 ? asked[0].Figure : Figure.Skin;
    }

    private static void RequireRoom(ParsedArguments arguments, UInt128 count, ContactSheetOptions layout)
    {
        UInt128 rows = (count + (UInt128)layout.Columns - 1) / (UInt128)layout.Columns;
        UInt128 width = UInt128.Min(count, (UInt128)layout.Columns) * (UInt128)layout.CellWidth;
        UInt128 height = rows * (UInt128)layout.CellHeight;
        if (width > Picture.LargestSide || height > Picture.LargestSide || width * height > MaxPixels)
        {
            throw arguments.Wrong(FormattableString.Invariant(
                $"a sheet of {count} creatures would be {width} x {height} pixels; expected at most {Picture.LargestSide} on a side and 100 million in all: fewer seeds, other --columns or a smaller --size"));
        }
    }

    private static SheetCell Cell(Specimen specimen, CreatureOptions options, Style style, ProgressLine progress)
    {
        CreatureBlueprint blueprint = Growing.Sample(specimen.Seed, specimen.Of(options));
        string label = $"{specimen.Name} {WordList<Anatomy.LocomotionKind>.Instance[blueprint.Kind]} {WordList<Anatomy.BodyPlan>.Instance[blueprint.Plan]} {CreatureText.Looks(blueprint.Body.Blend)}";
        return new SheetCell(label, (width, height) =>
        {
            Creature creature = CreatureAssembler.Assemble(blueprint);
            RenderOptions render = style.Render with { Width = width, Height = height };
            Picture picture = style.Figure switch
            {
                Figure.Skeleton => Portrait.TakeSkeleton(creature, style.View, render),
                Figure.Face => Portrait.TakeFace(creature, style.View, render),
                Figure.SkinAtRest => Portrait.TakeAtRest(creature, style.View, render),
                _ => Portrait.Take(creature, style.View, render),
            };
            progress.Step();
            return picture;
        });
    }

    /// <summary>A row of moments of an act; none of a creature that cannot do it.</summary>
    private static SheetCell[] ActCells(ParsedArguments arguments, Specimen specimen, CreatureOptions options, Style style, (string Act, ContactSheetOptions Layout) of, ProgressLine progress)
    {
        CreatureBlueprint blueprint = Growing.Sample(specimen.Seed, specimen.Of(options));
        var profile = new MotionProfile(CreatureAssembler.Assemble(blueprint));
        progress.Step();
        var film = new FilmOptions { Width = of.Layout.CellWidth, Height = of.Layout.CellHeight, View = style.View, Shading = style.Render.Shading };
        string label = $"{specimen.Name} {WordList<Anatomy.BodyPlan>.Instance[blueprint.Plan]} {CreatureText.Looks(blueprint.Body.Blend)}";
        return ActRow.Of(profile, of.Act, label, film, expected => arguments.Wrong(ActArguments.Act.Name, of.Act, expected));
    }

    /// <summary>What of a creature is drawn.</summary>
    private enum Figure
    {
        Skin,
        Skeleton,
        Face,
        SkinAtRest,
    }

    private sealed record Style(View View, Figure Figure, RenderOptions Render);
}
