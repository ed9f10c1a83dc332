using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Tests.Conventions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.Documents;

public sealed class DocumentTests
{
    private static readonly Lazy<MetadataReference[]> references = new(() =>
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator).Select(path => (MetadataReference)MetadataReference.CreateFromFile(path)).ToArray());

    public static IEnumerable<TheoryDataRow<string>> Documents => DocumentText.All.Select(document => new TheoryDataRow<string>(document));

    [Theory]
    [MemberData(nameof(Documents))]
    public void Every_piece_of_code_compiles_as_printed(string document)
    {
        Assert.All(DocumentText.Blocks(document), block =>
        {
            string[] errors = Compile(block).Where(problem => problem.Severity == DiagnosticSeverity.Error).Select(problem => problem.ToString()).ToArray();
            Assert.True(errors.Length == 0, $"{block}: {string.Join(Environment.NewLine, errors)}");
        });
    }

    [Fact]
    public void Pieces_that_do_not_compile_are_found()
    {
        Assert.Contains(Compile(new DocumentBlock("made up", 1, "Creature c = CreatureGenerator.Grow(1);")), problem => problem.Severity == DiagnosticSeverity.Error);
        Assert.Contains(Compile(new DocumentBlock("made up", 1, "BodyTable table = null;")), problem => problem.Severity == DiagnosticSeverity.Error);
        Assert.True(DocumentText.All.Sum(document => DocumentText.Blocks(document).Count()) >= 15);
    }

    [Theory]
    [MemberData(nameof(Documents))]
    public void Links_lead_to_files_and_headings_that_are_there(string document)
    {
        foreach (string link in DocumentText.Links(document))
        {
            string[] parts = link.Split('#', 2);
            string target = parts[0].Length == 0 ? document : Path.GetRelativePath(RepositoryFiles.Root, Path.GetFullPath(Path.Combine(RepositoryFiles.Root, Path.GetDirectoryName(document)!, parts[0]))).Replace('\\', '/');
            Assert.True(Path.Exists(Path.Combine(RepositoryFiles.Root, target)), $"{document}: no {link}");
            Assert.True(parts.Length == 1 || DocumentText.Anchors(target).Contains(parts[1]), $"{document}: no heading of {link}");
        }
    }

    [Fact]
    public void Every_picture_of_the_documents_stands_below_a_command_that_makes_pictures()
    {
        foreach (string picture in RepositoryFiles.Below("docs", "*.png").Select(path => path["docs/".Length..]))
        {
            Assert.True(
                DocumentText.All.Any(document => Regex.IsMatch(DocumentText.Read(document), @"(creaturegen \w+ .*--out |dotnet run .*--project ).*\]\(" + Regex.Escape(picture) + @"\)", RegexOptions.Singleline)),
                $"docs/{picture} stands below no command");
        }
    }

    /// <summary>Types stand for themselves and may see what is internal, as those who add species do; all else is the body of a method of a game, in C# 9 as the oldest engine has it.</summary>
    private static IReadOnlyList<Diagnostic> Compile(DocumentBlock block)
    {
        bool isType = Regex.IsMatch(block.Code, @"^(internal|public) (static |sealed )?(class|record|struct)", RegexOptions.Multiline);

        // Rows that are left out in print.
        string code = Regex.Replace(block.Code, @"^\s*…\s*$", "", RegexOptions.Multiline);
        string text = isType
            ? $"{DocumentScene.Usings}\nusing CreatureGen.Species;\nusing CreatureGen.Species.Catalogue;\n#line {block.Line} \"{block.Document}\"\n{code}"
            : $"{DocumentScene.Usings}\nstatic class Piece\n{{\n{DocumentScene.Members}\nstatic void Run()\n{{\n#line {block.Line} \"{block.Document}\"\n{code}\n}}\n}}";
        SyntaxTree tree = CSharpSyntaxTree.ParseText(text, new CSharpParseOptions(isType ? LanguageVersion.Latest : LanguageVersion.CSharp9));
        return CSharpCompilation.Create(isType ? "CreatureGen.Tests" : "Pieces", [tree], references.Value, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)).GetDiagnostics();
    }
}
