using System;
using System.Globalization;
using System.Text;

namespace CreatureGen.Json;

/// <summary>
/// Reads the strings, numbers and words of JSON off UTF-8 text and knows the line and column where it stands. A method that finds something else
/// returns null and leaves in <see cref="Expectation"/> what should have stood there.
/// </summary>
internal ref struct JsonScanner
{
    private const string Digit = "a digit";

    private readonly ReadOnlySpan<byte> text;
    private int at;
    private int line;
    private int lineStart;
    private int continuations;

    public JsonScanner(ReadOnlySpan<byte> utf8)
    {
        text = utf8;
        at = 0;
        line = 1;
        lineStart = 0;
        continuations = 0;
        Expectation = "";
    }

    /// <summary>Where it stands.</summary>
    public readonly JsonPosition Position => new(line, at - lineStart - continuations + 1);

    /// <summary>Whether nothing follows.</summary>
    public readonly bool IsAtEnd => at == text.Length;

    /// <summary>What the method that failed last would have read.</summary>
    public string Expectation { get; private set; }

    /// <summary>The next byte; 0, which is nothing in JSON, at the end.</summary>
    public readonly byte Next => at < text.Length ? text[at] : (byte)0;

    /// <summary>Passes the character if it comes next.</summary>
    public bool TryTake(char character)
    {
        if (at == text.Length || text[at] != character)
        {
            return false;
        }

        at++;
        return true;
    }

    /// <summary>Passes white space.</summary>
    public void SkipSpace()
    {
        // Half of an indented text are spaces.
        for (; at < text.Length; at++)
        {
            byte next = text[at];
            if (next == (byte)'\n')
            {
                line++;
                lineStart = at + 1;
                continuations = 0;
            }
            else if (next != (byte)' ' && next != (byte)'\r' && next != (byte)'\t')
            {
                return;
            }
        }
    }

    /// <summary>Passes all there is.</summary>
    public void SkipToEnd()
    {
        while (!IsAtEnd)
        {
            SkipByte();
        }
    }

    /// <summary>Reads letters and digits, but only if they are this word.</summary>
    public bool TryTakeWord(string word)
    {
        int end = at + word.Length;
        if (end > text.Length || IsInWord(end))
        {
            return false;
        }

        for (int i = 0; i < word.Length; i++)
        {
            if (text[at + i] != word[i])
            {
                return false;
            }
        }

        at = end;
        return true;
    }

    /// <summary>Reads a number and returns its text.</summary>
    public string? TakeNumber(out double value)
    {
        int start = at;
        value = 0;
        if (!SkipNumber())
        {
            return null;
        }

        ReadOnlySpan<byte> number = text.Slice(start, at - start);
        value = NumberParser.Parse(number);
        return Encoding.ASCII.GetString(number);
    }

    /// <summary>Passes a number.</summary>
    public bool SkipNumber()
    {
        int start = at;
        bool negative = TryTake('-');
        bool leadingZero = Next == (byte)'0';
        if (!SkipDigits())
        {
            return Fail(Digit);
        }

        if (leadingZero && at - start > (negative ? 2 : 1))
        {
            at = start;
            return Fail("a number without leading zeros");
        }

        if (TryTake('.') && !SkipDigits())
        {
            return Fail(Digit);
        }

        if (TryTake('e') || TryTake('E'))
        {
            if (!TryTake('+'))
            {
                TryTake('-');
            }

            if (!SkipDigits())
            {
                return Fail(Digit);
            }
        }

        return true;
    }

    /// <summary>Reads a string, from its opening to its closing quotation mark, and returns its characters.</summary>
    public string? TakeText()
    {
        JsonScanner before = this;
        if (!SkipText())
        {
            return null;
        }

        ReadOnlySpan<byte> within = text.Slice(before.at + 1, at - before.at - 2);
        if (within.IndexOf((byte)'\\') < 0)
        {
            return Encoding.UTF8.GetString(within);
        }

        var unescaped = new StringBuilder();
        this = before;
        PassText(unescaped);
        return unescaped.ToString();
    }

    /// <summary>Passes a string, from its opening to its closing quotation mark.</summary>
    public bool SkipText() => PassText(null);

    private bool PassText(StringBuilder? unescaped)
    {
        if (!TryTake('"'))
        {
            return Fail("'\"'");
        }

        int start = at;
        while (!IsAtEnd)
        {
            byte unit = text[at];
            if (unit == (byte)'"')
            {
                unescaped?.Append(Encoding.UTF8.GetString(text.Slice(start, at - start)));
                at++;
                return true;
            }

            if (unit == (byte)'\\')
            {
                unescaped?.Append(Encoding.UTF8.GetString(text.Slice(start, at - start)));
                if (!TakeEscape(unescaped))
                {
                    return false;
                }

                start = at;
                continue;
            }

            int units = unit < 0x80 ? 1 : Utf8SequenceLength();
            if (unit < 0x20 || units == 0)
            {
                return Fail(unit < 0x20 ? "an escape sequence in place of a control character" : "UTF-8");
            }

            at += units;
            continuations += units - 1;
        }

        return Fail("'\"'");
    }

    /// <summary>What comes next, for a message: a word, a character or the end.</summary>
    public readonly string FoundHere()
    {
        if (IsAtEnd)
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

    private bool Fail(string expectation)
    {
        Expectation = expectation;
        return false;
    }

    private bool TakeEscape(StringBuilder? unescaped)
    {
        int start = at++;
        int simple = IsAtEnd ? -1 : "\"\\/bfnrt".IndexOf((char)text[at]);
        if (simple >= 0)
        {
            unescaped?.Append("\"\\/\b\f\n\r\t"[simple]);
            at++;
            return true;
        }

        int first = TakeCodeUnit();
        bool opensPair = first >= 0xD800 && first <= 0xDBFF;
        int second = opensPair && TryTake('\\') ? TakeCodeUnit() : -1;
        bool pair = second >= 0xDC00 && second <= 0xDFFF;
        if (first < 0 || (!pair && first >= 0xD800 && first <= 0xDFFF))
        {
            at = start;
            return Fail(first < 0 ? "an escape sequence of JSON" : "both halves of a surrogate pair");
        }

        unescaped?.Append((char)first);
        if (pair)
        {
            unescaped?.Append((char)second);
        }

        return true;
    }

    /// <summary>Reads the u and the four digits of an escape sequence; −1 when they are not there.</summary>
    private int TakeCodeUnit()
    {
        if (at + 5 > text.Length || text[at] != (byte)'u')
        {
            return -1;
        }

        int unit = 0;
        for (int i = 1; i <= 4; i++)
        {
            int digit = text[at + i] < (byte)'0' ? -1 : "0123456789abcdef".IndexOf((char)(text[at + i] | 0x20));
            if (digit < 0)
            {
                return -1;
            }

            unit = (unit * 16) + digit;
        }

        at += 5;
        return unit;
    }

    /// <summary>Length of the well-formed UTF-8 sequence of several bytes that begins here (The Unicode Standard, table 3-7); 0 when there is none.</summary>
    private readonly int Utf8SequenceLength()
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

    private readonly bool IsDigit(int index) => index < text.Length && text[index] >= (byte)'0' && text[index] <= (byte)'9';

    private readonly bool IsInWord(int index) => IsDigit(index) || (index < text.Length && (text[index] | 0x20) >= 'a' && (text[index] | 0x20) <= 'z');

    private bool SkipDigits()
    {
        int start = at;
        while (IsDigit(at))
        {
            at++;
        }

        return at > start;
    }

    private void SkipByte()
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

    /// <summary>The letters and digits from here on, such as NaN; cut off where they are too many for a message.</summary>
    private readonly string WordHere()
    {
        int end = at;
        while (end - at <= Excerpt.MaximumLength && IsInWord(end))
        {
            end++;
        }

        return Encoding.ASCII.GetString(text.Slice(at, end - at));
    }
}
