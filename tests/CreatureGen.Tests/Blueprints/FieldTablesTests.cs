using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Json;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class FieldTablesTests
{
    private const string Marker = "<!-- generated from the descriptions of the records -->\n";

    [Fact]
    public void The_page_on_JSON_lists_every_field_with_its_range()
    {
        string expected = FieldTables.Of(CreatureFields.Creature) + FieldTables.Of(OptionsFields.Options);

        // To renew the page, copy this over all that follows its marker.
        File.WriteAllText(Path.Combine(AppContext.BaseDirectory, "field-tables.md"), expected);
        string page = File.ReadAllText(PagePath()).Replace("\r\n", "\n", StringComparison.Ordinal);
        Assert.Equal(expected, page[(page.IndexOf(Marker, StringComparison.Ordinal) + Marker.Length)..]);
    }

    private static string PagePath()
    {
        for (string? folder = AppContext.BaseDirectory; folder != null; folder = Path.GetDirectoryName(folder))
        {
            string page = Path.Combine(folder, "docs", "blueprint-json.md");
            if (File.Exists(page))
            {
                return page;
            }
        }

        throw new FileNotFoundException("no docs/blueprint-json.md above " + AppContext.BaseDirectory);
    }

    /// <summary>Lists the fields of a record and of all records in it, each kind of record once.</summary>
    private sealed class FieldTables : IFieldVisitor
    {
        private readonly StringBuilder rows;
        private readonly StringBuilder following;
        private readonly HashSet<Type> listed;
        private readonly int since;

        private FieldTables(StringBuilder rows, StringBuilder following, HashSet<Type> listed, int since)
        {
            this.rows = rows;
            this.following = following;
            this.listed = listed;
            this.since = since;
        }

        public static string Of<T>(RecordDescription<T> description)
            where T : class, IEquatable<T> => Of(description, new HashSet<Type>());

        public IFieldVisitor Since(int format) => new FieldTables(rows, following, listed, format);

        public double Number(string name, double value, NumberRange range) => Row(name, range.ToString(), value, NumberText.Of(value));

        public int Whole(string name, int value, WholeRange range) => Row(name, range.ToString(), value, NumberText.Of(value));

        public int Version(string name, int value, int current) => Row(name, "a whole number from 1 to that of the library", value, "");

        public ulong UnsignedText(string name, ulong value) => Row(name, "a string of the digits of a number of 64 bits", value, "0");

        public ulong? OptionalText(string name, ulong? value) => Row(name, "left out, or a string of the digits of a number of 64 bits", value, "left out");

        public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
            where TEnum : struct, Enum => Row(name, names.ToString(), value, names.NameOf(value)!);

        public string Word(string name, string value, IReadOnlyList<string> known) => Row(name, FieldChecker.OneOf(known), value, value);

        public T Record<T>(string name, T value, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            Follow(description);
            return Row(name, "`" + typeof(T).Name + "`", value, "");
        }

        public T? Optional<T>(string name, T? value, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            Follow(description);
            return Row(name, "left out, or `" + typeof(T).Name + "`", value, "left out");
        }

        public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            Follow(description);
            return Row(name, "an array of " + count.Bounds() + " `" + typeof(T).Name + "`", value, value.Count == 0 ? "[]" : "");
        }

        private static string Of<T>(RecordDescription<T> description, HashSet<Type> listed)
            where T : class, IEquatable<T>
        {
            listed.Add(typeof(T));
            var tables = new FieldTables(new StringBuilder(), new StringBuilder(), listed, BlueprintFormat.First);
            description.Visit(tables, description.Neutral);
            return "\n### " + typeof(T).Name + "\n\n| field | value | default | since |\n| --- | --- | --- | --- |\n" + tables.rows + tables.following;
        }

        private void Follow<T>(RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            if (!listed.Contains(typeof(T)))
            {
                following.Append(Of(description, listed));
            }
        }

        private T Row<T>(string name, string range, T value, string neutral)
        {
            rows.Append("| `").Append(name).Append("` | ").Append(range).Append(" | ").Append(neutral).Append(" | ").Append(since).Append(" |\n");
            return value;
        }
    }
}
