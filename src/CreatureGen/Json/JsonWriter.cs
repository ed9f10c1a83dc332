using System;
using System.Buffers;
using System.Text;

namespace CreatureGen.Json;

/// <summary>
/// Writes one JSON value as UTF-8. The same calls give the same bytes on every runtime and in every culture. Each call returns the writer itself.
/// </summary>
/// <remarks>
/// Calls that would not give JSON throw <see cref="InvalidOperationException"/>: a member without a name, an end without its beginning, a second root.
/// </remarks>
internal sealed class JsonWriter : IDisposable
{
    private const int FirstRoom = 1024;

    private readonly JsonLayout layout;
    private readonly Scope[] scopes = new Scope[JsonLimits.MaximumDepth];
    private int depth;
    private byte[] buffer = ArrayPool<byte>.Shared.Rent(FirstRoom);
    private int length;
    private bool named;

    /// <summary>Starts empty.</summary>
    public JsonWriter(JsonLayout layout) => this.layout = layout;

    /// <summary>Begins an object set out like the text around it.</summary>
    public JsonWriter BeginObject() => Begin((byte)'{', CurrentLayout);

    /// <summary>Begins an object on one line within indented text; within other text it is set out like that.</summary>
    public JsonWriter BeginLineObject() => Begin((byte)'{', LineLayout);

    /// <summary>Ends the object begun last.</summary>
    public JsonWriter EndObject() => End((byte)'{', (byte)'}');

    /// <summary>Begins an array set out like the text around it.</summary>
    public JsonWriter BeginArray() => Begin((byte)'[', CurrentLayout);

    /// <summary>Begins an array on one line within indented text; within other text it is set out like that.</summary>
    public JsonWriter BeginLineArray() => Begin((byte)'[', LineLayout);

    /// <summary>Ends the array begun last.</summary>
    public JsonWriter EndArray() => End((byte)'[', (byte)']');

    /// <summary>The name of the object's next member, whose value must follow.</summary>
    /// <exception cref="ArgumentException">The name has half of a surrogate pair.</exception>
    public JsonWriter Name(string name)
    {
        if (depth == 0 || scopes[depth - 1].Opening != (byte)'{' || named)
        {
            throw new InvalidOperationException("a name does not belong here; expected one before each value in an object, and only there");
        }

        Separate();
        Quote(name);
        Append((byte)':');
        if (CurrentLayout != JsonLayout.Compact)
        {
            Append((byte)' ');
        }

        named = true;
        return this;
    }

    /// <summary>Writes a string.</summary>
    /// <exception cref="ArgumentException">The text has half of a surrogate pair.</exception>
    public JsonWriter Text(string value)
    {
        BeginValue();
        Quote(value);
        return this;
    }

    /// <summary>Writes a number as the shortest text that reads back as the same double.</summary>
    /// <exception cref="ArgumentException">The number is NaN or infinite.</exception>
    public JsonWriter Number(double value)
    {
        Span<byte> text = stackalloc byte[NumberText.MaximumLength];
        return Plain(text.Slice(0, NumberText.Write(value, text)));
    }

    /// <summary>Writes a number as the shortest text that reads back as the same number of single precision.</summary>
    /// <exception cref="ArgumentException">The number is NaN or infinite.</exception>
    public JsonWriter Number(float value)
    {
        Span<byte> text = stackalloc byte[NumberText.MaximumLength];
        return Plain(text.Slice(0, NumberText.Write(value, text)));
    }

    /// <summary>Writes a whole number.</summary>
    public JsonWriter Number(long value)
    {
        Span<byte> text = stackalloc byte[NumberText.MaximumLength];
        return Plain(text.Slice(0, NumberText.Write(value, text)));
    }

    /// <summary>Writes true or false.</summary>
    public JsonWriter Boolean(bool value) => Plain(value ? "true"u8 : "false"u8);

    /// <summary>Writes null.</summary>
    public JsonWriter Null() => Plain("null"u8);

    /// <summary>The finished text in UTF-8, without a byte order mark; valid until the writer is disposed.</summary>
    public ReadOnlySpan<byte> Utf8
    {
        get
        {
            RequireFinished();
            return buffer.AsSpan(0, length);
        }
    }

    /// <summary>Gives the memory back; the writer must not be used again. Without disposing, the collector takes it.</summary>
    public void Dispose()
    {
        ArrayPool<byte>.Shared.Return(buffer);
        buffer = Array.Empty<byte>();
        length = 0;
    }

    /// <summary>The text so far.</summary>
    public override string ToString() => Encoding.UTF8.GetString(buffer, 0, length);

    private JsonLayout CurrentLayout => depth == 0 ? layout : scopes[depth - 1].Layout;

    private JsonLayout LineLayout => CurrentLayout == JsonLayout.Indented ? JsonLayout.Line : CurrentLayout;

    private JsonWriter Plain(ReadOnlySpan<byte> text)
    {
        BeginValue();
        Append(text);
        return this;
    }

    private JsonWriter Begin(byte opening, JsonLayout inside)
    {
        if (depth == scopes.Length)
        {
            throw new InvalidOperationException("arrays and objects are nested deeper than " + JsonLimits.MaximumDepth + ", more than a reader takes");
        }

        BeginValue();
        Append(opening);
        scopes[depth++] = new Scope { Opening = opening, Layout = inside };
        return this;
    }

