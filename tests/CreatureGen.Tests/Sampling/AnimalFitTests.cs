using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Parents;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class AnimalFitTests
{
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Fits_that_animals_are_not_asked_for_would_leave_them_as_they_are(LocomotionKind kind)
    {
        var choice = new PlanChoice(CreatureOptions.Default);
        for (ulong seed = 0; seed < 150; seed++)
        {
            var root = new Seed(seed);
            SpeciesProfile first = choice.Species(root.Child("family").Stream(), kind);
            Parentage parents = ParentSampler.Draw(root, kind, first, first, choice, 0);
            BodyPlan plan = choice.Plan(root.Child("plan").Stream(), kind, parents.Legs);
            var builder = new CreatureBuilder(root, kind, Harmony.On(parents, plan), plan, 0);
            BodySampler.Sample(builder);
            (ValueList<LatticeSlice> slices, BodyProportions proportions, BodyPosture posture) = (builder.Slices, builder.Proportions, builder.Posture);
            Assert.Equal(slices, TailFit.Point(builder, slices));
            Assert.Equal(slices, TailFit.RunOut(builder));
            Assert.Equal(slices, TrunkFit.Gather(builder));
            Assert.Equal(slices, FaceFit.Round(builder));
            Assert.Equal(proportions, TailFit.Drive(builder));
            Assert.Equal(proportions, TrunkFit.Fit(builder));
            Assert.Equal(proportions, HeadFit.Fit(builder));
            Assert.Equal(proportions, FaceFit.Lengthen(builder));
            Assert.Equal(proportions, TailFit.Fit(builder));
            Assert.Equal(posture, NeckFit.Carry(builder));
            Assert.Equal(posture, FaceFit.Level(builder));
        }
    }
}
