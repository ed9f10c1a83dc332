using System;
using System.IO;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace CreatureGen.Console.Text;

/// <summary>JSON as text, lines ended by line feeds on every system.</summary>
internal static class JsonText
{
    /// <summary>On one line, without an end of line.</summary>
    public static string Line(Action<Utf8JsonWriter> write) => Of(write, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });

    /// <summary>Indented, with an end of line.</summary>
    public static string Document(Action<Utf8JsonWriter> write) =>
        Of(write, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping, Indented = true, NewLine = "\n" }) + "\n";

    /// <summary>Writes a number, or null where there is none.</summary>
    public static void WriteNumber(Utf8JsonWriter json, string name, float? value)
    {
        if (value is float number)
        {
            json.WriteNumber(name, number);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    private static string Of(Action<Utf8JsonWriter> write, JsonWriterOptions options)
    {
        var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes, options))
        {
            write(json);
        }

        return Encoding.UTF8.GetString(bytes.GetBuffer(), 0, (int)bytes.Length);
    }
}
