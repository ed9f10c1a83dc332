using System;
using System.Collections.Generic;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>What a reader makes of a field that the text does not have.</summary>
internal enum MissingField
{
    /// <summary>A problem.</summary>
    Reported,

    /// <summary>The value of the neutral record.</summary>
    Neutral,
}

/// <summary>Reads the fields of a record from JSON and lists all that is missing, unknown, of the wrong type or out of range.</summary>
internal sealed class FieldReader : IFieldVisitor
{
    private const string Missing = "nothing";

    private readonly JsonValue source;
    private readonly int format;
    private readonly int since;
    private readonly MissingField missing;
    private readonly ProblemList problems;
    private readonly List<string> visited;

    private FieldReader(JsonValue source, int format, int since, MissingField missing, ProblemList problems, List<string> visited)
    {
        this.source = source;
        this.format = format;
        this.since = since;
        this.missing = missing;
        this.problems = problems;
        this.visited = visited;
    }

    /// <summary>Reads a record; where the text has a problem, it holds values of the neutral one.</summary>
    /// <param name="source">The text's object.</param>
    /// <param name="description">The record's fields.</param>
    /// <param name="format">The format of the text; fields that are younger are not in it and have the value of the neutral record.</param>
    /// <param name="missing">What is made of a field of the text's own format that the text does not have.</param>
    /// <param name="problems">Where problems go.</param>
    public static T Read<T>(JsonValue source, RecordDescription<T> description, int format, MissingField missing, ProblemList problems)
        where T : class, IEquatable<T>
    {
        if (source.Kind != JsonKind.Object)
        {
            problems.Add(source.Position, source.Path, source.ToString(), FieldChecker.AnObject);
            return description.Neutral;
        }

        var reader = new FieldReader(source, format, BlueprintFormat.First, missing, problems, new List<string>());
        T record = description.Visit(reader, description.Neutral);
        reader.ReportUnknown();
        return record;
    }

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => new FieldReader(source, this.format, format, missing, problems, visited);

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range)
    {
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, range.ToString(), value);
        }

        if (field.Kind == JsonKind.Number && range.Contains(field.Number))
        {
            // Negative zero becomes zero.
            return field.Number + 0.0;
        }

        Report(field, range.ToString());
        return value;
    }

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range)
    {
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, range.ToString(), value);
        }

        bool fits = field.Kind == JsonKind.Number && field.Number >= int.MinValue && field.Number <= int.MaxValue;
        if (fits && Math.Floor(field.Number) == field.Number && range.Contains((int)field.Number))
        {
            return (int)field.Number;
        }

        Report(field, range.ToString());
        return value;
    }

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

    /// <inheritdoc/>
    public ulong UnsignedText(string name, ulong value)
    {
        const string expectation = "a string of the decimal digits of a number 0..18446744073709551615";
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, expectation, value);
        }

        if (field.Kind == JsonKind.Text && TryParse(field.Text, out ulong number))
        {
            return number;
        }

        Report(field, expectation);
        return value;
    }

    /// <inheritdoc/>
    public ulong? OptionalText(string name, ulong? value)
    {
        if (!IsKnown)
        {
            return value;
        }

        visited.Add(name);
        return source.TryGet(name, out _) ? UnsignedText(name, value ?? 0) : value;
    }

    /// <inheritdoc/>
    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum
    {
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, names.ToString(), value);
        }

        if (field.Kind == JsonKind.Text && names.TryFind(field.Text, out TEnum chosen))
        {
            return chosen;
        }

        Report(field, names.ToString());
        return value;
    }

    /// <inheritdoc/>
    public string Word(string name, string value, IReadOnlyList<string> known)
    {
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, FieldChecker.OneOf(known), value);
        }

        if (field.Kind == JsonKind.Text && FieldChecker.IsKnown(field.Text, known))
        {
            return field.Text;
        }

        Report(field, FieldChecker.OneOf(known));
        return value;
    }

    /// <inheritdoc/>
    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T> =>
        TryFind(name, out JsonValue field) ? Read(field, description, format, missing, problems) : Without(name, FieldChecker.AnObject, value);

    /// <inheritdoc/>
    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (!IsKnown)
        {
            return value;
        }

        visited.Add(name);
        return source.TryGet(name, out _) ? Record(name, description.Neutral, description) : value;
    }

    /// <inheritdoc/>
    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (!TryFind(name, out JsonValue field))
        {
            return Without(name, FieldChecker.Elements(count), value);
        }

        if (field.Kind != JsonKind.Array || !count.Contains(field.Items.Count))
        {
            problems.Add(field.Position, field.Path, field.Kind == JsonKind.Array ? FieldChecker.CountOf(field.Items.Count) : field.ToString(), FieldChecker.Elements(count));
            return value;
        }

        var items = new T[field.Items.Count];
        for (int i = 0; i < items.Length; i++)
        {
            // An element that leaves something out is not asking for a default, it is unfinished.
            items[i] = Read(field.Items[i], description, format, MissingField.Reported, problems);
        }

        return new ValueList<T>(items);
    }

    /// <summary>Whether the format of the text has the field that is visited.</summary>
    private bool IsKnown => since <= format;

    /// <summary>Reads decimal digits without sign or leading zeros, the only form in which a number is written.</summary>
    private static bool TryParse(string text, out ulong number)
    {
        number = 0;
        foreach (char digit in text)
        {
            if (digit < '0' || digit > '9' || number > (ulong.MaxValue - (ulong)(digit - '0')) / 10)
            {
                return false;
            }

            number = (number * 10) + (ulong)(digit - '0');
        }

        return text.Length == 1 || (text.Length > 0 && text[0] != '0');
    }

    private bool TryFind(string name, out JsonValue field)
    {
        if (!IsKnown)
        {
            field = source;
            return false;
        }

        visited.Add(name);
        bool found = source.TryGet(name, out JsonValue? member);
        field = member!;
        return found;
    }

    /// <summary>The value of a field that the text does not have.</summary>
    private T Without<T>(string name, string expectation, T value)
    {
        if (IsKnown && missing == MissingField.Reported)
        {
            string path = source.Path;
            problems.Add(source.Position, path.Length > 0 ? path + "." + name : name, Missing, expectation);
        }

        return value;
    }

    private void Report(JsonValue field, string expectation) => problems.Add(field.Position, field.Path, field.ToString(), expectation);

    private void ReportUnknown()
    {
        foreach (JsonMember member in source.Members)
        {
            if (!visited.Contains(member.Name))
            {
                problems.Add(member.Value.Position, member.Value.Path, member.Value.ToString(), "no field of this name; there are " + string.Join(", ", visited));
            }
        }
    }
}
