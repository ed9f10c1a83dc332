using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Blueprints;

/// <summary>Takes the fields of a record to the nearest values that they allow; what is no value at all becomes that of the neutral record.</summary>
internal sealed class FieldLimiter : IFieldVisitor
{
    private static readonly FieldLimiter instance = new();

    private FieldLimiter()
    {
    }

    /// <summary>The record with all fields in range.</summary>
    public static T Limit<T>(T record, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(instance, record);

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => this;

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range) => Scalar.Clamp(double.IsNaN(value) ? 0 : value, range.Minimum, range.Maximum);

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range)
    {
        int near = Math.Min(Math.Max(value, range.Minimum), range.Maximum);
        return range.Contains(near) ? near : near - 1;
    }

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

    /// <inheritdoc/>
    public ulong UnsignedText(string name, ulong value) => value;

    /// <inheritdoc/>
    public ulong? OptionalText(string name, ulong? value) => value;

    /// <inheritdoc/>
    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum => names.NameOf(value) is null ? names.First : value;

    /// <inheritdoc/>
    public string Word(string name, string value, IReadOnlyList<string> known) => FieldChecker.IsKnown(value, known) ? value : known[0];

    /// <inheritdoc/>
    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T> => description.Visit(this, value ?? description.Neutral);

    /// <inheritdoc/>
    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => value is null ? null : description.Visit(this, value);

    /// <inheritdoc/>
    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        int given = value?.Count ?? 0;
        var items = new T[Math.Min(Math.Max(given, count.Minimum), count.Maximum)];
        for (int i = 0; i < items.Length; i++)
        {
            items[i] = i < given ? description.Visit(this, value![i]) : description.Neutral;
        }

        return new ValueList<T>(items);
    }
}
