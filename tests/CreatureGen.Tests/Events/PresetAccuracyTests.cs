using CreatureGen.Creatures;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class PresetAccuracyTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData("flap", 201, 2)]
    [InlineData("flap", 201, 6, Explicit = true)]
    [InlineData("flap", 1001, 30, Explicit = true)]
    [InlineData("bite", 201, 6, Explicit = true)]
    [InlineData("bite", 1001, 16, Explicit = true)]
    [InlineData("splash", 201, 8)]
    [InlineData("splash", 201, 30, Explicit = true)]
    [InlineData("splash", 1001, 40, Explicit = true)]
    public void Presets_hear_what_the_places_of_the_joints_tell(string preset, int first, int count)
    {
        (double leastFound, double mostFalse) = preset switch { "flap" => (0.9, 0.2), "bite" => (0.75, 0.15), _ => (0.7, 0.25) };
        var figures = new PresetFigures(preset);
        for (int i = 0; i < count; i++)
        {
            figures.Add(Subject(first + i, figures.Kind));
        }

        output.WriteLine(figures.ToString());
        FootstepFigures.Row all = figures.All;
        Assert.True(all.Steps >= count, $"{all.Steps} moments");
        Assert.True(all.Found >= leastFound * all.Steps && all.False <= mostFalse * (all.Found + all.False), $"{all}");
    }

    /// <summary>What is told is what the acts know of themselves: when a blow strikes, and how long a body shakes. The rules read it off the motion.</summary>
    [Theory]
    [InlineData("whoosh", 201, 6, Explicit = true)]
    [InlineData("whoosh", 1001, 24, Explicit = true)]
    [InlineData("stuff", 201, 6)]
    [InlineData("stuff", 1001, 24, Explicit = true)]
    public void Presets_hear_what_the_acts_know_of_themselves(string preset, int first, int count)
    {
        (double leastFound, double mostFalse) = preset == "whoosh" ? (0.6, 0.35) : (0.75, 0.05);
        var figures = new ScriptedFigures(preset);
        for (int i = 0; i < count; i++)
        {
            figures.Add(Subject(first + i, RequestedKind.Walking));
        }

        output.WriteLine(figures.ToString());
        FootstepFigures.Row all = figures.All;
        Assert.True(all.Steps >= count, $"{all.Steps} moments");
        Assert.True(all.Found >= leastFound * all.Steps && all.False <= mostFalse * (all.Found + all.False), $"{all}");
    }

    private static Creature Subject(int seed, RequestedKind kind) => CreatureGenerator.Generate((ulong)seed, SizeOfSeed.In(CreatureOptions.Default with { Kind = kind }, (ulong)seed));
}
