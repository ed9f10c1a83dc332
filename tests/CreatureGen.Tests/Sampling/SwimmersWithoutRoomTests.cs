using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class SwimmersWithoutRoomTests
{
    [Theory]
    [InlineData(7000071UL)]
    [InlineData(7000142UL)]
    [InlineData(7000144UL)]
    public void A_swimmer_whose_legs_left_no_room_for_flippers_swims_by_its_body(ulong seed)
    {
        CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
        Assert.Empty(BlueprintValidator.Validate(blueprint));
        Assert.Equal(BodyPlan.Eel, blueprint.Plan);
        Assert.Empty(CreatureInspection.Inspect(CreatureGenerator.Build(blueprint)));
    }
}
