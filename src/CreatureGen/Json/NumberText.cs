using System;
using System.Text;

namespace CreatureGen.Json;

/// <summary>Writes numbers as the shortest text that reads back as the same number.</summary>
/// <remarks>
/// The layout is that of ECMAScript's Number::toString, which RFC 8785 takes as the canonical form of numbers in JSON: plain digits from 1e-6 up to 1e21,
/// an exponent outside; negative zero is 0.
/// </remarks>
internal static class NumberText
{
    /// <summary>No number's text is longer than this many characters.</summary>
    public const int MaximumLength = 32;

    /// <summary>Of a whole number of 64 bits.</summary>
    private const int MostDigits = 20;

    /// <summary>The text of a number; of NaN and the infinities their names, which are not JSON.</summary>
    public static string Of(double value)
    {
        if (double.IsNaN(value))
        {
            return "NaN";
        }

        if (double.IsInfinity(value))
        {
            return value > 0 ? "Infinity" : "-Infinity";
        }

        Span<byte> text = stackalloc byte[MaximumLength];
        return Encoding.ASCII.GetString(text.Slice(0, Write(value, text)));
    }

    /// <summary>Writes the text of a finite number as ASCII and returns its length.</summary>
    /// <param name="value">A finite number.</param>
    /// <param name="text">At least <see cref="MaximumLength"/> bytes.</param>
    /// <exception cref="ArgumentException">The number is NaN or infinite.</exception>
    public static int Write(double value, Span<byte> text)
    {
        RequireFinite(value);
        return Write(value < 0, ShortestDecimal.Of(value), text);
    }

    /// <summary>Writes the text of a finite number of single precision as ASCII and returns its length.</summary>
    /// <param name="value">A finite number.</param>
    /// <param name="text">At least <see cref="MaximumLength"/> bytes.</param>
    /// <exception cref="ArgumentException">The number is NaN or infinite.</exception>
    public static int Write(float value, Span<byte> text)
    {
        RequireFinite(value);
        return Write(value < 0f, ShortestDecimal.Of(value), text);
    }

    /// <summary>Writes the text of a whole number as ASCII and returns its length.</summary>
    /// <param name="value">Any whole number.</param>
    /// <param name="text">At least <see cref="MaximumLength"/> bytes.</param>
    public static int Write(long value, Span<byte> text)
    {
        int length = 0;
        ulong magnitude = unchecked((ulong)value);
        if (value < 0)
        {
            text[length++] = (byte)'-';
            magnitude = unchecked(0UL - magnitude);
        }

        return length + WriteDigits(magnitude, text.Slice(length));
    }

    private static void RequireFinite(double value)
    {
        if (double.IsNaN(value) || double.IsInfinity(value))
        {
            throw new ArgumentException("the number is " + Of(value) + "; expected a finite number, JSON has no other", nameof(value));
        }
    }

    private static int Write(bool negative, ShortestDecimal number, Span<byte> text)
    {
        int length = 0;
        if (negative)
        {
            text[length++] = (byte)'-';
        }

        if (number.Digits == 0)
        {
            text[length++] = (byte)'0';
            return length;
        }

        Span<byte> room = stackalloc byte[MostDigits];
        ReadOnlySpan<byte> digits = DigitsOf(number.Digits, room);
        int count = digits.Length;

        // Place of the decimal point, counted from the first digit.
        int point = count + number.Exponent;
        if (point > 21 || point < -5)
        {
            return length + WriteScientific(digits, point - 1, text.Slice(length));
        }

        if (point <= 0)
        {
            text[length++] = (byte)'0';
            text[length++] = (byte)'.';
            text.Slice(length, -point).Fill((byte)'0');
            length -= point;
            digits.CopyTo(text.Slice(length));
            return length + count;
        }

        if (point >= count)
        {
            digits.CopyTo(text.Slice(length));
            text.Slice(length + count, point - count).Fill((byte)'0');
            return length + point;
        }

        digits.Slice(0, point).CopyTo(text.Slice(length));
        length += point;
        text[length++] = (byte)'.';
        digits.Slice(point).CopyTo(text.Slice(length));
        return length + count - point;
    }

    private static int WriteScientific(ReadOnlySpan<byte> digits, int exponent, Span<byte> text)
    {
        int length = 0;
        text[length++] = digits[0];
        if (digits.Length > 1)
        {
            text[length++] = (byte)'.';
            digits.Slice(1).CopyTo(text.Slice(length));
            length += digits.Length - 1;
        }

        text[length++] = (byte)'e';
        text[length++] = (byte)(exponent < 0 ? '-' : '+');
        return length + WriteDigits((ulong)Math.Abs(exponent), text.Slice(length));
    }

    private static int WriteDigits(ulong value, Span<byte> text)
    {
        Span<byte> room = stackalloc byte[MostDigits];
        ReadOnlySpan<byte> digits = DigitsOf(value, room);
        digits.CopyTo(text);
        return digits.Length;
    }

    /// <summary>The digits of a number, which come from its end, at the end of the room.</summary>
    private static ReadOnlySpan<byte> DigitsOf(ulong value, Span<byte> room)
    {
        int first = room.Length;
        do
        {
            ulong tenth = value / 10;
            room[--first] = (byte)('0' + (value - (10 * tenth)));
            value = tenth;
        }
        while (value != 0);
        return room.Slice(first);
    }
}
