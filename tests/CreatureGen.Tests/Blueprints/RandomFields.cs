using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Blueprints;

/// <summary>Draws every field of a record from its range, often at its ends: a record that each field alone allows, whatever they make together.</summary>
internal sealed class RandomFields : IFieldVisitor
{
    private readonly RandomStream random;

    private RandomFields(RandomStream random) => this.random = random;

    public static T Draw<T>(RecordDescription<T> description, RandomStream random)
        where T : class, IEquatable<T> => description.Visit(new RandomFields(random), description.Neutral);

    public IFieldVisitor Since(int format) => this;

    public double Number(string name, double value, NumberRange range) => random.Integer(0, 8) switch
    {
        0 => range.Minimum,
        1 => range.Maximum,
        2 => Math.Clamp(Math.Round(value, 2), range.Minimum, range.Maximum),
        _ => random.Uniform(range.Minimum, range.Maximum),
    };

    public int Whole(string name, int value, WholeRange range)
    {
        while (true)
        {
            int drawn = range.Minimum + (int)(((long)range.Maximum - range.Minimum + 1) * random.Uniform());
            if (range.Contains(drawn))
            {
                return drawn;
            }
        }
    }

    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

    public ulong UnsignedText(string name, ulong value) => random.NextUInt64() >> random.Integer(0, 64);

    public ulong? OptionalText(string name, ulong? value) => random.Chance(0.5) ? UnsignedText(name, 0) : null;

    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum => names.Values.ElementAt(random.Integer(0, names.Count));

    public string Word(string name, string value, IReadOnlyList<string> known) => known[random.Integer(0, known.Count)];

    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(this, value);

    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => random.Chance(0.5) ? description.Visit(this, description.Neutral) : null;

    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T> =>
        new(Enumerable.Range(0, Whole(name, 0, count)).Select(_ => description.Visit(this, description.Neutral)).ToArray());
}
