using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>Writes the fields of a record as JSON. What JSON cannot hold is written as its name and listed as a problem.</summary>
internal sealed class FieldWriter : IFieldVisitor
{
    private readonly JsonWriter writer;
    private readonly JsonPath path;
    private readonly ProblemList problems;

    private FieldWriter(JsonWriter writer, JsonPath path, ProblemList problems)
    {
        this.writer = writer;
        this.path = path;
        this.problems = problems;
    }

    /// <summary>Writes a record as the writer's next value.</summary>
    public static void Write<T>(JsonWriter writer, T record, RecordDescription<T> description, ProblemList problems)
        where T : class, IEquatable<T> => Write(writer, JsonPath.Root, record, description, problems);

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => this;

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range)
    {
        writer.Name(name);
        if (double.IsNaN(value) || double.IsInfinity(value))
        {
            problems.Add(path.Member(name).ToString(), NumberText.Of(value), range.ToString());
            writer.Text(NumberText.Of(value));
            return value;
        }

        writer.Number(value);
        return value;
    }

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range)
    {
        writer.Name(name).Number(value);
        return value;
    }

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

    /// <inheritdoc/>
    public ulong UnsignedText(string name, ulong value)
    {
        writer.Name(name).Text(value.ToString(CultureInfo.InvariantCulture));
        return value;
    }

    /// <inheritdoc/>
    public ulong? OptionalText(string name, ulong? value) => value is ulong number ? UnsignedText(name, number) : null;

    /// <inheritdoc/>
    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum
    {
        string? known = names.NameOf(value);
        if (known is null)
        {
            problems.Add(path.Member(name).ToString(), FieldChecker.Undefined, names.ToString());
        }

        writer.Name(name).Text(known ?? FieldChecker.Undefined);
        return value;
    }

    /// <inheritdoc/>
    public string Word(string name, string value, IReadOnlyList<string> known)
    {
        if (!IsThere(name, value, FieldChecker.OneOf(known)))
        {
            return value;
        }

        bool writable = SurrogatePairs.IndexOfLoneHalf(value) < 0;
        if (!writable)
        {
            problems.Add(path.Member(name).ToString(), Excerpt.Quoted(value), FieldChecker.OneOf(known));
        }

        writer.Text(writable ? value : Excerpt.Of(value));
        return value;
    }

    /// <inheritdoc/>
    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (IsThere(name, value, FieldChecker.AnObject))
        {
            Write(writer, path.Member(name), value, description, problems);
        }

        return value;
    }

    /// <inheritdoc/>
    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => value is null ? null : Record(name, value, description);

    /// <inheritdoc/>
    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (!IsThere(name, value, FieldChecker.Elements(count)))
        {
            return value;
        }

        writer.BeginArray();
        for (int i = 0; i < value.Count; i++)
        {
            Write(writer, path.Member(name).Element(i), value[i], description, problems);
        }

        writer.EndArray();
        return value;
    }

    private static void Write<T>(JsonWriter writer, JsonPath path, T record, RecordDescription<T> description, ProblemList problems)
        where T : class, IEquatable<T>
    {
        if (description.Layout == JsonLayout.Indented)
        {
            writer.BeginObject();
        }
        else
        {
            writer.BeginLineObject();
        }

        description.Visit(new FieldWriter(writer, path, problems), record);
        writer.EndObject();
    }

    /// <summary>Writes the name, and null if there is no value.</summary>
    private bool IsThere(string name, object? value, string expectation)
    {
        writer.Name(name);
        if (value is null)
        {
            problems.Add(path.Member(name).ToString(), FieldChecker.Null, expectation);
            writer.Null();
        }

        return value != null;
    }
}
