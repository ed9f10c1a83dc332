using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Gltf;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Preview.Sheets;

namespace CreatureGen.Console.Verbs;

/// <summary>Breeds two creatures.</summary>
internal sealed class BreedVerb : IVerb
{
    private const int MaxLitter = 100;
    private const int Columns = 4;
    private const int CellWidth = 340;

    private static readonly OptionSyntax litter = new("--litter", "N", "children, 1 to 100 (default 9)");
    private static readonly OptionSyntax mutation = new("--mutation", "M", "how much children differ from what they inherit, 0 to 1 (default 0.2)");
    private static readonly OptionSyntax seed = new("--seed", "N", "which litter of these parents (default 1)");
    private static readonly OptionSyntax age = new("--age", "A", "how old the children are shown and written, 0 just born to 1 grown (default 1)");
    private static readonly OptionSyntax folder = new("--out", "DIR", "folder for the files, made if it is missing") { Short = "-o" };

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "breed",
        "A B",
        "cross two creatures (seeds, blueprints or GLB files): creature-<hash>.glb, .png and .json of each child, and litter.png of all with their parents",
        [
            new("breed 7 12 --out litter", "nine children of the creatures of two seeds"),
            new("breed mother.glb father.json --litter 4 --mutation 0.5 --out wild", "four that differ much"),
            new("breed 7 12 --age 0 --out babies", "the same nine, just born"),
        ],
        [litter, mutation, seed, age, folder, CommonOptions.View, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Required(folder.Name));
        int count = arguments.Whole(litter.Name, 1, MaxLitter, 9);
        var settings = new BreedingSettings { Mutation = arguments.Number(mutation.Name, 0, 1, BreedingSettings.Default.Mutation) };
        double years = arguments.Number(age.Name, 0, 1, 1);
        ulong number = ReadSeed(arguments);
        View view = CommonOptions.ReadView(arguments);
        Parent[] parents = [Parent.Read(arguments.Operand, surroundings), Parent.Read(arguments.SecondOperand!, surroundings)];
        FileSet.MakeFolder(path, surroundings);
        var children = new List<Child>();
        using (var progress = new ProgressLine(surroundings, "children", (UInt128)count, ProgressKind.Shown))
        {
            foreach (Offspring offspring in Breeding.Litter(parents[0].Blueprint, parents[1].Blueprint, number, count, settings))
            {
                surroundings.Cancellation.ThrowIfCancellationRequested();
                children.Add(Write(path, offspring, years, surroundings));
                progress.Step();
            }
        }

        byte[] sheet = Sheet(parents, children, view, surroundings);
        string picture = System.IO.Path.Combine(path, "litter.png");
        FileSet.Write(picture, stream => stream.Write(sheet), surroundings);
        if (arguments.Has(CommonOptions.Json.Name))
        {
            LitterJson.Write(surroundings.Out, parents, children, picture);
        }
        else
        {
            WriteText(parents, children, picture, surroundings);
        }

        return ExitCode.Done;
    }

    private static ulong ReadSeed(ParsedArguments arguments) => arguments.Value(seed.Name) is not string text ? 1
        : SeedText.TryRead(text, out ulong number) ? number
        : throw arguments.Wrong(seed.Name, text, SeedText.Expectation);

    private static Child Write(string folder, Offspring offspring, double age, Surroundings surroundings)
    {
        Creature creature = age == 1 ? offspring.Creature : Ageing.At(offspring.Blueprint, age).Creature;
        string name = BlueprintIdentity.Of(creature.Blueprint).ToString("x16", CultureInfo.InvariantCulture);
        GltfOptions export = CreatureFiles.WithAtlas(creature, GlbExport.Default);
        IReadOnlyList<CreatureFile> files = CreatureFiles.Write(
            folder,
            name,
            [("glb", CreatureFiles.Glb(creature, export, ClipChoice.None)), .. PictureOrder.Portrait.Take(creature, export, 1, surroundings.Abandonment), ("json", CreatureFiles.Json(creature.Blueprint))],
            surroundings);
        return new Child(name, creature, offspring, files);
    }

    private static byte[] Sheet(Parent[] parents, IReadOnlyList<Child> children, View view, Surroundings surroundings)
    {
        IEnumerable<SheetCell> cells = parents.Select((parent, i) => Cell($"parent {"AB"[i]}: {parent.Name}", CreatureAssembler.Assemble(parent.Blueprint), view))
            .Concat(children.Select((child, i) => Cell($"{i + 1}: {child.Inherited()}", child.Creature, view)));
        var layout = new ContactSheetOptions { Columns = Columns, CellWidth = CellWidth, CellHeight = CellWidth * 14 / 17, Threads = 1, LabelSize = LabelSize.Small };
        return PngWriter.ToBytes(ContactSheet.Render(cells.ToArray(), layout, surroundings.Cancellation));
    }

    private static SheetCell Cell(string label, Creature creature, View view) =>
        new(label, (width, height) => Portrait.Take(creature, view, new RenderOptions { Width = width, Height = height }));

    private static void WriteText(Parent[] parents, IReadOnlyList<Child> children, string picture, Surroundings surroundings)
    {
        surroundings.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{parents[0].Name} x {parents[1].Name}, {SpeciesDistance.Between(parents[0].Blueprint, parents[1].Blueprint):F2} apart"));
        foreach (Child child in children)
        {
            CreatureText.Row(surroundings.Out, child.Name, $"{child.Inherited()}; {child.Offspring.Repairs.Count} {(child.Offspring.Repairs.Count == 1 ? "repair" : "repairs")}");
        }

        CreatureText.Row(surroundings.Out, "sheet", picture);
    }
}
