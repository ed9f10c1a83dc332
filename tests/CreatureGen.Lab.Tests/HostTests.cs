using System.Threading.Tasks;
using Xunit;

namespace CreatureGen.Lab.Tests;

public sealed class HostTests
{
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
