using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace CreatureGen.Json;

/// <summary>Reads JSON text strictly by RFC 8259. Whatever the text is, the answer is a document or a report, never an exception.</summary>
internal ref struct JsonReader
{
    /// <summary>Objects with more members than this find them by a hash table.</summary>
    private const int SmallObject = 8;

    /// <summary>Problems beyond these are not told.</summary>
    private const int MaximumProblems = 100;

    private const string AnyValue = "a value";

    private readonly JsonLimits limits;
    private readonly List<JsonProblem> problems;
    private readonly string[] way;
    private JsonScanner scanner;
    private int values;

    private JsonReader(ReadOnlySpan<byte> text, JsonLimits limits, string[] way)
    {
        this.way = way;
        this.limits = limits;
        problems = new List<JsonProblem>();
        scanner = new JsonScanner(text);
        values = 0;
    }

    /// <summary>Reads a whole document. A byte order mark before it is passed over.</summary>
    public static JsonReading Read(ReadOnlySpan<byte> utf8, JsonLimits limits) => Read(utf8, limits, Array.Empty<string>());

    /// <summary>Reads a whole document and keeps of it what is on the way from its root: the members of these names one in another, and all in the last. The rest is checked and passed over, and costs no memory.</summary>
    public static JsonReading Read(ReadOnlySpan<byte> utf8, JsonLimits limits, string[] way)
    {
        if (utf8.Length > limits.MaximumBytes)
        {
            return TooLong(limits);
        }

        bool marked = utf8.Length >= 3 && utf8[0] == 0xEF && utf8[1] == 0xBB && utf8[2] == 0xBF;
        var reader = new JsonReader(marked ? utf8.Slice(3) : utf8, limits, way);
        JsonValue? root = reader.ReadDocument();
        return new JsonReading(root, reader.problems);
    }

    /// <summary>Reads a whole document.</summary>
    public static JsonReading Read(string text, JsonLimits limits)
    {
        if (text.Length > limits.MaximumBytes)
        {
            return TooLong(limits);
        }

        int broken = SurrogatePairs.IndexOfLoneHalf(text);
        if (broken >= 0)
        {
            var before = new JsonScanner(Encoding.UTF8.GetBytes(text.Substring(0, broken)));
            before.SkipToEnd();
            return Rejected(new JsonProblem("", before.Position, "half of a surrogate pair", "whole characters"));
        }

        return Read(Encoding.UTF8.GetBytes(text), limits);
    }

    private static JsonReading TooLong(JsonLimits limits)
    {
        string max = limits.MaximumBytes.ToString(CultureInfo.InvariantCulture);
        return Rejected(new JsonProblem("", new JsonPosition(1, 1), "a longer text", "at most " + max + " bytes"));
    }

    private static JsonReading Rejected(JsonProblem problem) => new(null, new[] { problem });

    private static bool Contains(List<JsonMember> members, Dictionary<string, JsonValue>? lookup, string name)
    {
        if (lookup != null)
        {
            return lookup.ContainsKey(name);
        }

        foreach (JsonMember member in members)
        {
            if (string.Equals(member.Name, name, StringComparison.Ordinal))
            {
                return true;
            }
        }

        return false;
    }

    private static Dictionary<string, JsonValue> Lookup(List<JsonMember> members)
    {
        var lookup = new Dictionary<string, JsonValue>(StringComparer.Ordinal);
        foreach (JsonMember member in members)
        {
            lookup.Add(member.Name, member.Value);
        }

        return lookup;
    }

    private JsonValue? ReadDocument()
    {
        scanner.SkipSpace();
        JsonValue? root = ReadValue(JsonPath.Root, 0);
        if (root is null)
        {
            return null;
        }

        scanner.SkipSpace();
        return scanner.IsAtEnd ? root : Fail(JsonPath.Root, "the end of the text");
    }

    private JsonValue? ReadValue(JsonPath path, int depth)
    {
        if (!MayGoOn(path, depth))
        {
            return null;
        }

        JsonPosition position = scanner.Position;
        byte next = scanner.Next;
        switch (next)
        {
            case (byte)'{':
            case (byte)'[':
                scanner.TryTake((char)next);
                return next == (byte)'{' ? ReadObject(path, position, depth + 1) : ReadArray(path, position, depth + 1);
            case (byte)'"':
                string? text = scanner.TakeText();
                return text is null ? Fail(path, scanner.Expectation) : JsonValue.OfText(text, path, position);
            case (byte)'t':
                return ReadWord("true", JsonKind.Boolean, path, position);
            case (byte)'f':
                return ReadWord("false", JsonKind.Boolean, path, position);
            case (byte)'n':
                return ReadWord("null", JsonKind.Null, path, position);
            case (byte)'-':
            case >= (byte)'0' and <= (byte)'9':
                string? number = scanner.TakeNumber(out double value);
                return number is null ? Fail(path, scanner.Expectation) : JsonValue.OfNumber(number, value, path, position);
            default:
                return Fail(path, AnyValue);
        }
    }

    private JsonValue? ReadObject(JsonPath path, JsonPosition position, int depth)
    {
        var members = new List<JsonMember>();
        Dictionary<string, JsonValue>? lookup = null;
        scanner.SkipSpace();
        if (scanner.TryTake('}'))
        {
            return JsonValue.OfObject(members, null, path, position);
        }

        while (true)
        {
            JsonPosition namePosition = scanner.Position;
            if (scanner.Next != (byte)'"')
            {
                return Fail(path, "a name in quotation marks");
            }

            string? name = scanner.TakeText();
            if (name is null)
            {
                return Fail(path, scanner.Expectation);
            }

            JsonPath memberPath = path.Member(name);
            scanner.SkipSpace();
            if (!scanner.TryTake(':'))
            {
                return Fail(memberPath, "':'");
            }

            scanner.SkipSpace();
            if (depth <= way.Length && !string.Equals(name, way[depth - 1], StringComparison.Ordinal))
            {
                if (!Skip(memberPath, depth))
                {
                    return null;
                }
            }
            else if (ReadValue(memberPath, depth) is not JsonValue value)
            {
                return null;
            }
            else if (Contains(members, lookup, name))
            {
                Report(new JsonProblem(memberPath.ToString(), namePosition, "a second member of this name", "one"));
            }
            else
            {
                members.Add(new JsonMember(name, value));
                lookup?.Add(name, value);
                lookup ??= members.Count > SmallObject ? Lookup(members) : null;
            }

            scanner.SkipSpace();
            if (scanner.TryTake('}'))
            {
                return JsonValue.OfObject(members, lookup, path, position);
            }

            if (!scanner.TryTake(','))
            {
                return Fail(path, "',' or '}'");
            }

            scanner.SkipSpace();
        }
    }

    private JsonValue? ReadArray(JsonPath path, JsonPosition position, int depth)
    {
        var items = new List<JsonValue>();
        scanner.SkipSpace();
        if (scanner.TryTake(']'))
        {
            return JsonValue.OfArray(items, path, position);
        }

        while (true)
        {
            JsonValue? item = ReadValue(path.Element(items.Count), depth);
            if (item is null)
            {
                return null;
            }

            items.Add(item);
            scanner.SkipSpace();
            if (scanner.TryTake(']'))
            {
                return JsonValue.OfArray(items, path, position);
            }

            if (!scanner.TryTake(','))
            {
                return Fail(path, "',' or ']'");
            }

            scanner.SkipSpace();
        }
    }

    /// <summary>Passes a value over, and checks it but for names that come twice. Problems within are told at the path of the whole.</summary>
    private bool Skip(JsonPath path, int depth)
    {
        if (!MayGoOn(path, depth))
        {
            return false;
        }

        byte next = scanner.Next;
        switch (next)
        {
            case (byte)'{':
            case (byte)'[':
                scanner.TryTake((char)next);
                return SkipMembers(path, depth + 1, next == (byte)'{' ? '}' : ']');
            case (byte)'"':
                return scanner.SkipText() || Refuse(path, scanner.Expectation);
            case (byte)'-':
            case >= (byte)'0' and <= (byte)'9':
                return scanner.SkipNumber() || Refuse(path, scanner.Expectation);
            default:
                return scanner.TryTakeWord("true") || scanner.TryTakeWord("false") || scanner.TryTakeWord("null") || Refuse(path, AnyValue);
        }
    }

    /// <summary>Passes over what is left of an object or an array.</summary>
    private bool SkipMembers(JsonPath path, int depth, char end)
    {
        scanner.SkipSpace();
        if (scanner.TryTake(end))
        {
            return true;
        }

        while (true)
        {
            if (end == '}')
            {
                if (scanner.Next != (byte)'"')
                {
                    return Refuse(path, "a name in quotation marks");
                }

                if (!scanner.SkipText())
                {
                    return Refuse(path, scanner.Expectation);
                }

                scanner.SkipSpace();
                if (!scanner.TryTake(':'))
                {
                    return Refuse(path, "':'");
                }

                scanner.SkipSpace();
            }

            if (!Skip(path, depth))
            {
                return false;
            }

            scanner.SkipSpace();
            if (scanner.TryTake(end))
            {
                return true;
            }

            if (!scanner.TryTake(','))
            {
                return Refuse(path, "',' or '" + end + "'");
            }

            scanner.SkipSpace();
        }
    }

    /// <summary>Counts a value, and tells when there are too many or they lie too deep in one another.</summary>
    private bool MayGoOn(JsonPath path, int depth)
    {
        if (++values > limits.MaximumValues)
        {
            Fail(path, "more values", "at most " + limits.MaximumValues.ToString(CultureInfo.InvariantCulture) + " values");
            return false;
        }

        if (depth == JsonLimits.MaximumDepth && (scanner.Next == (byte)'{' || scanner.Next == (byte)'['))
        {
            Fail(path, "deeper nesting", "at most " + JsonLimits.MaximumDepth.ToString(CultureInfo.InvariantCulture) + " levels");
            return false;
        }

        return true;
    }

    private JsonValue? ReadWord(string word, JsonKind kind, JsonPath path, JsonPosition position) =>
        scanner.TryTakeWord(word) ? JsonValue.OfWord(kind, word, path, position) : Fail(path, AnyValue);

    private bool Refuse(JsonPath path, string expectation) => Fail(path, expectation) != null;

    private JsonValue? Fail(JsonPath path, string expectation) => Fail(path, scanner.FoundHere(), expectation);

    private JsonValue? Fail(JsonPath path, string found, string expectation)
    {
        Report(new JsonProblem(path.ToString(), scanner.Position, found, expectation));
        return null;
    }

    private void Report(JsonProblem problem)
    {
        if (problems.Count < MaximumProblems)
        {
            problems.Add(problem);
        }
    }
}
