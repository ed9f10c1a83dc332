using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Repairs;
using CreatureGen.Tests.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Repairs;

public sealed class FieldDifferenceTests
{
    [Fact]
    public void A_difference_is_told_by_its_whole_path_with_both_values()
    {
        CreatureBlueprint small = Samples.Small;
        CreatureBlueprint other = small with { Body = small.Body with { Posture = small.Body.Posture with { Head = 0.125 } }, Legs = small.Legs.With(1, small.Legs[1] with { Toes = small.Legs[1].Toes + 1 }) };
        string[] found = FieldDifference.Between(small, other).Select(d => d.Path + " " + d.To).ToArray();
        Assert.Equal(["body.posture.head 0.125", $"legs[1].toes {small.Legs[1].Toes + 1}"], found);
        Assert.Empty(FieldDifference.Between(small, small));
    }

    [Fact]
    public void A_field_that_one_of_both_leaves_out_is_a_difference()
    {
        CreatureBlueprint small = Samples.Small;
        CreatureBlueprint forked = small with { Fork = NeckFields.Fork.Neutral };
        Assert.Equal(new FieldDifference("fork", "left out", "there"), Assert.Single(FieldDifference.Between(small, forked)));
        Assert.Equal(new FieldDifference("fork", "there", "left out"), Assert.Single(FieldDifference.Between(forked, small)));
    }
}