    private JsonWriter End(byte opening, byte closing)
    {
        if (depth == 0 || scopes[depth - 1].Opening != opening || named)
        {
            throw new InvalidOperationException("'" + (char)closing + "' does not belong here; expected it to close what was opened last, after a value");
        }

        Scope scope = scopes[--depth];
        if (scope.Count > 0)
        {
            Space(scope);
        }

        Append(closing);
        return this;
    }

    private void BeginValue()
    {
        if (named)
        {
            named = false;
            return;
        }

        if (depth == 0 ? length > 0 : scopes[depth - 1].Opening == (byte)'{')
        {
            throw new InvalidOperationException(depth == 0 ? "a second root value; expected one" : "a value without a name in an object; expected a name first");
        }

        Separate();
    }

    private void Separate()
    {
        if (depth == 0)
        {
            return;
        }

        ref Scope scope = ref scopes[depth - 1];
        bool first = scope.Count++ == 0;
        if (!first)
        {
            Append((byte)',');
        }

        // One-line arrays hug their elements: [1, 2], but { "a": 1 }.
        if (!first && scope.Layout == JsonLayout.Line)
        {
            Append((byte)' ');
        }
        else
        {
            Space(scope);
        }
    }

    /// <summary>White space after an opening and before a closing bracket, at the current depth.</summary>
    private void Space(Scope scope)
    {
        if (scope.Layout == JsonLayout.Indented)
        {
            Append((byte)'\n');
            for (int i = 0; i < depth * 2; i++)
            {
                Append((byte)' ');
            }
        }
        else if (scope.Layout == JsonLayout.Line && scope.Opening == (byte)'{')
        {
            Append((byte)' ');
        }
    }

    private void Quote(string value)
    {
        if (value is null)
        {
            throw new ArgumentNullException(nameof(value));
        }

        Append((byte)'"');

        // Nearly all text is plain from its first to its last character.
        Span<byte> room = Room(value.Length);
        int plain = 0;
        for (; plain < value.Length && IsPlain(value[plain]); plain++)
        {
            room[plain] = (byte)value[plain];
        }

        length += plain;
        for (int i = plain; i < value.Length; i++)
        {
            char character = value[i];
            if (character >= 0x80)
            {
                i += AppendCodePoint(value, i);
            }
            else if (IsPlain(character))
            {
                Append((byte)character);
            }
            else
            {
                AppendEscape(character);
            }
        }

        Append((byte)'"');
    }

    private static bool IsPlain(char character) => character is >= ' ' and < '\x80' and not ('"' or '\\');

    private void AppendEscape(char character)
    {
        const string hexadecimal = "0123456789abcdef";
        Append((byte)'\\');
        int known = "\"\\\b\f\n\r\t".IndexOf(character);
        if (known >= 0)
        {
            Append((byte)"\"\\bfnrt"[known]);
            return;
        }

        Append((byte)'u');
        Append((byte)'0');
        Append((byte)'0');
        Append((byte)hexadecimal[character >> 4]);
        Append((byte)hexadecimal[character & 15]);
    }

    /// <summary>Writes the code point at a place and returns how many further characters it took.</summary>
    private int AppendCodePoint(string value, int at)
    {
        int point = value[at];
        bool pair = char.IsHighSurrogate(value[at]) && at + 1 < value.Length && char.IsLowSurrogate(value[at + 1]);
        if (char.IsSurrogate(value[at]) && !pair)
        {
            throw new ArgumentException("the text has half of a surrogate pair at character " + at + "; expected whole characters", nameof(value));
        }

        if (pair)
        {
            point = char.ConvertToUtf32(value[at], value[at + 1]);
            Append((byte)(0xF0 | (point >> 18)));
            Append((byte)(0x80 | ((point >> 12) & 0x3F)));
        }
        else if (point >= 0x800)
        {
            Append((byte)(0xE0 | (point >> 12)));
        }
        else
        {
            Append((byte)(0xC0 | (point >> 6)));
        }

        if (point >= 0x800)
        {
            Append((byte)(0x80 | ((point >> 6) & 0x3F)));
        }

        Append((byte)(0x80 | (point & 0x3F)));
        return pair ? 1 : 0;
    }

    private void RequireFinished()
    {
        if (depth > 0 || length == 0)
        {
            throw new InvalidOperationException("the text is not finished; expected one whole value");
        }
    }

    private void Append(byte value)
    {
        if (length == buffer.Length)
        {
            Grow(1);
        }

        buffer[length++] = value;
    }

    private void Append(ReadOnlySpan<byte> bytes)
    {
        bytes.CopyTo(Room(bytes.Length));
        length += bytes.Length;
    }

    /// <summary>Where the next bytes go.</summary>
    private Span<byte> Room(int count)
    {
        if (count > buffer.Length - length)
        {
            Grow(count);
        }

        return buffer.AsSpan(length);
    }

    private void Grow(int count)
    {
        byte[] larger = ArrayPool<byte>.Shared.Rent(Math.Max(length + count, 2 * buffer.Length));
        buffer.AsSpan(0, length).CopyTo(larger);
        ArrayPool<byte>.Shared.Return(buffer);
        buffer = larger;
    }

    private struct Scope
    {
        public byte Opening;
        public JsonLayout Layout;
        public int Count;
    }
}
