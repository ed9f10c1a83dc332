using System.Collections.Generic;
using System.Linq;
using CreatureGen.Fuzz;
using Xunit;

namespace CreatureGen.Tests.Fuzz;

/// <summary>A small part of what the fuzzer does by the hour (docs/blueprint-json.md).</summary>
public sealed class FuzzSampleTests
{
    private const int Parents = 12;
    private static readonly int Inputs = Thoroughness.Of(150);
    private const int ManyParents = 40;
    private const int BuildEvery = 30;

    [Fact]
    public void Any_text_is_refused_or_builds_a_sound_creature_or_is_told_broken_and_nearly_always_cured()
    {
        var inputs = new FuzzInputs(Parents);
        var found = new List<(FuzzInput Input, FuzzTrial Trial)>();
        for (long i = 0; i < Inputs; i++)
        {
            FuzzInput input = inputs.Of(i);
            found.Add((input, FuzzTrial.Of(input)));
        }

        Assert.DoesNotContain(found, f => f.Trial.Verdict == FuzzVerdict.Crashed);
        Assert.InRange(found.Count(f => f.Trial.Verdict == FuzzVerdict.Sound), Inputs / 3, Inputs);
        Assert.InRange(found.Count(f => f.Trial.Verdict == FuzzVerdict.Refused), Inputs / 10, Inputs);
        Assert.InRange(found.Count(f => f.Trial.Verdict == FuzzVerdict.Repaired), 1, Inputs);
        Assert.InRange(found.Count(f => f.Trial.Verdict == FuzzVerdict.Beyond), 0, 1);
    }

    /// <summary>Most inputs are only read; every thirtieth of those that are accepted is built as well.</summary>
    [Theory]
    [InlineData(2_000, Explicit = true)]
    [InlineData(20_000, Explicit = true)]
    public void Of_many_inputs_none_throws_none_is_dear_and_what_is_built_is_sound_or_told_broken(int count)
    {
        var inputs = new FuzzInputs(ManyParents);
        int accepted = 0;
        var built = new List<FuzzTrial>();
        for (long i = Inputs; i < Inputs + count; i++)
        {
            FuzzInput input = inputs.Of(i);
            FuzzTrial read = FuzzTrial.WithoutCreature(input);
            Assert.True(read.Verdict is FuzzVerdict.Refused or FuzzVerdict.Accepted, $"{input.Index}: {read}");
            if (read.Verdict == FuzzVerdict.Accepted && accepted++ % BuildEvery == 0)
            {
                built.Add(FuzzTrial.WithoutRepair(input));
                Assert.True(built[^1].Verdict is FuzzVerdict.Sound or FuzzVerdict.Told, $"{input.Index}: {built[^1]}");
            }
        }

        Assert.InRange(accepted, count / 2, count * 4 / 5);
        Assert.InRange(built.Count(b => b.Verdict == FuzzVerdict.Sound), built.Count * 4 / 5, built.Count);
    }

    [Fact]
    public void An_input_is_the_same_whenever_it_is_made()
    {
        Assert.Equal(new FuzzInputs(Parents).Of(7).Text, new FuzzInputs(Parents).Of(7).Text);
        Assert.NotEqual(new FuzzInputs(Parents).Of(7).Text, new FuzzInputs(Parents).Of(8).Text);
    }

    [Fact]
    public void A_tally_goes_on_where_it_stopped()
    {
        var tally = new FuzzTally();
        tally.Add(new FuzzInput(0, "edits", []), new FuzzTrial(FuzzVerdict.Repaired, "grounded, balanced"));
        tally.Add(new FuzzInput(1, "bytes", []), new FuzzTrial(FuzzVerdict.Refused, ""));
        FuzzTally read = FuzzTally.Parse(tally.ToString());
        Assert.Equal(2, read.Next);
        Assert.Equal(tally.ToString(), read.ToString());
        Assert.True(read.IsClean);
        read.Add(new FuzzInput(2, "bytes", []), new FuzzTrial(FuzzVerdict.Crashed, "!"));
        Assert.False(read.IsClean);
    }
}
