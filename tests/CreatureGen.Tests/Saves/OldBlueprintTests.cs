using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Inspection;
using CreatureGen.Repairs;
using CreatureGen.Sampling;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Saves;

/// <summary>Files of every format there ever was lie beside this test and must load for ever.</summary>
public sealed class OldBlueprintTests
{
    /// <summary>The last algorithm that mixed every creature of its kin alone.</summary>
    private const int LastWithoutStrangeness = 3;

    private const string Folder = "tests/CreatureGen.Tests/Saves";

    /// <summary>Fields that say how the text is written, not what the creature is.</summary>
    private static readonly string[] headings = [".version", ".algorithm"];

    /// <summary>Where fields of older formats are today.</summary>
    private static readonly Dictionary<string, string> moved = new()
    {
        [".body.blend.first"] = ".body.blend.bodies[0].name",
        [".body.blend.second"] = ".body.blend.bodies[1].name",
        [".body.blend.third"] = ".body.blend.bodies[2].name",
        [".body.blend.secondWeight"] = ".body.blend.bodies[1].torso",
        [".body.blend.thirdWeight"] = ".body.blend.bodies[2].torso",
    };

    public static TheoryData<string> Texts => new(RepositoryFiles.Below(Folder, "*.json"));

    /// <summary>Every third is always built.</summary>
    public static IEnumerable<TheoryDataRow<string>> Built => RepositoryFiles.Below(Folder, "*.json").Select((path, i) => new TheoryDataRow<string>(path) { Explicit = i % 8 == 0 ? null : true });

    public static TheoryData<string> Files => new(RepositoryFiles.Below(Folder, "*.glb"));

    [Theory]
    [MemberData(nameof(Built))]
    public void Text_of_an_old_format_loads_with_all_it_says_and_builds_a_sound_creature(string path)
    {
        string text = RepositoryFiles.Text(path);
        BlueprintReading reading = BlueprintJson.Read(text);
        Assert.True(reading.Blueprint is not null, path + ":\n" + string.Join('\n', reading.Problems));
        Dictionary<string, string> now = Leaves(BlueprintJson.Write(reading.Blueprint));
        foreach ((string field, string value) in Leaves(text).Where(leaf => !headings.Contains(leaf.Key)))
        {
            Assert.True(now.TryGetValue(moved.GetValueOrDefault(field, field), out string? kept) && kept == value, $"{path}: {field} was {value} and is {now.GetValueOrDefault(field, "gone")}");
        }

        AssertSound(path, reading.Blueprint);
    }

    [Theory]
    [MemberData(nameof(Texts))]
    public void Without_strangeness_a_seed_is_the_kind_of_animal_that_it_was_before_there_was_any(string path)
    {
        CreatureBlueprint old = BlueprintJson.Read(RepositoryFiles.Text(path)).GetBlueprint();
        if (old.Algorithm > LastWithoutStrangeness || !Path.GetFileName(path).StartsWith(old.Kind.ToString(), StringComparison.OrdinalIgnoreCase))
        {
            return;
        }

        CreatureOptions options = CreatureOptions.Default with { Kind = Enum.Parse<RequestedKind>(old.Kind.ToString()), TriangleBudget = old.TriangleBudget, Strangeness = 0 };
        CreatureBlueprint now = BlueprintSampler.Sample(old.Seed, options);

        // How it stands follows from its body, and that was drawn better since; how large it is from its species since algorithm 16.
        Assert.Equal(old.Plan, now.Plan);
        Assert.Equal(old.Body.Blend, now.Body.Blend);
        Assert.Equal(old.Body.Proportions, now.Body.Proportions);
        Assert.Equal(old.Body.Slices, now.Body.Slices);
        Assert.Equal(old.Coat, now.Coat);
        Assert.Equal(old.Legs.Select(leg => leg.Archetype), now.Legs.Select(leg => leg.Archetype));
        Assert.Equal(old.Wings.Count, now.Wings.Count);

        // Where fins grow, not their outlines: there are families of these since algorithm 9.
        Assert.Equal(old.Fins.Select(fin => (fin.Place, fin.Socket.Rows)), now.Fins.Select(fin => (fin.Place, fin.Socket.Rows)));
        Assert.Equal(old.Features.Select(part => part.Kind), now.Features.Select(part => part.Kind));
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void An_old_file_gives_its_blueprint_and_builds_a_sound_creature(string path)
    {
        using FileStream file = File.OpenRead(Path.Combine(RepositoryFiles.Root, path));
        BlueprintReading reading = GlbReader.ReadBlueprint(file);
        Assert.True(reading.Blueprint is not null, path + ":\n" + string.Join('\n', reading.Problems));
        AssertSound(path, reading.Blueprint);
    }

    [Fact]
    public void There_is_text_of_every_format()
    {
        int[] missing = Enumerable.Range(1, BlueprintJson.FormatVersion).Where(f => !Texts.Any(row => row.Data.StartsWith($"{Folder}/format-{f}/", StringComparison.Ordinal))).ToArray();
        Assert.True(missing.Length == 0, $"no text of format {string.Join(", ", missing)}: dotnet run -c Release --project tests/CreatureGen.Digest save {Folder} (docs/blueprint-json.md)");
    }

    [Fact]
    public void Text_says_in_which_format_it_is()
    {
        foreach (string path in Texts.Select(row => row.Data))
        {
            using JsonDocument document = JsonDocument.Parse(RepositoryFiles.Text(path));
            Assert.Equal("format-" + document.RootElement.GetProperty("version").GetInt32(), Path.GetFileName(Path.GetDirectoryName(path)));
        }
    }

    private static void AssertSound(string path, CreatureBlueprint blueprint)
    {
        // The bodies of the catalogue were drawn better since: what stood on older ones may need its feet set anew, and nothing else.
        IReadOnlyList<InvariantViolation> violations = CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint));
        Assert.All(violations, violation => Assert.Contains(violation.Invariant, new[] { "balanced", "grounded" }));
        RepairReport repaired = BlueprintRepair.Repair(blueprint);
        Assert.True(repaired.IsSound, path + ":\n" + string.Join('\n', repaired.Violations));
    }

    /// <summary>Every value of a document that holds no others, by its way from the root.</summary>
    private static Dictionary<string, string> Leaves(string text)
    {
        var leaves = new Dictionary<string, string>(StringComparer.Ordinal);
        using JsonDocument document = JsonDocument.Parse(text);
        Collect("", document.RootElement, leaves);
        return leaves;
    }

    private static void Collect(string path, JsonElement value, Dictionary<string, string> leaves)
    {
        switch (value.ValueKind)
        {
            case JsonValueKind.Object:
                foreach (JsonProperty member in value.EnumerateObject())
                {
                    Collect(path + "." + member.Name, member.Value, leaves);
                }

                break;
            case JsonValueKind.Array:
                foreach ((int index, JsonElement item) in value.EnumerateArray().Index())
                {
                    Collect($"{path}[{index}]", item, leaves);
                }

                break;
            default:
                leaves.Add(path, value.GetRawText());
                break;
        }
    }
}
