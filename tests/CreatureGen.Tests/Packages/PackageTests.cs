using System;
using System.Diagnostics;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Packages;

/// <summary>Packages as those get them who install them: made by pack.sh, from a folder, into an empty project.</summary>
public sealed class PackageTests
{
    private static readonly string[] readmes = ["src/CreatureGen/PACKAGE.md", "src/CreatureGen.Preview/PACKAGE.md", "samples/CreatureGen.Console/PACKAGE.md"];

    [Fact]
    public void Texts_of_packages_lead_nowhere_inside_the_repository()
    {
        foreach (string readme in readmes)
        {
            string text = RepositoryFiles.Text(readme);
            Assert.All(Regex.Matches(text, @"\]\(([^)]+)\)"), link => Assert.StartsWith("https://", link.Groups[1].Value, StringComparison.Ordinal));
        }
    }

    [Fact(Explicit = true)]
    public void Packages_install_from_a_folder_and_run_what_their_texts_show()
    {
        string place = Directory.CreateTempSubdirectory("creaturegen-packages-").FullName;
        try
        {
            MakeAndInstall(place);
        }
        finally
        {
            Directory.Delete(place, recursive: true);
        }
    }

    private static void MakeAndInstall(string place)
    {
        string packages = Path.Combine(place, "packages");
        Run(place, place, "bash", Path.Combine(RepositoryFiles.Root, "pack.sh"), packages, "https://example.org/creaturegen");
        Assert.Equal(3, Directory.GetFiles(packages, "*.snupkg").Length);
        string[] made = Directory.GetFiles(packages, "*.nupkg");
        Assert.Equal(3, made.Length);
        foreach (string path in made)
        {
            using ZipArchive package = ZipFile.OpenRead(path);
            Assert.NotNull(package.GetEntry("icon.png"));
            Assert.NotNull(package.GetEntry("README.md"));
            XElement about = Read(package, package.Entries.Single(entry => entry.FullName.EndsWith(".nuspec", StringComparison.Ordinal)).FullName).Root!.Elements().First();
            string[] told = ["id", "version", "authors", "license", "icon", "readme", "projectUrl", "repository", "description", "releaseNotes", "tags"];
            Assert.All(told, name => Assert.Contains(about.Elements(), element => element.Name.LocalName == name));
            string[] needed = about.Descendants().Where(element => element.Name.LocalName == "dependency").Select(element => element.Attribute("id")!.Value).ToArray();
            Assert.Equal(path.Contains("Preview", StringComparison.Ordinal) ? ["CreatureGen"] : [], needed);
        }

        using (ZipArchive library = ZipFile.OpenRead(made.Single(path => Regex.IsMatch(path, @"CreatureGen\.\d"))))
        {
            foreach (string framework in new[] { "net10.0", "netstandard2.1" })
            {
                string[] documented = Read(library, $"lib/{framework}/CreatureGen.xml").Descendants("member").Select(member => member.Attribute("name")!.Value).ToArray();
                Assert.All(typeof(CreatureGenerator).Assembly.GetExportedTypes(), type => Assert.Contains("T:" + type.FullName!.Replace('+', '.'), documented));
                Assert.DoesNotContain("T:CreatureGen.Species.BodyTable", documented);
                Assert.All(documented.Where(name => name.StartsWith("T:", StringComparison.Ordinal)), name => Assert.NotNull(typeof(CreatureGenerator).Assembly.GetExportedTypes().SingleOrDefault(type => "T:" + type.FullName!.Replace('+', '.') == name)));
            }
        }

        File.WriteAllText(Path.Combine(place, "nuget.config"), "<configuration><packageSources><clear/><add key='local' value='packages'/></packageSources></configuration>");
        foreach ((string name, string readme) in new[] { ("CreatureGen", readmes[0]), ("CreatureGen.Preview", readmes[1]) })
        {
            string project = Directory.CreateDirectory(Path.Combine(place, "with-" + name)).FullName;
            File.WriteAllText(Path.Combine(project, "game.csproj"), $"<Project Sdk='Microsoft.NET.Sdk'><PropertyGroup><OutputType>Exe</OutputType><TargetFramework>net10.0</TargetFramework></PropertyGroup><ItemGroup><PackageReference Include='{name}' Version='0.1.0'/></ItemGroup></Project>");
            File.WriteAllText(Path.Combine(project, "Program.cs"), Regex.Match(RepositoryFiles.Text(readme).ReplaceLineEndings("\n"), "```csharp\n(.*?)```", RegexOptions.Singleline).Groups[1].Value);
            Run(place, project, "dotnet", "run", "-c", "Release");
            Assert.Equal(name == "CreatureGen" ? ["creature-101.glb"] : ["creature-101.png"], Directory.GetFiles(project, "creature-*").Select(path => Path.GetFileName(path)));
        }

        Run(place, place, "dotnet", "tool", "install", "CreatureGen.Tool", "--tool-path", "tools", "--version", "0.1.0");
        Run(place, place, Path.Combine(place, "tools", "creaturegen"), "generate", "--seed", "7");
        Assert.Equal(3, Directory.GetFiles(place, "creature-7.*").Length);
    }

    private static XDocument Read(ZipArchive package, string entry)
    {
        using Stream stream = package.GetEntry(entry)!.Open();
        return XDocument.Load(stream);
    }

    private static void Run(string place, string folder, string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        start.Environment["NUGET_PACKAGES"] = Path.Combine(place, "cache");
        using Process process = Process.Start(start)!;
        System.Threading.Tasks.Task<string> problems = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        string told = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.True(process.ExitCode == 0, $"{program} {string.Join(' ', arguments)}: {told}{problems.Result}");
    }
}
