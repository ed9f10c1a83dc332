using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class SourceTests
{
    /// <summary>Files of about 400 lines at most, with a little room to finish a thought.</summary>
    private const int MaxLines = 420;

    /// <summary>Kinds of content of a package that end up in a program or in the closure of its user.</summary>
    private static readonly string[] RuntimeAssets = ["all", "compile", "runtime", "native", "contentfiles"];

    [Fact]
    public void No_file_of_the_source_is_too_long_to_read()
    {
        string[] paths = RepositoryFiles.Below("src", "*.cs").Concat(RepositoryFiles.Below("samples", "*.cs")).ToArray();
        Assert.True(paths.Length > 150);
        string[] wrong = paths.Select(p => (Path: p, Lines: RepositoryFiles.Text(p).Split('\n').Length - 1)).Where(f => f.Lines > MaxLines).Select(f => $"{f.Path}: {f.Lines} lines; expected at most {MaxLines}").ToArray();
        Assert.True(wrong.Length == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void What_is_shipped_has_no_packages()
    {
        string[] projects = RepositoryFiles.Below("src", "*.csproj").Concat(RepositoryFiles.Below("samples/CreatureGen.Console", "*.csproj")).ToArray();
        Assert.Equal(3, projects.Length);
        foreach (string path in projects.Concat(RepositoryFiles.Below(".", "Directory.Build.*")))
        {
            Assert.True(RuntimePackages(RepositoryFiles.Text(path)).Length == 0, $"{path}: {string.Join(", ", RuntimePackages(RepositoryFiles.Text(path)))}; expected no packages but analysers and build tools");
        }
    }

    [Theory]
    [InlineData("<PackageReference Include='A' />", true)]
    [InlineData("<PackageReference Include='A' PrivateAssets='all' />", true)]
    [InlineData("<PackageReference Include='A' PrivateAssets='all' IncludeAssets='analyzers; runtime' />", true)]
    [InlineData("<PackageReference Include='A' PrivateAssets='all' IncludeAssets='analyzers; build' />", false)]
    [InlineData("<PackageReference Include='A'><PrivateAssets>all</PrivateAssets><IncludeAssets>analyzers</IncludeAssets></PackageReference>", false)]
    [InlineData("<Reference Include='A' />", true)]
    [InlineData("<ProjectReference Include='A' />", false)]
    public void The_scan_of_projects_tells_build_tools_from_libraries(string item, bool wrong) =>
        Assert.Equal(wrong, RuntimePackages($"<Project><ItemGroup>{item}</ItemGroup></Project>").Length > 0);

    [Fact]
    public void No_file_names_a_machine_or_a_registry()
    {
        var wrong = new List<string>();
        int files = 0;
        foreach (string path in RepositoryFiles.Below(".").Where(IsText))
        {
            string text = RepositoryFiles.Text(path);
            files++;
            wrong.AddRange(Places(text).Select(place => $"{path} line {SourceText.LineAt(text, place.Index)}: {place.Value}"));
        }

        Assert.True(files > 250);
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void The_scan_for_places_bites()
    {
        string slash = "/";
        foreach (string bad in new[] { $"{slash}home/anna/x", $"in {slash}tmp/y", $"\"{slash}root/z\"", $"C:{'\\'}Users{'\\'}x", $"c:{slash}work", $"https:{slash}{slash}registry.example.org/a", $"https:{slash}{slash}api.nuget.org/v3", $"http:{slash}{slash}10.1.2.3:80" })
        {
            Assert.True(Places(bad).Any(), bad);
        }

        foreach (string good in new[] { "docs/home/index.md", "a/work/b", "version 10.1.2.3", "https:" + slash + slash + "www.khronos.org/gltf", "the work/life of a hip", "x / tmp" })
        {
            Assert.False(Places(good).Any(), good);
        }
    }

    private static string[] RuntimePackages(string project)
    {
        IEnumerable<XElement> items = XDocument.Parse(project).Descendants().Where(e => e.Name.LocalName is "PackageReference" or "Reference" or "GlobalPackageReference");
        return items.Where(i => i.Name.LocalName == "Reference" || Value(i, "PrivateAssets") != "all" || Value(i, "IncludeAssets").Split(';', StringSplitOptions.TrimEntries).Any(a => a.Length == 0 || RuntimeAssets.Contains(a)))
            .Select(i => Value(i, "Include"))
            .ToArray();
    }

    private static string Value(XElement item, string name) =>
        (item.Attribute(name)?.Value ?? item.Elements().FirstOrDefault(e => e.Name.LocalName == name)?.Value ?? "").ToLowerInvariant();

    private static IEnumerable<Match> Places(string text)
    {
        // The patterns are put together here, so that this file does not hold what it looks for.
        string folders = string.Join('|', "home", "root", "Users", "work", "tmp", "mnt", "opt", "var");
        string hosts = string.Join('|', @"[\w.-]*registry[\w.-]*", @"[\w.-]*npmjs[\w.-]*", @"api\.nuget[\w.]*", @"[\w.-]*pypi[\w.-]*", @"[\w.-]*pkgs[\w.-]*", @"\d+\.\d+\.\d+\.\d+");
        foreach (string pattern in new[] { $@"(?<![\w.)\]}}*/`<-])/(?:{folders})/", @"(?<!\w)[A-Za-z]:[\\/](?![\\/])\w", $@"https?://(?:{hosts})" })
        {
            foreach (Match match in Regex.Matches(text, pattern, RegexOptions.CultureInvariant))
            {
                yield return match;
            }
        }
    }

    private static bool IsText(string path) =>
        !path.EndsWith(".glb", StringComparison.Ordinal) && !path.EndsWith(".npy", StringComparison.Ordinal) && !path.EndsWith(".png", StringComparison.Ordinal) && !path.EndsWith(".snk", StringComparison.Ordinal) && !path.EndsWith(".webp", StringComparison.Ordinal);
}
