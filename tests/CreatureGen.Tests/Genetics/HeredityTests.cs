using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Genetics;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Genetics;

public sealed class HeredityTests(ITestOutputHelper output)
{
    private const int Parents = 60;

    [Theory]
    [InlineData(250)]
    [InlineData(1000, Explicit = true)]
    public void Children_show_both_parents_part_by_part_and_strangers_in_no_part(int crosses)
    {
        CreatureBlueprint[] blueprints = Enumerable.Range(0, Parents).Select(i => BlueprintSampler.Sample((ulong)(9_400_000 + i), CreatureOptions.Default)).ToArray();
        Resemblance[] parents = Array.ConvertAll(blueprints, blueprint => new Resemblance(CreatureGenerator.Build(blueprint)));
        IReadOnlyList<(string Name, Func<Resemblance, Resemblance, double> Likeness)> parts = Resemblance.Parts;
        double[,] sums = new double[parts.Count, 3];
        int both = 0;
        RandomStream random = new Seed(1).Stream();
        for (int cross = 0; cross < crosses; cross++)
        {
            int a = random.Integer(0, Parents), b = (a + random.Integer(1, Parents)) % Parents;
            int stranger = Enumerable.Range(0, Parents).First(i => (i + cross) % Parents is int s && s != a && s != b);
            var child = new Resemblance(Breeding.Child(blueprints[a], blueprints[b], (ulong)cross, BreedingSettings.Default).Creature);
            bool first = false, second = false;
            for (int part = 0; part < parts.Count; part++)
            {
                double toA = parts[part].Likeness(child, parents[a]), toB = parts[part].Likeness(child, parents[b]);
                sums[part, 0] += Math.Max(toA, toB) / crosses;
                sums[part, 1] += Math.Min(toA, toB) / crosses;
                sums[part, 2] += parts[part].Likeness(child, parents[(stranger + cross) % Parents]) / crosses;
                if (part < 3)
                {
                    first |= toA > toB;
                    second |= toB > toA;
                }
            }

            both += first && second ? 1 : 0;
        }

        for (int part = 0; part < parts.Count; part++)
        {
            output.WriteLine(FormattableString.Invariant($"| {parts[part].Name} | {sums[part, 0]:0.00} | {sums[part, 1]:0.00} | {sums[part, 2]:0.00} |"));
        }

        output.WriteLine(FormattableString.Invariant($"{both} of {crosses} are nearer to one parent in one of head, colour and limbs, and to the other in another"));
        for (int part = 0; part < 4; part++)
        {
            Assert.True(sums[part, 0] > sums[part, 2] + 0.2, parts[part].Name);
        }

        Assert.True(both >= 0.8 * crosses, $"{both} of {crosses}");
    }
}
