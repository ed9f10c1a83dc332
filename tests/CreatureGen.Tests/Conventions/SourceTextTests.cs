using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class SourceTextTests
{
    [Theory]
    [InlineData("a // b\nc", "a     \nc")]
    [InlineData("a /* b\nc */ d", "a     \n     d")]
    [InlineData("f(\"x\\\"y\") z", "f(      ) z")]
    [InlineData("f(@\"x\"\"\\\") z", "f(       ) z")]
    [InlineData("f('\"') z", "f(   ) z")]
    [InlineData("\"\"\"a\"b\"\"\" z", "          z")]
    [InlineData("a / b", "a / b")]
    public void Comments_and_strings_are_blanked(string text, string expected) => Assert.Equal(expected, SourceText.CodeOf(text));

    [Fact]
    public void Lines_count_from_one() => Assert.Equal([1, 2, 3], new[] { SourceText.LineAt("a\nb\nc", 0), SourceText.LineAt("a\nb\nc", 2), SourceText.LineAt("a\nb\nc", 4) });
}
