using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using CreatureGen.Blueprints;
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
        private readonly StringBuilder rows = new();
        private readonly StringBuilder following = new();
        private readonly HashSet<Type> listed;

        private FieldTables(HashSet<Type> listed) => this.listed = listed;

        public static string Of<T>(RecordDescription<T> description)
            where T : class, IEquatable<T> => Of(description, new HashSet<Type>());

        public double Number(string name, double value, NumberRange range) => Row(name, range.ToString(), value);

        public int Whole(string name, int value, WholeRange range) => Row(name, range.ToString(), value);

        public ulong UnsignedText(string name, ulong value) => Row(name, "a string of the digits of a number of 64 bits", value);

        public ulong? OptionalText(string name, ulong? value) => Row(name, "left out, or a string of the digits of a number of 64 bits", value);

        public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
            where TEnum : struct, Enum => Row(name, names.ToString(), value);

        public string Word(string name, string value, IReadOnlyList<string> known) => Row(name, FieldChecker.OneOf(known), value);

        public T Record<T>(string name, T value, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            Follow(description);
            return Row(name, "`" + typeof(T).Name + "`", value);
        }

        public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            Follow(description);
            return Row(name, "an array of " + count.Bounds() + " `" + typeof(T).Name + "`", value);
        }

        private static string Of<T>(RecordDescription<T> description, HashSet<Type> listed)
            where T : class, IEquatable<T>
        {
            listed.Add(typeof(T));
            var tables = new FieldTables(listed);
            description.Visit(tables, description.Neutral);
            return "\n### " + typeof(T).Name + "\n\n| field | value |\n| --- | --- |\n" + tables.rows + tables.following;
        }

        private void Follow<T>(RecordDescription<T> description)
            where T : class, IEquatable<T>
        {
            if (!listed.Contains(typeof(T)))
            {
                following.Append(Of(description, listed));
            }
        }

        private T Row<T>(string name, string range, T value)
        {
            rows.Append("| `").Append(name).Append("` | ").Append(range).Append(" |\n");
            return value;
        }
    }
}
