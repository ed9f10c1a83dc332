using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>Turns described records into JSON text and back.</summary>
internal static class RecordJson
{
    /// <summary>The record's text on one line, for messages and debuggers: it never fails, and is the same in every culture.</summary>
    public static string LineOf<T>(T record, RecordDescription<T> description)
        where T : class, IEquatable<T>
    {
        using var writer = new JsonWriter(JsonLayout.Line);
        FieldWriter.Write(writer, record, description, new ProblemList(""));
        return writer.ToString();
    }

    /// <summary>The record's text as a document: indented, and ended by a line feed.</summary>
    /// <exception cref="ArgumentException">The record holds what JSON cannot.</exception>
    public static string DocumentOf<T>(T record, RecordDescription<T> description, string what)
        where T : class, IEquatable<T>
    {
        using var writer = new JsonWriter(JsonLayout.Indented);
        Write(writer, record, description, what);
        return writer + "\n";
    }

    /// <summary>Writes the record as the writer's next value.</summary>
    /// <exception cref="ArgumentException">The record holds what JSON cannot.</exception>
    public static void Write<T>(JsonWriter writer, T record, RecordDescription<T> description, string what)
        where T : class, IEquatable<T>
    {
        var problems = new ProblemList(what);
        FieldWriter.Write(writer, record ?? throw new ArgumentNullException(what), description, problems);
        ThrowIfAny(problems.All, "the " + what + " cannot be written", what);
    }

    /// <summary>The root of a document, or null and problems.</summary>
    public static JsonValue? Parse(JsonReading reading, ProblemList problems)
    {
        foreach (JsonProblem problem in reading.Problems)
        {
            problems.Add(problem.Position, problem.Path, problem.Found, problem.Expectation);
        }

        return problems.All.Count == 0 ? reading.Root : null;
    }

    /// <summary>The bytes of a stream from its position on; of a longer stream, one more than the limit.</summary>
    public static byte[] Bytes(Stream stream, int limit)
    {
        using var bytes = new MemoryStream();
        byte[] block = new byte[8192];
        int count;
        do
        {
            count = stream.Read(block, 0, (int)Math.Min(block.Length, limit + 1 - bytes.Length));
            bytes.Write(block, 0, count);
        }
        while (count > 0);
        return bytes.ToArray();
    }

    /// <summary>Writes text in UTF-8 without a byte order mark.</summary>
    public static void WriteUtf8(Stream stream, string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        stream.Write(bytes, 0, bytes.Length);
    }

    /// <summary>Throws an exception that tells all problems, each on a line of its own.</summary>
    /// <exception cref="ArgumentException">There are problems.</exception>
    public static void ThrowIfAny(IReadOnlyList<Problem> problems, string complaint, string parameter)
    {
        if (problems.Count == 0)
        {
            return;
        }

        var message = new StringBuilder(complaint).Append(':');
        foreach (Problem problem in problems)
        {
            message.Append('\n').Append(problem);
        }

        throw new ArgumentException(message.ToString(), parameter);
    }
}
