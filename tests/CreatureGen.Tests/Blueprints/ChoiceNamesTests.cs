using System;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class ChoiceNamesTests
{
    [Fact]
    public void Every_value_of_every_enumeration_has_a_name_of_its_own()
    {
        AssertComplete(AnatomyChoices.Kind);
        AssertComplete(AnatomyChoices.Plan);
        AssertComplete(AnatomyChoices.Archetype);
        AssertComplete(AnatomyChoices.Stance);
        AssertComplete(AnatomyChoices.Wing);
        AssertComplete(AnatomyChoices.FinPlace);
        AssertComplete(AnatomyChoices.Fin);
        AssertComplete(AnatomyChoices.Tail);
        AssertComplete(AnatomyChoices.Eye);
        AssertComplete(AnatomyChoices.Feature);
        AssertComplete(AnatomyChoices.Pattern);
    }

    [Fact]
    public void What_is_not_defined_has_no_name()
    {
        Assert.Null(AnatomyChoices.Kind.NameOf((LocomotionKind)3));
        Assert.False(AnatomyChoices.Kind.TryFind("Walking", out _));
        Assert.False(AnatomyChoices.Kind.TryFind("", out _));
    }

    private static void AssertComplete<TEnum>(ChoiceNames<TEnum> names)
        where TEnum : struct, Enum
    {
        TEnum[] values = Enum.GetValues<TEnum>();
        Assert.Equal(values, names.Values);
        string?[] all = values.Select(names.NameOf).ToArray();
        Assert.Equal(values.Length, all.Distinct().Count());
        foreach (TEnum value in values)
        {
            string name = names.NameOf(value)!;
            Assert.Matches(new Regex("^[a-z][A-Za-z]*$"), name);
            Assert.True(names.TryFind(name, out TEnum found));
            Assert.Equal(value, found);
        }
    }
}
