using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Motion;

namespace CreatureGen.Console.Text;

/// <summary>Tells how creatures move, as they come.</summary>
internal interface IMotionReport : IDisposable
{
    /// <summary>The next run.</summary>
    void Add(MeasuredRun run);

    /// <summary>That was all. Not called when the work failed.</summary>
    void End();
}

/// <summary>One JSON object with a line for each run, then the worst of each measure. It is closed even when the work fails, so that what was done can be read. The names are a contract.</summary>
internal sealed class MotionJson : IMotionReport
{
    private readonly TextWriter output;
    private readonly MotionWorst worst = new();

    /// <summary>Begins the object.</summary>
    public MotionJson(TextWriter output)
    {
        this.output = output;
        output.Write("{\"runs\":[");
    }

    /// <inheritdoc/>
    public void Add(MeasuredRun run)
    {
        output.Write(worst.Runs > 0 ? ",\n" : "\n");
        worst.Add(run);
        output.Write(JsonText.Line(json =>
        {
            json.WriteStartObject();
            WriteName(json, run.Name);
            json.WriteString("plan", WordList<BodyPlan>.Instance[run.Plan]);
            json.WriteNumber("speedMetresPerSecond", run.Speed);
            WriteNumber(json, "legLengthMetres", run.LegLength);
            json.WriteNumber("frames", run.Report.Frames);
            json.WriteNumber("seconds", run.Report.Seconds);
            foreach (MotionMeasure measure in MotionMeasure.All)
            {
                WriteNumber(json, measure.Name, measure.Value(run));
            }

            json.WriteString("limitExcessMaxJoint", run.WorstJoint);
            json.WriteEndObject();
        }));
    }

    /// <inheritdoc/>
    public void End()
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        output.Write(worst.Runs > 0 ? "\n],\n\"worst\":" : "],\n\"worst\":");
        output.Write(JsonText.Line(json =>
        {
            json.WriteStartObject();
            foreach (MotionMeasure measure in MotionMeasure.All)
            {
                if (worst.Of(measure) is not (float value, RunName name))
                {
                    json.WriteNull(measure.Name);
                    continue;
                }

                json.WriteStartObject(measure.Name);
                json.WriteNumber("value", value);
                WriteName(json, name);
                json.WriteEndObject();
            }

            json.WriteEndObject();
        }));
        output.Write("}\n");
    }

    private static void WriteName(Utf8JsonWriter json, RunName name)
    {
        json.WriteString("kind", WordList<LocomotionKind>.Instance[name.Kind]);
        json.WriteString("seed", SeedText.Of(name.Seed));
        json.WriteString("gait", name.Gait);
        json.WriteString("ground", WordList<GroundRelief>.Instance[name.Ground]);
        json.WriteNumber("hertz", name.Hertz);
    }

    private static void WriteNumber(Utf8JsonWriter json, string name, float? value)
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
}

/// <summary>A table with a row for each gait on each ground, and the worst of each measure.</summary>
internal sealed class MotionTable(TextWriter output, Ink ink) : IMotionReport
{
    private const int NameWidth = 34;
    private const int ColumnWidth = 9;

    private static readonly (string Heading, MotionMeasure Measure, Func<float, string> Text)[] columns =
    [
        ("slip", MotionMeasure.Slip, Percent),
        ("sinks", MotionMeasure.Penetration, Percent),
        ("clears", MotionMeasure.Clearance, Percent),
        ("short", MotionMeasure.Residual, Percent),
        ("beyond", MotionMeasure.LimitExcess, value => value.ToString("0.0", CultureInfo.InvariantCulture)),
        ("limits", MotionMeasure.LimitViolations, value => value.ToString("0", CultureInfo.InvariantCulture)),
        ("jump", MotionMeasure.PoseJump, value => value.ToString("0.0", CultureInfo.InvariantCulture)),
        ("feet", MotionMeasure.Support, value => value.ToString("0", CultureInfo.InvariantCulture)),
    ];

    private readonly MotionWorst all = new();
    private readonly SortedDictionary<(LocomotionKind Kind, string Gait, GroundRelief Ground), MotionWorst> rows = new(Comparer<(LocomotionKind Kind, string Gait, GroundRelief Ground)>.Create(Compare));

    /// <inheritdoc/>
    public void Add(MeasuredRun run)
    {
        all.Add(run);
        (LocomotionKind Kind, string Gait, GroundRelief Ground) key = (run.Name.Kind, run.Name.Gait, run.Name.Ground);
        if (!rows.TryGetValue(key, out MotionWorst? row))
        {
            rows.Add(key, row = new MotionWorst());
        }

        row.Add(run);
    }

    /// <inheritdoc/>
    public void End()
    {
        output.WriteLine("The worst of each; lengths in % of the leg, angles in degrees.");
        output.WriteLine();
        output.WriteLine(ink.Heading("".PadRight(NameWidth) + "runs".PadLeft(ColumnWidth) + string.Concat(columns.Select(column => column.Heading.PadLeft(ColumnWidth)))));
        foreach (((LocomotionKind kind, string gait, GroundRelief ground), MotionWorst row) in rows)
        {
            Row($"{WordList<LocomotionKind>.Instance[kind],-9} {gait,-16} {WordList<GroundRelief>.Instance[ground]}", row);
        }

        Row("all", all);
        output.WriteLine();
        output.WriteLine(ink.Heading("Worst"));
        int width = MotionMeasure.All.Max(measure => measure.Name.Length) + 2;
        foreach (MotionMeasure measure in MotionMeasure.All)
        {
            string found = all.Of(measure) is (float value, RunName run) ? value.ToString("0.#####", CultureInfo.InvariantCulture).PadRight(10) + "  " + run : "-";
            output.WriteLine("  " + measure.Name.PadRight(width) + found);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
    }

    private static string Percent(float value) => (value * 100f).ToString("0.00", CultureInfo.InvariantCulture);

    private static int Compare((LocomotionKind Kind, string Gait, GroundRelief Ground) a, (LocomotionKind Kind, string Gait, GroundRelief Ground) b) =>
        a.Kind != b.Kind ? a.Kind.CompareTo(b.Kind) : a.Gait != b.Gait ? string.CompareOrdinal(a.Gait, b.Gait) : a.Ground.CompareTo(b.Ground);

    private void Row(string name, MotionWorst row)
    {
        string cells = string.Concat(columns.Select(column => (row.Of(column.Measure) is (float value, _) ? column.Text(value) : "-").PadLeft(ColumnWidth)));
        output.WriteLine(name.PadRight(NameWidth) + Units.Count(row.Runs).PadLeft(ColumnWidth) + cells);
    }
}
