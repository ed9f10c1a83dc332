using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using CreatureGen.Seeding;

namespace CreatureGen.Fuzz;

/// <summary>An input of the fuzzer.</summary>
/// <param name="Index">Its number: the same number is always the same input.</param>
/// <param name="Way">How it was made.</param>
/// <param name="Text">What is read.</param>
internal sealed record FuzzInput(long Index, string Way, byte[] Text);

/// <summary>Makes inputs out of creatures of seeds: edits, crossovers, extremes, mutated bytes.</summary>
internal sealed class FuzzInputs
{
    /// <summary>First seed of the parents.</summary>
    private const ulong FirstSeed = 7_000_000;

    private static readonly RequestedKind[] kinds = [RequestedKind.Walking, RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming];

    private readonly Dictionary<int, CreatureBlueprint> parents = [];
    private readonly int count;

    /// <summary>Inputs made of a number of parents, each sampled when it is first needed.</summary>
    public FuzzInputs(int count) => this.count = count;

    /// <summary>The input of a number.</summary>
    public FuzzInput Of(long index)
    {
        RandomStream random = new Seed((ulong)index).Child("fuzz").Stream();
        CreatureBlueprint parent = Parent(random);
        return random.Integer(0, 10) switch
        {
            < 4 => Text(index, "edits", FieldEdit.Of(parent, random, random.Uniform(0.005, 0.05), 0.05)),
            < 6 => Text(index, "crossover", Cross(parent, Parent(random), random)),
            < 7 => Text(index, "crossover and edits", FieldEdit.Of(Cross(parent, Parent(random), random), random, 0.01, 0.1)),
            < 8 => Text(index, "extremes", FieldEdit.Of(parent, random, random.Uniform(0.002, 0.02), 1)),
            _ => new FuzzInput(index, "bytes", Mutate(Encoding.UTF8.GetBytes(BlueprintJson.Write(parent)), random)),
        };
    }

    /// <summary>Each record of one parent or of the other: what a careless editor would make.</summary>
    private static CreatureBlueprint Cross(CreatureBlueprint a, CreatureBlueprint b, RandomStream random)
    {
        bool Flip() => random.Chance(0.5);
        CreatureBlueprint frame = Flip() ? a : b;
        return frame with
        {
            Body = (Flip() ? a : b).Body with { Blend = (Flip() ? a : b).Body.Blend, Posture = (Flip() ? a : b).Body.Posture, Shell = (Flip() ? a : b).Body.Shell },
            Head = (Flip() ? a : b).Head,
            Tail = (Flip() ? a : b).Tail,
            Legs = (Flip() ? a : b).Legs,
            Wings = (Flip() ? a : b).Wings,
            InsectWings = (Flip() ? a : b).InsectWings,
            Fins = (Flip() ? a : b).Fins,
            Ears = (Flip() ? a : b).Ears,
            Features = (Flip() ? a : b).Features,
            Manes = (Flip() ? a : b).Manes,
            Frills = (Flip() ? a : b).Frills,
            Coat = (Flip() ? a : b).Coat,
        };
    }

    private static byte[] Mutate(byte[] text, RandomStream random)
    {
        for (int change = random.Integer(1, 4); change > 0; change--)
        {
            int at = random.Integer(0, text.Length);
            at = random.Chance(0.8) ? Array.FindIndex(text, at, b => char.IsAsciiDigit((char)b)) is >= 0 and int digit ? digit : at : at;
            text[at] = char.IsAsciiDigit((char)text[at]) && random.Chance(0.9) ? (byte)('0' + random.Integer(0, 10)) : (byte)random.Integer(0, 256);
        }

        return text;
    }

    private static FuzzInput Text(long index, string way, CreatureBlueprint blueprint) => new(index, way, Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint)));

    /// <summary>One of the parents.</summary>
    public CreatureBlueprint Parent(RandomStream random)
    {
        int number = random.Integer(0, count);
        if (!parents.TryGetValue(number, out CreatureBlueprint? parent))
        {
            parents[number] = parent = Sound(number);
        }

        return parent;
    }

    /// <summary>The creature of the first seed of a parent's own that is sound: what is broken later was broken by the fuzzer. Half of them are animals, the others strange by 0.6 to 1.</summary>
    private CreatureBlueprint Sound(int number)
    {
        double strangeness = number / kinds.Length % 2 == 0 ? 0 : 0.6 + (0.4 * number / count);
        CreatureOptions options = CreatureOptions.Default with { Kind = kinds[number % kinds.Length], TriangleBudget = 6000, MinScale = 0.1, MaxScale = 8, Strangeness = strangeness };
        for (ulong seed = FirstSeed + (ulong)number; ; seed += (ulong)count)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, options);
            if (BlueprintValidator.Validate(blueprint).Count == 0 && CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint)).Count == 0)
            {
                return blueprint;
            }
        }
    }
}
