using System;
using System.IO;
using System.Threading.Tasks;
using Xunit;

namespace CreatureGen.Lab.Tests;

public sealed class HostTests
{
    [Fact]
    public async Task Without_a_page_it_tells_in_one_line_that_node_builds_it()
    {
        // As it is built where there is no Node: all but the site.
        string folder = Directory.CreateTempSubdirectory("creaturegen-lab-host-").FullName;
        try
        {
            foreach (string file in Directory.EnumerateFiles(Path.GetDirectoryName(PageFixture.Program)!))
            {
                File.Copy(file, Path.Combine(folder, Path.GetFileName(file)));
            }

            (int code, string output) = await PageFixture.RunAsync("dotnet", [Path.Combine(folder, Path.GetFileName(PageFixture.Program)), "--port", "0"]);

            Assert.Equal(1, code);
            Assert.Contains("Node.js 20", Assert.Single(output.TrimEnd().Split(Environment.NewLine)), StringComparison.Ordinal);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Theory]
    [InlineData("--port 70000", "--port is '70000'; expected a whole number 0..65535")]
    [InlineData("--port", "--port is 'nothing'; expected a whole number 0..65535")]
    [InlineData("--export", "--export has no folder; expected one to write to")]
    [InlineData("--speed 3", "'--speed' is not known; expected --port N, --export DIR or --help")]
    public async Task What_cannot_be_meant_is_refused_with_one_line(string arguments, string line)
    {
        (int code, string output) = await PageFixture.RunAsync("dotnet", [PageFixture.Program, .. arguments.Split(' ')]);

        Assert.Equal(2, code);
        Assert.Equal(line, output.TrimEnd());
    }
}
