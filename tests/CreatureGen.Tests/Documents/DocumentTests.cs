using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Console;
using CreatureGen.Console.Arguments;
using CreatureGen.Tests.Conventions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.Documents;

public sealed class DocumentTests
{
    private static readonly Lazy<MetadataReference[]> references = new(() =>
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator).Select(path => (MetadataReference)MetadataReference.CreateFromFile(path)).ToArray());

    private static readonly string[] engines = ["Unity", "Godot"];

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

    /// <summary>Merging two lines of work lets an entry slip in twice, in one place with a word more: their beginnings tell.</summary>
    [Fact]
    public void No_change_is_listed_twice()
    {
        string[] beginnings = DocumentText.Read("CHANGELOG.md").ReplaceLineEndings("\n").Split('\n').Where(line => line.StartsWith("- ", StringComparison.Ordinal)).Select(line => line[..Math.Min(line.Length, 100)]).ToArray();
        Assert.True(beginnings.Length > 100);
        Assert.Empty(beginnings.GroupBy(beginning => beginning, StringComparer.Ordinal).Where(alike => alike.Count() > 1).Select(alike => alike.Key));
    }

    /// <summary>Node says whether a piece of JavaScript can be read.</summary>
    [Fact]
    public void Every_piece_of_javascript_can_be_read()
    {
        string place = Directory.CreateTempSubdirectory("creaturegen-pieces-").FullName;
        (string Document, string Code)[] pieces = DocumentText.All.SelectMany(document => Regex.Matches(DocumentText.Read(document).ReplaceLineEndings("\n"), "^```js\n(.*?)^```", RegexOptions.Singleline | RegexOptions.Multiline).Select(match => (document, match.Groups[1].Value))).ToArray();
        Assert.NotEmpty(pieces);
        foreach ((string document, string code) in pieces)
        {
            string path = Path.Combine(place, "piece.mjs");
            File.WriteAllText(path, code);
            using Process node = Process.Start(new ProcessStartInfo("node", ["--check", path]) { RedirectStandardError = true })!;
            string problems = node.StandardError.ReadToEnd();
            node.WaitForExit();
            Assert.True(node.ExitCode == 0, document + ": " + problems);
        }

        Directory.Delete(place, recursive: true);
    }

    /// <summary>Above each picture stands its command, as <c>docs/pictures.sh</c> reads it; the blocks and the page of the lab draw theirs by one command for all, which their documents name.</summary>
    [Fact]
    public void Every_picture_has_the_command_beside_it_that_draws_it()
    {
        (string Pictures, string Command)[] others = [("docs/blocks-", "dotnet run --project samples/CreatureGen.Blocks"), ("docs/lab", "node samples/CreatureGen.Lab/page/tests/check.mjs")];
        var drawn = new HashSet<string>();
        foreach (string document in DocumentText.All.Where(document => document.StartsWith("docs/", StringComparison.Ordinal)))
        {
            string text = DocumentText.Read(document).ReplaceLineEndings("\n");
            foreach (Match picture in Regex.Matches(text, @"!\[[^\]]*\]\(([^)]+\.png)\)"))
            {
                string path = "docs/" + picture.Groups[1].Value;
                string command = others.FirstOrDefault(other => path.StartsWith(other.Pictures, StringComparison.Ordinal)).Command;
                Assert.True(command is null ? Regex.IsMatch(text[..picture.Index], @"(?:^|\n)`creaturegen [^`\n]*--out [^`\n]*`[^\n]*\n\n$") : text.Contains(command, StringComparison.Ordinal), $"{document}: no command that draws {path}");
                drawn.Add(path);
            }
        }

        Assert.Equal(RepositoryFiles.Below("docs", "*.png").Order(StringComparer.Ordinal), drawn.Order(StringComparer.Ordinal));
    }

    /// <summary>Each command line in a document is one that the program understands, as far as its verb and options go.</summary>
    [Theory]
    [MemberData(nameof(Documents))]
    public void Commands_name_verbs_and_options_that_are_there(string document)
    {
        foreach (Match block in Regex.Matches(DocumentText.Read(document).ReplaceLineEndings("\n"), "^```(?:sh|bash)?\n(.*?)^```", RegexOptions.Singleline | RegexOptions.Multiline))
        {
            foreach (string line in block.Groups[1].Value.Split('\n').Where(line => line.StartsWith("creaturegen ", StringComparison.Ordinal)))
            {
                string[] words = Regex.Replace(line, "\"[^\"]*\"", "text").Split(' ', StringSplitOptions.RemoveEmptyEntries)[1..];
                VerbSyntax? verb = Application.Verbs.Select(one => one.Syntax).FirstOrDefault(one => one.Name == words[0]);
                Assert.True(verb != null || words[0].StartsWith("--", StringComparison.Ordinal), $"{document}: {line}");
                Assert.All(words.Skip(1).TakeWhile(word => word is not ("#" or ">" or "|")).Where(word => Regex.IsMatch(word, "^--?[a-z]")), word => Assert.True(word == "--help" || verb!.Options.Any(option => option.Is(word.Split('=')[0]) || option.Short == word[..2]), $"{document}: {line}: no {word}"));
            }
        }
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
    public void Every_document_can_be_come_to_from_the_table_of_contents()
    {
        var reached = new HashSet<string> { "README.md" };
        var open = new Queue<string>(reached);
        while (open.TryDequeue(out string? document))
        {
            foreach (string link in DocumentText.Links(document).Select(link => link.Split('#')[0]).Where(link => link.EndsWith(".md", StringComparison.Ordinal)))
            {
                string target = Path.GetRelativePath(RepositoryFiles.Root, Path.GetFullPath(Path.Combine(RepositoryFiles.Root, Path.GetDirectoryName(document)!, link))).Replace('\\', '/');
                if (reached.Add(target))
                {
                    open.Enqueue(target);
                }
            }
        }

        string[] lost = DocumentText.All.Where(document => !reached.Contains(document)).ToArray();
        Assert.True(lost.Length == 0, "no way from README.md leads to " + string.Join(", ", lost));
    }

    [Fact]
    public void Every_picture_of_the_documents_stands_below_a_command_that_makes_pictures()
    {
        foreach (string picture in RepositoryFiles.Below("docs", "*.png").Select(path => path["docs/".Length..]))
        {
            Assert.True(
                DocumentText.All.Any(document => DocumentText.Read(document).Contains($"]({picture})", StringComparison.Ordinal) && Regex.IsMatch(DocumentText.Read(document), @"(creaturegen \w+ .*--out |dotnet run .*--project ).*\]\(" + Regex.Escape(picture) + @"\)", RegexOptions.Singleline)),
                $"docs/{picture} stands below no command");
        }
    }

    /// <summary>Types stand for themselves and may see what is internal, as those who add species do; all else is the body of a method of a game, in C# 9 as the oldest engine has it.</summary>
    private static IReadOnlyList<Diagnostic> Compile(DocumentBlock block)
    {
        if (engines.FirstOrDefault(engine => block.Code.StartsWith($"// {engine.ToLowerInvariant()}\n", StringComparison.Ordinal)) is string engine)
        {
            // With the sample for the engine, on stand-ins for its types.
            IEnumerable<SyntaxTree> sample = RepositoryFiles.Below("samples/" + engine, "*.cs").Select(path => CSharpSyntaxTree.ParseText(RepositoryFiles.Text(path), path: path));
            return CSharpCompilation.Create("Pieces", sample.Append(CSharpSyntaxTree.ParseText(block.Code, new CSharpParseOptions(LanguageVersion.Latest))), references.Value, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)).GetDiagnostics();
        }

        bool isType = Regex.IsMatch(block.Code, @"^(internal|public) (static |sealed )?(class|record|struct)", RegexOptions.Multiline);
        if (!isType && block.Code.StartsWith("using ", StringComparison.Ordinal))
        {
            // A whole program, on no more than what a new project has in use by itself.
            string program = $"global using System;\n#line {block.Line} \"{block.Document}\"\n{block.Code}";
            return CSharpCompilation.Create("Program", [CSharpSyntaxTree.ParseText(program, new CSharpParseOptions(LanguageVersion.Latest))], references.Value, new CSharpCompilationOptions(OutputKind.ConsoleApplication)).GetDiagnostics();
        }

        // Rows that are left out in print.
        string code = Regex.Replace(block.Code, @"^\s*…\s*$", "", RegexOptions.Multiline);
        string text = isType
            ? $"{DocumentScene.Usings}\nusing CreatureGen.Species;\nusing CreatureGen.Species.Catalogue;\n#line {block.Line} \"{block.Document}\"\n{code}"
            : $"{DocumentScene.Usings}\nstatic class Piece\n{{\n{DocumentScene.Members}\nstatic void Run()\n{{\n#line {block.Line} \"{block.Document}\"\n{code}\n}}\n}}";
        SyntaxTree tree = CSharpSyntaxTree.ParseText(text, new CSharpParseOptions(isType ? LanguageVersion.Latest : LanguageVersion.CSharp9));
        return CSharpCompilation.Create(isType ? "CreatureGen.Tests" : "Pieces", [tree], references.Value, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)).GetDiagnostics();
    }
}
