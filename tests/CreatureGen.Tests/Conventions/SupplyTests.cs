using System;
using System.Linq;
using System.Text.Json;
using System.Xml.Linq;
using Xunit;

namespace CreatureGen.Tests.Conventions;

/// <summary>What is built comes from where it is said to come from.</summary>
public sealed class SupplyTests
{
    [Fact]
    public void Every_package_of_every_project_is_written_down_with_its_version_and_hash()
    {
        var versions = XDocument.Parse(RepositoryFiles.Text("Directory.Packages.props")).Descendants("PackageVersion").ToDictionary(p => p.Attribute("Include")!.Value, p => p.Attribute("Version")!.Value, StringComparer.OrdinalIgnoreCase);
        int packages = 0;
        foreach (string project in RepositoryFiles.Below(".", "*.csproj").Where(p => !p.StartsWith("src/", StringComparison.Ordinal)))
        {
            string[] named = XDocument.Parse(RepositoryFiles.Text(project)).Descendants("PackageReference").Select(p => p.Attribute("Include")?.Value).OfType<string>().ToArray();
            string file = project[..(project.LastIndexOf('/') + 1)] + "packages.lock.json";
            if (named.Length == 0)
            {
                continue;
            }

            JsonElement[] frameworks = JsonDocument.Parse(RepositoryFiles.Text(file)).RootElement.GetProperty("dependencies").EnumerateObject().Select(f => f.Value).ToArray();
            foreach (string name in named)
            {
                JsonElement locked = frameworks.Select(f => f.TryGetProperty(name, out JsonElement package) ? package : default).First(p => p.ValueKind == JsonValueKind.Object);
                Assert.Equal(versions[name], locked.GetProperty("resolved").GetString());
                Assert.NotEmpty(locked.GetProperty("contentHash").GetString()!);
                packages++;
            }
        }

        Assert.True(packages > 3);
    }

    [Fact]
    public void Packages_come_from_one_source_whatever_others_a_machine_knows_and_no_address_is_named()
    {
        XElement root = XDocument.Parse(RepositoryFiles.Text("nuget.config")).Root!;
        XElement mapping = Assert.Single(root.Elements());
        Assert.Equal("packageSourceMapping", mapping.Name.LocalName);
        XElement source = Assert.Single(mapping.Elements());
        Assert.Equal("nuget.org", source.Attribute("key")!.Value);
        Assert.Equal("*", Assert.Single(source.Elements()).Attribute("pattern")!.Value);
    }
}
