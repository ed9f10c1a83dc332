using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>Compares the fields of a record with their ranges and lists what is outside.</summary>
internal sealed class FieldChecker : IFieldVisitor
{
    public const string Null = "null";
    public const string AnObject = "an object";
    public const string Undefined = "an undefined value";

    private readonly JsonPath path;
    private readonly ProblemList problems;

    private FieldChecker(JsonPath path, ProblemList problems)
    {
        this.path = path;
        this.problems = problems;
    }

    /// <summary>Lists the problems of a whole record.</summary>
    public static void Check<T>(T record, RecordDescription<T> description, ProblemList problems)
        where T : class, IEquatable<T> => description.Visit(new FieldChecker(JsonPath.Root, problems), record);

    /// <summary>Whether a record is there and all its fields are in range.</summary>
    public static bool Accepts<T>(T? record, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (record is null)
        {
            return false;
        }

        var problems = new ProblemList("");
        Check(record, description, problems);
        return problems.All.Count == 0;
    }

    /// <inheritdoc/>
    public IFieldVisitor Since(int format) => this;

    /// <inheritdoc/>
    public double Number(string name, double value, NumberRange range)
    {
        if (!range.Contains(value))
        {
            Report(name, NumberText.Of(value), range.ToString());
        }

        return value;
    }

    /// <inheritdoc/>
    public int Whole(string name, int value, WholeRange range)
    {
        if (!range.Contains(value))
        {
            Report(name, value.ToString(CultureInfo.InvariantCulture), range.ToString());
        }

        return value;
    }

    /// <inheritdoc/>
    public int Version(string name, int value, int current) => Whole(name, value, new WholeRange(1, current));

    /// <inheritdoc/>
    public ulong UnsignedText(string name, ulong value) => value;

    /// <inheritdoc/>
    public ulong? OptionalText(string name, ulong? value) => value;

    /// <inheritdoc/>
    public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum
    {
        if (names.NameOf(value) is null)
        {
            Report(name, Undefined, names.ToString());
        }

        return value;
    }

    /// <inheritdoc/>
    public string Word(string name, string value, IReadOnlyList<string> known)
    {
        if (!IsKnown(value, known))
        {
            Report(name, value is null ? Null : Excerpt.Quoted(value), OneOf(known));
        }

        return value!;
    }

    /// <inheritdoc/>
    public T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (value is null)
        {
            Report(name, Null, AnObject);
            return value!;
        }

        return description.Visit(new FieldChecker(path.Member(name), problems), value);
    }

    /// <inheritdoc/>
    public T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T> => value is null ? null : Record(name, value, description);

    /// <inheritdoc/>
    public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        if (value is null)
        {
            Report(name, Null, Elements(count));
        }
        else if (!count.Contains(value.Count))
        {
            Report(name, CountOf(value.Count), Elements(count));
        }
        else
        {
            for (int i = 0; i < value.Count; i++)
            {
                description.Visit(new FieldChecker(path.Member(name).Element(i), problems), value[i]);
            }
        }

        return value!;
    }

    internal static bool IsKnown(string? value, IReadOnlyList<string> known)
    {
        foreach (string word in known)
        {
            if (string.Equals(word, value, StringComparison.Ordinal))
            {
                return true;
            }
        }

        return false;
    }

    internal static string OneOf(IReadOnlyList<string> known) => "one of " + string.Join(", ", known);

    internal static string Elements(WholeRange count) => "an array of " + count.Bounds() + " elements";

    internal static string CountOf(int count) => count.ToString(CultureInfo.InvariantCulture) + (count == 1 ? " element" : " elements");

    private void Report(string name, string value, string expectation) => problems.Add(path.Member(name).ToString(), value, expectation);
}
