using System;
using System.Globalization;
using System.Linq;
using CreatureGen.Json;
using CreatureGen.Seeding;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace CreatureGen.Tests.Json;

public sealed class JsonRoundTripTests
{
    private static readonly Config Thorough = Config.QuickThrowOnFailure.WithMaxTest(2000);

    [Fact]
    public void Any_text_is_read_as_it_was_written_or_refused_for_half_a_pair()
    {
        Check.One(Thorough, Prop.ForAll<char[]>(characters =>
        {
            string text = new(characters);
            if (SurrogatePairs.IndexOfLoneHalf(text) >= 0)
            {
                Assert.Throws<ArgumentException>(() => new JsonWriter(JsonLayout.Compact).Text(text));
                return;
            }

            byte[] json = new JsonWriter(JsonLayout.Line).BeginObject().Name(text).Text(text).EndObject().Utf8.ToArray();
            JsonMember member = Assert.Single(JsonReader.Read(json, JsonLimits.Document).Root!.Members);
            Assert.Equal(text, member.Name);
            Assert.Equal(text, member.Value.Text);
        }));
    }

    [Fact]
    public void Any_finite_number_is_read_as_it_was_written()
    {
        Check.One(Thorough, Prop.ForAll<NormalFloat>(number =>
        {
            byte[] json = new JsonWriter(JsonLayout.Compact).BeginArray().Number(number.Get).EndArray().Utf8.ToArray();
            Assert.Equal(number.Get, JsonReader.Read(json, JsonLimits.Document).Root![0].Number);
        }));
    }

    [Fact]
    public void Any_text_at_all_gives_a_document_or_a_report()
    {
        Check.One(Thorough, Prop.ForAll<string>(text =>
        {
            JsonReading reading = JsonReader.Read(text ?? "", JsonLimits.Document);
            Assert.True(reading.Root is not null || reading.Problems.Count > 0);
        }));
    }

    [Fact]
    public void Trees_are_read_as_they_were_written_in_every_layout()
    {
        RandomStream random = new Seed(10).Stream();
        for (int i = 0; i < 300; i++)
        {
            JsonLayout layout = (JsonLayout)random.Integer(0, 3);
            var writer = new JsonWriter(layout);
            WriteTree(writer, random, 0);
            byte[] json = writer.Utf8.ToArray();
            JsonReading reading = JsonReader.Read(json, JsonLimits.Document);
            Assert.Empty(reading.Problems);
            var again = new JsonWriter(layout);
            Copy(reading.Root!, again);
            Assert.Equal(json, again.Utf8.ToArray());
        }
    }

    private static void WriteTree(JsonWriter writer, RandomStream random, int depth)
    {
        switch (random.Integer(depth > 6 ? 2 : 0, 7))
        {
            case 0:
                writer.BeginObject();
                for (int i = random.Integer(0, 14); i > 0; i--)
                {
                    writer.Name("é" + i.ToString(CultureInfo.InvariantCulture));
                    WriteTree(writer, random, depth + 2);
                }

                writer.EndObject();
                break;
            case 1:
                writer.BeginArray();
                for (int i = random.Integer(0, 5); i > 0; i--)
                {
                    WriteTree(writer, random, depth + 1);
                }

                writer.EndArray();
                break;
            case 2:
                writer.Number(random.Uniform(-1, 1) * random.NextUInt64());
                break;
            case 3:
                writer.Number(random.Integer(-1000, 1000));
                break;
            case 4:
                writer.Text("🦊\t" + random.Integer(0, 1000).ToString(CultureInfo.InvariantCulture));
                break;
            case 5:
                writer.Boolean(random.Chance(0.5));
                break;
            default:
                writer.Null();
                break;
        }
    }

    private static void Copy(JsonValue value, JsonWriter writer)
    {
        switch (value.Kind)
        {
            case JsonKind.Object:
                writer.BeginObject();
                value.Members.ToList().ForEach(member => Copy(member.Value, writer.Name(member.Name)));
                writer.EndObject();
                break;
            case JsonKind.Array:
                writer.BeginArray();
                value.Items.ToList().ForEach(item => Copy(item, writer));
                writer.EndArray();
                break;
            case JsonKind.Number:
                writer.Number(value.Number);
                break;
            case JsonKind.Text:
                writer.Text(value.Text);
                break;
            case JsonKind.Boolean:
                writer.Boolean(value.IsTrue);
                break;
            default:
                writer.Null();
                break;
        }
    }
}
