using System;
using System.Collections.Generic;

namespace CreatureGen.Blueprints;

/// <summary>Takes the numbers of a record part of the way to those of another. Choices, words, whole numbers, versions and lists of other lengths stay those of the first.</summary>
internal sealed class FieldBlend : IFieldVisitor
{
    private readonly Queue<double> goals;
    private readonly double fraction;

    private FieldBlend(Queue<double> goals, double fraction)
    {
        this.goals = goals;
        this.fraction = fraction;
    }

    /// <summary>The creature between two that have as many parts in every list.</summary>
    /// <param name="first">At share 0.</param>
    /// <param name="second">At share 1.</param>
    /// <param name="fraction">0..1.</param>
    public static CreatureBlueprint Between(CreatureBlueprint first, CreatureBlueprint second, double fraction) => Between(first, second, fraction, CreatureFields.Creature);

    /// <summary>The record between two that have as many parts in every list.</summary>
    public static T Between<T>(T first, T second, double fraction, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        var goals = new NumberCollector();
        description.Visit(goals, second);
        return description.Visit(new FieldBlend(goals.Numbers, fraction), first);
    }

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => this;

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range) => value + (fraction * (goals.Dequeue() - value));

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range) => value;

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => value;

    /// <inheritdoc/>
    public ulong UnsignedText(string name, ulong value) => value;

    /// <inheritdoc/>
    public ulong? OptionalText(string name, ulong? value) => value;

    /// <inheritdoc/>
    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum => value;

    /// <inheritdoc/>
    public string Word(string name, string value, IReadOnlyList<string> known) => value;

    /// <inheritdoc/>
    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(this, value);

    /// <inheritdoc/>
    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => value;

    /// <inheritdoc/>
    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        var items = new T[value.Count];
        for (int i = 0; i < items.Length; i++)
        {
            items[i] = description.Visit(this, value[i]);
        }

        return new ValueList<T>(items);
    }

    /// <summary>Lists the numbers of a record in the order of its fields.</summary>
    private sealed class NumberCollector : IFieldVisitor
    {
        public Queue<double> Numbers { get; } = new();

        public IFieldVisitor Since(int format) => this;

        public double Number(string name, double value, NumberRange range)
        {
            Numbers.Enqueue(value);
            return value;
        }

        public int Whole(string name, int value, WholeRange range) => value;

        public int Version(string name, int value, int current) => value;

        public ulong UnsignedText(string name, ulong value) => value;

        public ulong? OptionalText(string name, ulong? value) => value;

        public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
            where TEnum : struct, Enum => value;

        public string Word(string name, string value, IReadOnlyList<string> known) => value;

        public T Record<T>(string name, T value, RecordDescription<T> description)
            where T : class, IEquatable<T> => description.Visit(this, value);

        public T? Optional<T>(string name, T? value, RecordDescription<T> description)
            where T : class, IEquatable<T> => value;

        public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            foreach (T item in value)
            {
                description.Visit(this, item);
            }

            return value;
        }
    }
}
