using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class HarmonyTests
{
    [Fact]
    public void Mixed_fliers_go_on_legs_unless_they_are_as_long_as_snakes_or_as_wide_as_rays()
    {
        for (ulong seed = 9971001; seed <= 9971080; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            SpeciesProfile first = SpeciesCatalogue.Find(creature.Body.Blend.First);
            bool slim = first.Disc.Sweep != 0 || first.WalkingPlans.Any(plan => plan.Value == BodyPlan.Legless);
            Assert.True(slim || creature.Legs.Count > 0, FormattableString.Invariant($"{seed}: a {first.Body} without legs"));
        }
    }

    [Fact]
    public void Rays_wear_no_heads_of_mammals_or_birds()
    {
        int rays = 0;
        for (ulong seed = 9971001; seed <= 9971150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 1 });
            if (creature.Body.Disc.Sweep != 0)
            {
                rays++;
                Assert.DoesNotContain(SpeciesCatalogue.Find(creature.Body.Blend.Face).Class, new[] { AnimalClass.Mammal, AnimalClass.Bird });
            }
        }

        Assert.NotEqual(0, rays);
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void Only_insects_wear_heads_of_insects(RequestedKind kind)
    {
        for (ulong seed = 9971001; seed <= 9971100; seed++)
        {
            BodyBlend blend = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, Strangeness = 1 }).Body.Blend;
            bool insect = SpeciesCatalogue.Find(blend.First).Class == AnimalClass.Arthropod;
            Assert.True(insect || SpeciesCatalogue.Find(blend.Face).Class != AnimalClass.Arthropod, FormattableString.Invariant($"{seed}: a {blend.First} with the face of a {blend.Face}"));
        }
    }

    [Fact]
    public void Only_rays_wear_heads_of_rays()
    {
        for (ulong seed = 9971001; seed <= 9971100; seed++)
        {
            BodyBlueprint body = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 }).Body;
            Assert.True(body.Disc.Sweep != 0 || SpeciesCatalogue.Find(body.Blend.Face).Disc.Sweep == 0, FormattableString.Invariant($"{seed}: a {body.Blend.First} with the face of a ray"));
        }
    }

    [Fact]
    public void Hardly_anybody_that_is_mixed_has_legs_and_head_of_its_first_parent()
    {
        int unmixed = 0;
        int all = 0;
        for (ulong seed = 9971001; seed <= 9971200; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            BodyBlend blend = creature.Body.Blend;
            bool choosy = SpeciesCatalogue.Find(blend.First).Class == AnimalClass.Arthropod || creature.Plan == BodyPlan.Legless;
            all += choosy ? 0 : 1;
            unmixed += !choosy && blend.Face == blend.First && blend.Manner == blend.First ? 1 : 0;
        }

        Assert.InRange(unmixed, 0, all / 10);
        Assert.InRange(all, 80, 200);
    }
}
