using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Documents;

public sealed partial class GaitTableTests
{
    [Fact]
    public void The_table_of_gaits_is_what_the_library_brings()
    {
        string[] listed = GaitRow().Matches(RepositoryFiles.Text("docs/gaits.md")).Select(m => m.Value).ToArray();
        Assert.Equal(Gaits().Select(Row), listed);
    }

    private static IEnumerable<Gait> Gaits() =>
        typeof(GaitLibrary).GetProperties(BindingFlags.Public | BindingFlags.Static).Where(one => one.PropertyType == typeof(Gait)).Select(one => (Gait)one.GetValue(null)!);

    /// <summary>A row as the document has it, lags at the gait's comfortable speed on two pairs of legs, or on one.</summary>
    private static string Row(Gait gait)
    {
        int rows = Math.Min(2, gait.MaxRows);
        float duty = gait.Duty.At(gait.Comfortable);
        string hind = Lag(gait, 0, rows, Side.Left, duty) + " | " + Lag(gait, 0, rows, Side.Right, duty);
        string fore = rows < 2 ? " | " : Lag(gait, 1, rows, Side.Left, duty) + " | " + Lag(gait, 1, rows, Side.Right, duty);
        string law = gait.Duty.Slope == 0f ? Number(gait.Duty.Intercept) : $"{Number(gait.Duty.Intercept)} − {Number(gait.Duty.Slope)}√Fr";
        string stride = $"{Number(gait.Stride.Factor)} Fr^{Number(gait.Stride.Exponent)}";
        return $"| {gait.Name} | {hind} | {fore} | {law} | {stride} | {Number(gait.Comfortable)} | {Number(gait.Fastest)} |";
    }

    private static string Lag(Gait gait, int row, int rows, Side side, float duty)
    {
        float lag = gait.Phases.Lag(row, rows, side, duty);
        return Number(lag - MathF.Floor(lag));
    }

    private static string Number(float value) => value.ToString("0.###", CultureInfo.InvariantCulture);

    [GeneratedRegex(@"^\| [A-Z]\w+ \| [\d.]+ \| [\d.]+ \|[^\n]*\|$", RegexOptions.Multiline)]
    private static partial Regex GaitRow();
}
