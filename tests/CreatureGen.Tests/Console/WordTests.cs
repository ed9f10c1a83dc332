using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Gltf;
using CreatureGen.Rigging;
using System;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class WordTests
{
    [Fact]
    public void Words_are_the_names_that_the_library_writes()
    {
        Assert.All(Enum.GetValues<LocomotionKind>(), kind => Assert.Equal(AnatomyChoices.Kind.NameOf(kind), WordList<LocomotionKind>.Instance[kind]));
        Assert.All(Enum.GetValues<BodyPlan>(), plan => Assert.Equal(AnatomyChoices.Plan.NameOf(plan), WordList<BodyPlan>.Instance[plan]));
        Assert.All(Enum.GetValues<LimbKind>(), kind => Assert.Equal(ExtrasNames.Limb.NameOf(kind), WordList<LimbKind>.Instance[kind]));
        Assert.All(Enum.GetValues<Side>(), side => Assert.Equal(ExtrasNames.Side.NameOf(side), WordList<Side>.Instance[side]));
    }

    [Fact]
    public void A_word_is_found_only_as_it_is_written()
    {
        Assert.True(WordList<BodyPlan>.Instance.TryFind("manyLegged", out BodyPlan plan));
        Assert.Equal(BodyPlan.ManyLegged, plan);
        Assert.False(WordList<BodyPlan>.Instance.TryFind("ManyLegged", out _));
        Assert.False(WordList<BodyPlan>.Instance.TryFind("8", out _));
    }

    [Theory]
    [InlineData("genrate", "; did you mean generate?")]
    [InlineData("shete", "; did you mean sheet?")]
    [InlineData("verifi", "; did you mean verify?")]
    [InlineData("gen", "; did you mean generate?")]
    [InlineData("xyzzy", "")]
    [InlineData("", "")]
    public void The_nearest_word_is_suggested_when_one_is_near(string typed, string suggestion) =>
        Assert.Equal(suggestion, Suggestion.For(typed, ["generate", "build", "sheet", "verify"]));

    [Theory]
    [InlineData("", "", 0)]
    [InlineData("abc", "", 3)]
    [InlineData("kitten", "sitting", 3)]
    [InlineData("side", "sdie", 1)]
    public void Distances_count_the_fewest_changes(string a, string b, int distance)
    {
        Assert.Equal(distance, Suggestion.Distance(a, b));
        Assert.Equal(distance, Suggestion.Distance(b, a));
    }
}
