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

    private readonly ReadOnlySpan<byte> text;
    private readonly JsonLimits limits;
    private readonly List<JsonProblem> problems;
    private int at;
    private int line;
    private int lineStart;
    private int continuations;
    private int values;

    private JsonReader(ReadOnlySpan<byte> text, JsonLimits limits)
    {
        this.text = text;
        this.limits = limits;
        problems = new List<JsonProblem>();
        at = 0;
        line = 1;
        lineStart = 0;
        continuations = 0;
        values = 0;
    }

    /// <summary>Reads a whole document. A byte order mark before it is passed over.</summary>
    public static JsonReading Read(ReadOnlySpan<byte> utf8, JsonLimits limits)
    {
        if (utf8.Length >= 3 && utf8[0] == 0xEF && utf8[1] == 0xBB && utf8[2] == 0xBF)
        {
            utf8 = utf8.Slice(3);
        }

        var reader = new JsonReader(utf8, limits);
        JsonValue? root = reader.ReadDocument();
        return new JsonReading(root, reader.problems);
    }

    /// <summary>Reads a whole document.</summary>
    public static JsonReading Read(string text, JsonLimits limits)
    {
        // A byte for a character at least: what is too long need not be encoded to say so.
        if (text.Length > limits.MaximumBytes)
        {
            return Read(new byte[limits.MaximumBytes + 1], limits);
        }

        int broken = LoneSurrogate(text);
        if (broken >= 0)
        {
            string before = text.Substring(0, broken);
            var reader = new JsonReader(Encoding.UTF8.GetBytes(before), limits);
            while (reader.at < reader.text.Length)
            {
                reader.Advance();
            }

            reader.Fail(JsonPath.Root, "half of a surrogate pair", "whole characters");
            return new JsonReading(null, reader.problems);
        }

        return Read(Encoding.UTF8.GetBytes(text), limits);
    }

    private JsonPosition Position => new(line, at - lineStart - continuations + 1);

    private static int LoneSurrogate(string text)
    {
        for (int i = 0; i < text.Length; i++)
        {
            if (!char.IsSurrogate(text[i]))
            {
                continue;
            }

            if (!char.IsHighSurrogate(text[i]) || i + 1 == text.Length || !char.IsLowSurrogate(text[i + 1]))
            {
                return i;
            }

            i++;
        }

        return -1;
    }

    private JsonValue? ReadDocument()
    {
        if (text.Length > limits.MaximumBytes)
        {
            return Fail(JsonPath.Root, "a longer text", "at most " + limits.MaximumBytes.ToString(CultureInfo.InvariantCulture) + " bytes");
        }

        SkipSpace();
        JsonValue? root = ReadValue(JsonPath.Root, 0);
        if (root is null)
        {
            return null;
        }

        SkipSpace();
        return at < text.Length ? Fail(JsonPath.Root, "the end of the text") : root;
    }

    private JsonValue? ReadValue(JsonPath path, int depth)
    {
        if (at == text.Length)
        {
            return Fail(path, AnyValue);
        }

        if (++values > limits.MaximumValues)
        {
            return Fail(path, "more values", "at most " + limits.MaximumValues.ToString(CultureInfo.InvariantCulture) + " values");
        }

        JsonPosition position = Position;
        switch (text[at])
        {
            case (byte)'{':
            case (byte)'[':
                if (depth == JsonLimits.MaximumDepth)
                {
                    return Fail(path, "deeper nesting", "at most " + JsonLimits.MaximumDepth.ToString(CultureInfo.InvariantCulture) + " levels");
                }

                return text[at] == (byte)'{' ? ReadObject(path, position, depth + 1) : ReadArray(path, position, depth + 1);
            case (byte)'"':
                string? characters = ReadText(path);
                return characters is null ? null : JsonValue.OfText(characters, path, position);
            case (byte)'t':
                return ReadWord("true", JsonKind.Boolean, path, position);
            case (byte)'f':
                return ReadWord("false", JsonKind.Boolean, path, position);
            case (byte)'n':
                return ReadWord("null", JsonKind.Null, path, position);
            default:
                return text[at] == (byte)'-' || IsDigit(at) ? ReadNumber(path, position) : Fail(path, AnyValue);
        }
    }

    private JsonValue? ReadObject(JsonPath path, JsonPosition position, int depth)
    {
        var members = new List<JsonMember>();
        Dictionary<string, JsonValue>? lookup = null;
        at++;
        SkipSpace();
        if (TryTake('}'))
        {
            return JsonValue.OfObject(members, null, path, position);
        }

        while (true)
        {
            if (at == text.Length || text[at] != (byte)'"')
            {
                return Fail(path, "a member's name in quotation marks");
            }

            JsonPosition namePosition = Position;
            string? name = ReadText(path);
            if (name is null)
            {
                return null;
            }

            JsonPath memberPath = path.Member(name);
            SkipSpace();
            if (!TryTake(':'))
            {
                return Fail(memberPath, "':'");
            }

            SkipSpace();
            JsonValue? value = ReadValue(memberPath, depth);
            if (value is null)
            {
                return null;
            }

            if (Contains(members, lookup, name))
            {
                Report(new JsonProblem(memberPath.ToString(), namePosition, "a second member of this name", "one"));
            }
            else
            {
                members.Add(new JsonMember(name, value));
                lookup?.Add(name, value);
                lookup ??= members.Count > SmallObject ? Lookup(members) : null;
            }

            SkipSpace();
            if (TryTake('}'))
            {
                return JsonValue.OfObject(members, lookup, path, position);
            }

            if (!TryTake(','))
            {
                return Fail(path, "',' or '}'");
            }

            SkipSpace();
        }
    }

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

    private JsonValue? ReadArray(JsonPath path, JsonPosition position, int depth)
    {
        var items = new List<JsonValue>();
        at++;
        SkipSpace();
        if (TryTake(']'))
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
            SkipSpace();
            if (TryTake(']'))
            {
                return JsonValue.OfArray(items, path, position);
            }

            if (!TryTake(','))
            {
                return Fail(path, "',' or ']'");
            }

            SkipSpace();
        }
    }

    private JsonValue? ReadWord(string word, JsonKind kind, JsonPath path, JsonPosition position)
    {
        string found = WordHere();
        if (!string.Equals(found, word, StringComparison.Ordinal))
        {
            return Fail(path, AnyValue);
        }

        at += word.Length;
        return JsonValue.OfWord(kind, word, path, position);
    }

    private JsonValue? ReadNumber(JsonPath path, JsonPosition position)
    {
        const string digit = "a digit";
        int start = at;
        at += text[at] == (byte)'-' ? 1 : 0;
        bool leadingZero = IsDigit(at) && text[at] == (byte)'0';
        if (!SkipDigits())
        {
            return Fail(path, digit);
        }

        if (leadingZero && at - start > (text[start] == (byte)'-' ? 2 : 1))
        {
            at = start;
            return Fail(path, "a number without leading zeros");
        }

        if (TryTake('.') && !SkipDigits())
        {
            return Fail(path, digit);
        }

        if (at < text.Length && (text[at] | 0x20) == 'e')
        {
            at++;
            at += at < text.Length && (text[at] == (byte)'+' || text[at] == (byte)'-') ? 1 : 0;
            if (!SkipDigits())
            {
                return Fail(path, digit);
            }
        }

        ReadOnlySpan<byte> number = text.Slice(start, at - start);
        return JsonValue.OfNumber(Encoding.ASCII.GetString(number), NumberParser.Parse(number), path, position);
    }

    /// <summary>Reads a string at its opening quotation mark.</summary>
    private string? ReadText(JsonPath path)
    {
        StringBuilder? unescaped = null;
        int start = ++at;
        while (at < text.Length)
        {
            byte unit = text[at];
            if (unit == (byte)'"')
            {
                string rest = Encoding.UTF8.GetString(text.Slice(start, at - start));
                at++;
                return unescaped is null ? rest : unescaped.Append(rest).ToString();
            }

            if (unit == (byte)'\\')
            {
                unescaped ??= new StringBuilder();
                unescaped.Append(Encoding.UTF8.GetString(text.Slice(start, at - start)));
                if (!ReadEscape(path, unescaped))
                {
                    return null;
                }

                start = at;
                continue;
            }

            int units = unit < 0x80 ? 1 : Utf8SequenceLength();
            if (unit < 0x20 || units == 0)
            {
                Fail(path, unit < 0x20 ? "an escape sequence in place of a control character" : "UTF-8");
                return null;
            }

            at += units;
            continuations += units - 1;
        }

        Fail(path, "'\"'");
        return null;
    }

    private bool ReadEscape(JsonPath path, StringBuilder unescaped)
    {
        int start = at++;
        int simple = at < text.Length ? "\"\\/bfnrt".IndexOf((char)text[at]) : -1;
        if (simple >= 0)
        {
            unescaped.Append("\"\\/\b\f\n\r\t"[simple]);
            at++;
            return true;
        }

        int first = ReadUnit();
        int second = first >= 0xD800 && first <= 0xDBFF && at < text.Length && text[at] == (byte)'\\' ? ReadSecondUnit() : -1;
        bool pair = second >= 0xDC00 && second <= 0xDFFF;
        if (first < 0 || (!pair && first >= 0xD800 && first <= 0xDFFF))
        {
            at = start;
            Fail(path, first < 0 ? "an escape sequence of JSON" : "both halves of a surrogate pair");
            return false;
        }

        unescaped.Append((char)first);
        if (pair)
        {
            unescaped.Append((char)second);
        }

        return true;
    }

    private int ReadSecondUnit()
    {
        at++;
        return ReadUnit();
    }

    /// <summary>Reads the u and the four digits of an escape sequence; −1 when they are not there.</summary>
    private int ReadUnit()
    {
        if (at + 5 > text.Length || text[at] != (byte)'u')
        {
            return -1;
        }

        int unit = 0;
        for (int i = 1; i <= 4; i++)
        {
            int digit = "0123456789abcdef".IndexOf((char)(text[at + i] | 0x20));
            if (digit < 0 || text[at + i] < (byte)'0')
            {
                return -1;
            }

            unit = (unit * 16) + digit;
        }

        at += 5;
        return unit;
    }

    /// <summary>Length of the well-formed UTF-8 sequence of several bytes that begins here (Unicode, table 3-7); 0 when there is none.</summary>
    private int Utf8SequenceLength()
    {
        byte first = text[at];
        int count = first >= 0xC2 && first <= 0xDF ? 2 : (first & 0xF0) == 0xE0 ? 3 : first >= 0xF0 && first <= 0xF4 ? 4 : 0;
        if (count == 0 || at + count > text.Length)
        {
            return 0;
        }

        for (int i = 1; i < count; i++)
        {
            if ((text[at + i] & 0xC0) != 0x80)
            {
                return 0;
            }
        }

        byte second = text[at + 1];
        bool wellFormed = first switch
        {
            0xE0 => second >= 0xA0,
            0xED => second <= 0x9F,
            0xF0 => second >= 0x90,
            0xF4 => second <= 0x8F,
            _ => true,
        };
        return wellFormed ? count : 0;
    }

    private bool IsDigit(int index) => index < text.Length && text[index] >= (byte)'0' && text[index] <= (byte)'9';

    private bool SkipDigits()
    {
        int start = at;
        while (IsDigit(at))
        {
            at++;
        }

        return at > start;
    }

    private bool TryTake(char character)
    {
        if (at == text.Length || text[at] != character)
        {
            return false;
        }

        at++;
        return true;
    }

    private void SkipSpace()
    {
        while (at < text.Length && (text[at] == (byte)' ' || text[at] == (byte)'\n' || text[at] == (byte)'\r' || text[at] == (byte)'\t'))
        {
            Advance();
        }
    }

    /// <summary>Passes one byte, keeping count of lines and columns.</summary>
    private void Advance()
    {
        byte passed = text[at++];
        if (passed == (byte)'\n')
        {
            line++;
            lineStart = at;
            continuations = 0;
        }
        else if ((passed & 0xC0) == 0x80)
        {
            continuations++;
        }
    }

    private JsonValue? Fail(JsonPath path, string expectation) => Fail(path, FoundHere(), expectation);

    private JsonValue? Fail(JsonPath path, string found, string expectation)
    {
        Report(new JsonProblem(path.ToString(), Position, found, expectation));
        return null;
    }

    private void Report(JsonProblem problem)
    {
        if (problems.Count < MaximumProblems)
        {
            problems.Add(problem);
        }
    }

    private string FoundHere()
    {
        if (at == text.Length)
        {
            return "the end of the text";
        }

        string word = WordHere();
        if (word.Length > 0)
        {
            return Excerpt.Of(word);
        }

        byte unit = text[at];
        return unit >= 0x80 ? "byte 0x" + unit.ToString("X2", CultureInfo.InvariantCulture)
            : unit < 0x20 || unit == 0x7F ? "control character U+" + unit.ToString("X4", CultureInfo.InvariantCulture)
            : "'" + (char)unit + "'";
    }

    /// <summary>The letters and digits from here on, such as NaN; cut off where they are too many.</summary>
    private string WordHere()
    {
        int end = at;
        while (end < text.Length && end - at <= Excerpt.MaximumLength && (IsDigit(end) || ((text[end] | 0x20) >= 'a' && (text[end] | 0x20) <= 'z')))
        {
            end++;
        }

        return Encoding.ASCII.GetString(text.Slice(at, end - at));
    }
}
