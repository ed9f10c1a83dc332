using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed partial class LayeringTests
{
    private static readonly RoomTable Table = RoomTable.Read();
    private static readonly TypeFolders Folders = TypeFolders.Read();

    [Fact]
    public void The_plan_of_the_house_lists_every_folder_of_the_library()
    {
        string[] folders = RepositoryFiles.Below("src/CreatureGen", "*.cs").Select(TypeFolders.FolderOfFile).Where(r => r != "Polyfills").Distinct().ToArray();
        Assert.True(folders.Length > 15);
        string[] missing = folders.Where(f => Table.RoomOf(f) == null).ToArray();
        Assert.True(missing.Length == 0, "docs/architecture.md section 2 has no row for " + string.Join(", ", missing));
    }

    [Fact]
    public void A_room_may_know_only_rooms_further_up_in_the_table()
    {
        for (int i = 0; i < Table.Rooms.Count; i++)
        {
            string[] wrong = Table.KnownTo(Table.Rooms[i]).Except(Table.Rooms.Take(i)).ToArray();
            Assert.True(wrong.Length == 0, $"docs/architecture.md section 2: {Table.Rooms[i]} may know {string.Join(", ", wrong)}; expected rooms of rows above it");
        }
    }

    [Fact]
    public void Sources_name_only_the_rooms_that_they_may_know()
    {
        var wrong = new List<string>();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen", "*.cs").Where(p => TypeFolders.FolderOfFile(p) != "Polyfills"))
        {
            wrong.AddRange(Mistakes(path, RepositoryFiles.Text(path), Table));
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void Compiled_code_uses_only_the_rooms_that_its_own_may_know()
    {
        var wrong = new SortedSet<string>(StringComparer.Ordinal);
        int rooms = 0;
        foreach (CompiledUse use in CompiledUse.Of(typeof(CreatureGenerator).Assembly))
        {
            string? folder = Folders.FolderOf(use.Outer.FullName);
            string? other = Folders.FolderOf(Outermost(use.TargetType).FullName);
            if (folder != null && other != null)
            {
                rooms++;
                if (Table.RoomOf(folder) is not string room || Table.RoomOf(other) is not string known || !Table.Allows(room, known))
                {
                    wrong.Add($"{use}: {folder} may not know {other}");
                }
            }
        }

        Assert.True(rooms > 1000, "the scan saw almost nothing");
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void Files_are_in_the_namespace_of_their_folder_and_public_types_in_that_of_their_door()
    {
        var wrong = new List<string>();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen", "*.cs").Where(p => TypeFolders.FolderOfFile(p) != "Polyfills"))
        {
            string code = SourceText.CodeOf(RepositoryFiles.Text(path));
            string expected = TypeFolders.ExpectedNamespace(TypeFolders.FolderOfFile(path), code);
            if (TypeFolders.NamespaceOf(code) != expected)
            {
                wrong.Add($"{path}: namespace {TypeFolders.NamespaceOf(code)}; expected {expected}");
            }
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [Theory]
    [InlineData("using CreatureGen.Sampling;\n", true)]
    [InlineData("using static CreatureGen.Sampling.BlueprintSampler;\n", true)]
    [InlineData("using S = CreatureGen.Sampling.BlueprintSampler;\n", true)]
    [InlineData("var x = CreatureGen.Sampling.BlueprintSampler.Sample(1);\n", true)]
    [InlineData("var x = global::CreatureGen.Sampling.BlueprintSampler.Sample(1);\n", true)]
    [InlineData("using CreatureGen.Maths;\n", false)]
    [InlineData("// using CreatureGen.Sampling;\n", false)]
    [InlineData("throw new Exception(\"CreatureGen.Sampling.BlueprintSampler\");\n", false)]
    public void The_scan_of_sources_bites(string source, bool wrong) =>
        Assert.Equal(wrong, Mistakes("src/CreatureGen/Bodies/Sample.cs", source, Table).Any());

    [Fact]
    public void The_table_is_read_cell_by_cell()
    {
        RoomTable table = RoomTable.Parse("text\n| folder | purpose | may know |\n| --- | --- | --- |\n| `A/` | a | – |\n| `B/C/` | b, c | A |\n| `./` | d | A, B/C |\n");
        Assert.Equal(["A", "B/C", "."], table.Rooms);
        Assert.Equal(["A", "B/C"], table.KnownTo("."));
        Assert.True(table.Allows("B/C", "A"));
        Assert.True(table.Allows("A", "A"));
        Assert.False(table.Allows("A", "B/C"));
        Assert.Equal("A", table.RoomOf("A/D/E"));
        Assert.Equal("B/C", table.RoomOf("B/C"));
        Assert.Null(table.RoomOf("B"));
        Assert.Throws<FormatException>(() => RoomTable.Parse("no table"));
    }

    private static IEnumerable<string> Mistakes(string path, string source, RoomTable table)
    {
        string room = table.RoomOf(TypeFolders.FolderOfFile(path)) ?? throw new FormatException(path + " is in no room");
        string code = SourceText.CodeOf(source);
        foreach (Match match in QualifiedName().Matches(code))
        {
            // The longest room that the name begins with: in CreatureGen.Appearance.Textures.Texels that is Appearance.
            // A door is no room: what is used of it is found in the compiled code.
            string name = match.Groups[1].Value.Replace('.', '/') + "/";
            string? other = Folders.FolderOf(match.Value) is string folder ? table.RoomOf(folder) : table.Rooms.Where(r => name.StartsWith(r + "/", StringComparison.Ordinal)).MaxBy(r => r.Length);
            bool declares = code[..match.Index].TrimEnd().EndsWith("namespace", StringComparison.Ordinal);
            if (!declares && !TypeFolders.IsDoor(match.Value) && (other == null || !table.Allows(room, other)))
            {
                yield return $"{path} line {SourceText.LineAt(code, match.Index)}: {match.Value}; {room} may know {string.Join(", ", table.KnownTo(room))} (docs/architecture.md section 2)";
            }
        }
    }

    private static Type Outermost(Type type) => type.DeclaringType == null ? type : Outermost(type.DeclaringType);

    [GeneratedRegex(@"(?<![\w.])CreatureGen\.([A-Z][\w.]*)")]
    private static partial Regex QualifiedName();
}
