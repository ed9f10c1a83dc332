using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>Tells how creatures move, as they come.</summary>
/// <typeparam name="TRun">What was measured.</typeparam>
internal interface IRunReport<TRun> : IDisposable
{
    /// <summary>The next run.</summary>
    void Add(TRun run);

    /// <summary>That was all. Not called when the work failed.</summary>
    void End();
}

/// <summary>One JSON object with a line for each run, then the worst of each measure. It is closed even when the work fails, so that what was done can be read. The names are a contract.</summary>
internal sealed class RunJson<TRun> : IRunReport<TRun>
    where TRun : IMeasuredRun<TRun>
{
    private readonly TextWriter output;
    private readonly WorstRuns<TRun> worst = new();

    /// <summary>Begins the object.</summary>
    public RunJson(TextWriter output)
    {
        this.output = output;
        output.Write("{\"runs\":[");
    }

    /// <inheritdoc/>
    public void Add(TRun run)
    {
        output.Write(worst.Runs > 0 ? ",\n" : "\n");
        worst.Add(run);
        output.Write(JsonText.Line(json =>
        {
            json.WriteStartObject();
            run.WriteName(json);
            run.WriteFacts(json);
            foreach (Measure<TRun> measure in TRun.Measures)
            {
                JsonText.WriteNumber(json, measure.Name, measure.Value(run));
            }

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
            foreach (Measure<TRun> measure in TRun.Measures)
            {
                if (worst.Of(measure) is not (float value, TRun run))
                {
                    json.WriteNull(measure.Name);
                    continue;
                }

                json.WriteStartObject(measure.Name);
                json.WriteNumber("value", value);
                run.WriteName(json);
                json.WriteEndObject();
            }

            json.WriteEndObject();
        }));
        output.Write("}\n");
    }
}

/// <summary>A table with a row for everything that creatures did on each ground, and the worst of each measure.</summary>
internal sealed class RunTable<TRun>(TextWriter output, Ink ink) : IRunReport<TRun>
    where TRun : IMeasuredRun<TRun>
{
    private const int NameWidth = 34;
    private const int ColumnWidth = 9;

    private readonly WorstRuns<TRun> all = new();
    private readonly SortedDictionary<MeasureRow, WorstRuns<TRun>> rows = [];

    /// <inheritdoc/>
    public void Add(TRun run)
    {
        all.Add(run);
        if (!rows.TryGetValue(run.Row, out WorstRuns<TRun>? row))
        {
            rows.Add(run.Row, row = new WorstRuns<TRun>());
        }

        row.Add(run);
    }

    /// <inheritdoc/>
    public void End()
    {
        output.WriteLine("The worst of each; lengths in % of the leg, angles in degrees.");
        output.WriteLine();
        output.WriteLine(ink.Heading("".PadRight(NameWidth) + "runs".PadLeft(ColumnWidth) + string.Concat(TRun.Columns.Select(column => column.Heading.PadLeft(ColumnWidth)))));
        foreach ((MeasureRow name, WorstRuns<TRun> row) in rows)
        {
            Row($"{WordList<LocomotionKind>.Instance[name.Kind],-9} {name.Act,-16} {name.Ground}", row);
        }

        Row("all", all);
        output.WriteLine();
        output.WriteLine(ink.Heading("Worst"));
        int width = TRun.Measures.Max(measure => measure.Name.Length) + 2;
        foreach (Measure<TRun> measure in TRun.Measures)
        {
            string found = all.Of(measure) is (float value, TRun run) ? value.ToString("0.#####", CultureInfo.InvariantCulture).PadRight(10) + "  " + run : "-";
            output.WriteLine("  " + measure.Name.PadRight(width) + found);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
    }

    private void Row(string name, WorstRuns<TRun> row)
    {
        string cells = string.Concat(TRun.Columns.Select(column => (row.Of(column.Measure) is (float value, _) ? column.Text(value) : "-").PadLeft(ColumnWidth)));
        output.WriteLine(name.PadRight(NameWidth) + Units.Count(row.Runs).PadLeft(ColumnWidth) + cells);
    }
}
