using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Blueprints;

/// <summary>Takes the numbers of a record to the nearest ones that their fields allow.</summary>
internal sealed class FieldLimiter : IFieldVisitor
{
    private static readonly FieldLimiter instance = new();

    private FieldLimiter()
    {
    }

    /// <summary>The record with all numbers in range.</summary>
    public static T Limit<T>(T record, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(instance, record);

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => this;

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range) => Scalar.Clamp(value, range.Minimum, range.Maximum);

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range) => value;

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

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
}
