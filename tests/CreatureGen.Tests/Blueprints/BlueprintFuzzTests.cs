using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class BlueprintFuzzTests
{
    private static readonly string[] Snippets =
    {
        "null", "true", "1e999", "-1e999", "1e-999", "NaN", "[]", "{}", "[[[[", "\"\"", "\"\\ud800\"", "-0", "99999999999999999999", "{\"\":0}", ",", ":", "}", "]", "\"", "\\", "\0", "é",
    };

    [Fact]
    public void Every_truncation_is_reported()
    {
        byte[] good = Encoding.UTF8.GetBytes(BlueprintJson.Write(Samples.Small));

        // The line feed at the end is not needed.
        for (int length = 0; length < good.Length - 1; length++)
        {
            BlueprintReading reading = Read(good[..length]);
            Assert.Null(reading.Blueprint);
            Assert.Single(reading.Problems);
        }
    }

    [Fact]
    public void Flipped_bytes_give_a_blueprint_or_a_report()
    {
        RandomStream random = new Seed(6).Child("bytes").Stream();
        byte[][] texts = Samples.Drawn(3).Append(Samples.Small).Select(blueprint => Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint))).ToArray();
        int taken = 0;
        for (int i = 0; i < Thoroughness.Of(10_000); i++)
        {
            byte[] text = (byte[])texts[random.Integer(0, texts.Length)].Clone();
            for (int flips = random.Integer(1, 5); flips > 0; flips--)
            {
                int at = random.Integer(0, text.Length);
                text[at] = random.Integer(0, 3) switch
                {
                    0 => (byte)random.Integer(0, 256),
                    1 => (byte)(text[at] ^ (1 << random.Integer(0, 8))),
                    _ => text[random.Integer(0, text.Length)],
                };
            }

            taken += Read(text).Blueprint is null ? 0 : 1;
        }

        // Changed digits and white space leave many texts good.
        Assert.InRange(taken, Thoroughness.Of(100), Thoroughness.Of(9_000));
    }

    [Fact]
    public void Swapped_values_give_a_blueprint_or_a_report()
    {
        RandomStream random = new Seed(6).Child("values").Stream();
        string good = BlueprintJson.Write(Samples.Small);
        (int Start, int End)[] values = Values(good).ToArray();
        Assert.InRange(values.Length, 150, 1000);
        int taken = 0;
        for (int i = 0; i < Thoroughness.Of(10_000); i++)
        {
            (int start, int end) = values[random.Integer(0, values.Length)];
            (int otherStart, int otherEnd) = values[random.Integer(0, values.Length)];
            string swap = random.Chance(0.5) ? good[otherStart..otherEnd] : Snippets[random.Integer(0, Snippets.Length)];
            taken += Read(Encoding.UTF8.GetBytes(good[..start] + swap + good[end..])).Blueprint is null ? 0 : 1;
        }

        Assert.InRange(taken, Thoroughness.Of(100), Thoroughness.Of(9_000));
    }

    [Fact]
    public void Removed_and_inserted_pieces_give_a_blueprint_or_a_report()
    {
        RandomStream random = new Seed(6).Child("pieces").Stream();
        string good = BlueprintJson.Write(Samples.Small);
        for (int i = 0; i < Thoroughness.Of(10_000); i++)
        {
            int start = random.Integer(0, good.Length);
            int end = Math.Min(good.Length, start + random.Integer(0, 60));
            string piece = random.Integer(0, 3) switch
            {
                0 => "",
                1 => Snippets[random.Integer(0, Snippets.Length)],
                _ => good.Substring(random.Integer(0, good.Length - 60), random.Integer(1, 60)),
            };
            Read(Encoding.UTF8.GetBytes(good[..start] + piece + good[end..]));
        }
    }

    /// <summary>Reads, and holds every answer to what is promised of answers.</summary>
    private static BlueprintReading Read(byte[] text)
    {
        BlueprintReading reading = BlueprintJson.Read(new MemoryStream(text));
        Assert.Equal(reading.Problems.Count == 0, reading.Blueprint is not null);
        foreach (Problem problem in reading.Problems)
        {
            Assert.True(problem.Path.Length > 0 && problem.Value.Length > 0 && problem.Expectation.Length > 0, problem.ToString());
            Assert.True(problem.ToString().Length < 600, problem.ToString());
        }

        if (reading.Blueprint is { } blueprint)
        {
            Assert.Empty(BlueprintValidator.Validate(blueprint));
            Assert.Equal(blueprint, BlueprintJson.Read(BlueprintJson.Write(blueprint)).Blueprint);
        }

        return reading;
    }

    /// <summary>Where the numbers and strings stand that follow a name.</summary>
    private static IEnumerable<(int Start, int End)> Values(string text)
    {
        for (int at = text.IndexOf(": ", StringComparison.Ordinal); at >= 0; at = text.IndexOf(": ", at + 1, StringComparison.Ordinal))
        {
            int start = at + 2;
            if (text[start] is not ('{' or '['))
            {
                yield return (start, text.IndexOfAny([',', '\n', ' ', '}'], start));
            }
        }
    }
}
