using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class LegPairOptionsTests
{
    private const int MaxPairs = 10;
    private const ulong Seeds = 4;

    public static TheoryData<BodyPlan> Plans => new(Enum.GetValues<BodyPlan>());

    [Theory]
    [MemberData(nameof(Plans))]
    public void Every_number_of_limbs_gives_a_creature_of_each_seed_or_is_refused_at_once(BodyPlan plan)
    {
        BodyPlanWeight[] weights = Enum.GetValues<BodyPlan>().Select(other => new BodyPlanWeight(other, other == plan ? 1 : 0)).ToArray();
        for (int pairs = 0; pairs <= MaxPairs; pairs++)
        {
            CreatureOptions options = CreatureOptions.Default with { BodyPlans = new ValueList<BodyPlanWeight>(weights), MinLegPairs = pairs, MaxLegPairs = pairs };
            int given = 0;
            for (ulong seed = 1; seed <= Seeds; seed++)
            {
                given += Gives(seed, options, plan, pairs) ? 1 : 0;
            }

            Assert.True(given is 0 or (int)Seeds, $"{pairs} pairs: {given} of {Seeds} seeds");
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, 4)]
    [InlineData(BodyPlan.Unguligrade, 4)]
    [InlineData(BodyPlan.Columnar, 4)]
    [InlineData(BodyPlan.Sprawling, 4)]
    [InlineData(BodyPlan.ManyLegged, 9)]
    [InlineData(BodyPlan.Flapping, 0)]
    [InlineData(BodyPlan.Flapping, 4)]
    [InlineData(BodyPlan.Buzzing, 8)]
    public void A_plan_goes_on_as_few_or_many_limbs_as_it_may(BodyPlan plan, int pairs)
    {
        BodyPlanWeight[] weights = Enum.GetValues<BodyPlan>().Select(other => new BodyPlanWeight(other, other == plan ? 1 : 0)).ToArray();
        CreatureOptions options = CreatureOptions.Default with { BodyPlans = new ValueList<BodyPlanWeight>(weights), MinLegPairs = pairs, MaxLegPairs = pairs };
        Assert.True(Gives(7, options, plan, pairs));
    }

    /// <summary>Whether a seed gives what is asked for; false where the options are refused whatever the seed.</summary>
    private static bool Gives(ulong seed, CreatureOptions options, BodyPlan plan, int pairs)
    {
        CreatureBlueprint blueprint;
        try
        {
            blueprint = BlueprintSampler.Sample(seed, options);
        }
        catch (ArgumentException refused) when (refused is not ImpossibleSeedException)
        {
            return false;
        }

        Assert.Equal((plan, pairs), (blueprint.Plan, blueprint.Legs.Count));
        return true;
    }
}
