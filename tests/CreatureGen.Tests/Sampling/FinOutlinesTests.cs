using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Sampling.Parents;
using CreatureGen.Seeding;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FinOutlinesTests
{
    private const int Count = 40;

    // Least that fins on the backs of mixed dolphins differ in: places of their first ring, outlines, their highest in their lowest and how far they are swept; and flukes, in how hollow they are.
    private const int Places = 3;
    private const int Styles = 2;
    private const double Heights = 1.3;
    private const double Sweeps = 0.25;
    private const double Hollows = 0.8;

    [Fact]
    public void Fins_of_mixed_dolphins_differ_and_those_of_dolphins_do_not()
    {
        FinSitePreset own = Array.Find(Dolphin.Fins!.Fins, fin => fin.Place == FinPlace.Dorsal);
        FinSitePreset[] fins = Enumerable.Range(0, Count).Select(seed => FinOutlines.Vary(Swimmer(seed, 0.6), own)).ToArray();
        Assert.True(fins.Select(fin => fin.Ring).Distinct().Count() >= Places);
        Assert.True(fins.Select(fin => fin.Style).Distinct().Count() >= Styles);
        Assert.True(fins.Max(fin => fin.Length.Max) > Heights * fins.Min(fin => fin.Length.Max));
        Assert.All(Enumerable.Range(0, Count), seed => Assert.Equal(own, FinOutlines.Vary(Swimmer(seed, 0), own)));
    }

    [Fact]
    public void Fins_that_the_plan_places_differ_in_height_and_sweep_on_mixed_swimmers_alone()
    {
        const double Height = 0.2;
        const double Sweep = 0.9;
        (double Height, double Sweep)[] fins = Enumerable.Range(0, Count).Select(seed => FinOutlines.Vary(Swimmer(seed, 0.6), Height, Sweep)).ToArray();
        Assert.True(fins.Max(fin => fin.Height) > Heights * fins.Min(fin => fin.Height));
        Assert.True(fins.Max(fin => fin.Sweep) - fins.Min(fin => fin.Sweep) > Sweeps);
        Assert.All(Enumerable.Range(0, Count), seed => Assert.Equal((Height, Sweep), FinOutlines.Vary(Swimmer(seed, 0), Height, Sweep)));
    }

    [Fact]
    public void Flukes_of_mixed_dolphins_are_fans_and_sickles_and_those_of_dolphins_neither()
    {
        var own = new TailBlueprint(TailStyle.Fluke, Size: 0.34, Fork: 1);
        double[] hollows = Enumerable.Range(0, Count).Select(seed => FinOutlines.Vary(Swimmer(seed, 0.6), own).Lobe).ToArray();
        Assert.True(hollows.Max() - hollows.Min() > Hollows);
        Assert.All(Enumerable.Range(0, Count), seed => Assert.Equal(own, FinOutlines.Vary(Swimmer(seed, 0), own)));
    }

    private static SpeciesProfile Dolphin => SpeciesCatalogue.Find("dolphin");

    private static CreatureBuilder Swimmer(int seed, double strangeness) =>
        new(new Seed((ulong)(24945000 + seed)), LocomotionKind.Swimming, new Parentage(Dolphin, Dolphin, Dolphin), BodyPlan.Whale, strangeness);
}
