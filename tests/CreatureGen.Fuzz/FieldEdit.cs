using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Fuzz;

/// <summary>Changes some fields of a record at random, each within what it alone allows: numbers a little, wholly or to an end of their range, choices, and lists by doubling, dropping or swapping elements.</summary>
internal sealed class FieldEdit : IFieldVisitor
{
    private readonly RandomStream random;
    private readonly double odds;
    private readonly double extreme;

    private FieldEdit(RandomStream random, double odds, double extreme)
    {
        this.random = random;
        this.odds = odds;
        this.extreme = extreme;
    }

    /// <summary>Edits a creature.</summary>
    /// <param name="blueprint">The creature.</param>
    /// <param name="random">What is drawn from.</param>
    /// <param name="odds">Probability that a field changes.</param>
    /// <param name="extreme">Probability that a number that changes goes to an end of its range.</param>
    public static CreatureBlueprint Of(CreatureBlueprint blueprint, RandomStream random, double odds, double extreme) =>
        CreatureFields.Creature.Visit(new FieldEdit(random, odds, extreme), blueprint);

    public IFieldVisitor Since(int format) => this;

    public double Number(string name, double value, NumberRange range)
    {
        if (!random.Chance(odds))
        {
            return value;
        }

        if (random.Chance(extreme))
        {
            return random.Chance(0.5) ? range.Minimum : range.Maximum;
        }

        double near = value + ((random.Uniform() - random.Uniform()) * 0.3 * Math.Max(Math.Abs(value), 0.1 * Math.Min(1, range.Maximum - range.Minimum)));
        return Math.Clamp(random.Chance(0.8) ? near : random.Uniform(range.Minimum, range.Maximum), range.Minimum, range.Maximum);
    }

    public int Whole(string name, int value, WholeRange range)
    {
        if (!random.Chance(odds))
        {
            return value;
        }

        int drawn = random.Chance(0.7) ? value + random.Integer(-4, 5) : (int)Math.Min(int.MaxValue, range.Minimum + (random.Uniform() * ((double)range.Maximum - range.Minimum)));
        drawn = Math.Clamp(drawn, range.Minimum, range.Maximum);
        return range.Contains(drawn) ? drawn : value;
    }

    public int Version(string name, int value, int current) => value;

    public ulong UnsignedText(string name, ulong value) => value;

    public ulong? OptionalText(string name, ulong? value) => value;

    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum => random.Chance(odds) ? names.Values.ElementAt(random.Integer(0, names.Count)) : value;

    public string Word(string name, string value, IReadOnlyList<string> known) => random.Chance(odds) ? known[random.Integer(0, known.Count)] : value;

    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(this, value);

    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => value is null ? null : description.Visit(this, value);

    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        List<T> items = value.Select(item => description.Visit(this, item)).ToList();
        if (random.Chance(odds) && items.Count > 0 && count.Minimum < count.Maximum)
        {
            int at = random.Integer(0, items.Count);
            switch (random.Integer(0, 3))
            {
                case 0:
                    items.RemoveAt(at);
                    break;
                case 1:
                    items.Insert(at, items[at]);
                    break;
                default:
                    items.Reverse();
                    break;
            }
        }

        return new ValueList<T>(items.Take(count.Maximum));
    }
}
