using System;
using System.Linq;
using System.Text.Json;
using CreatureGen.Console;
using CreatureGen.Console.Working;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class CourseVerbTests
{
    private static readonly string[] contract =
    [
        "kind", "seed", "script", "ground", "hertz", "limitExcessMaxDegrees", "jointSpeedMaxRadiansPerSecond", "stanceSlipMaxLegLengths", "penetrationMaxLegLengths", "rootLagMaxLegLengths", "lostGround",
        "clearanceMinLegLengths", "linearAccelerationMaxG", "restingFootSpreadLegLengths", "supportMin",
    ];

    [Fact(Explicit = true)]
    public void Courses_are_told_run_by_run_with_the_worst_of_each_measure_whatever_the_number_of_threads()
    {
        using var one = new ConsoleRun();
        using var two = new ConsoleRun();
        Assert.Equal(ExitCode.Done, one.Run("metrics", "--course", "--seeds", "4-5", "--kind", "swimming", "--json", "--threads", "1"));
        Assert.Equal(ExitCode.Done, two.Run("metrics", "--course", "--seeds", "4-5", "--kind", "swimming", "--json", "--threads", "2"));
        Assert.Equal(one.Out, two.Out);
        JsonElement[] runs = one.Json().GetProperty("runs").EnumerateArray().ToArray();
        Assert.Equal(["4", "5"], runs.Select(told => told.GetProperty("seed").GetString()).Distinct());
        foreach (JsonElement told in runs)
        {
            string[] names = told.EnumerateObject().Select(member => member.Name).ToArray();
            Assert.All(contract, word => Assert.Contains(word, names));
            Assert.Equal("swimming", told.GetProperty("kind").GetString());
            Assert.Equal(JsonValueKind.Null, told.GetProperty("stanceSlipMaxLegLengths").ValueKind);
        }

        Assert.Contains(runs, told => told.GetProperty("hertz").ValueKind == JsonValueKind.String && told.GetProperty("hertz").GetString() == "uneven");
        Assert.Contains(runs, told => told.GetProperty("hertz").ValueKind == JsonValueKind.Number && told.GetProperty("hertz").GetInt32() == 480);
        foreach (Measure<MeasuredCourse> measure in CourseMeasure.All)
        {
            JsonElement worst = one.Json().GetProperty("worst").GetProperty(measure.Name);
            float[] values = runs.Select(told => told.GetProperty(measure.Name)).Where(value => value.ValueKind == JsonValueKind.Number).Select(value => value.GetSingle()).ToArray();
            Assert.Equal(values.Length == 0, worst.ValueKind == JsonValueKind.Null);
            Assert.True(values.Length == 0 || worst.GetProperty("value").GetSingle() == (measure.Worse == WorseFigure.Greater ? values.Max() : values.Min()), measure.Name);
        }
    }

    [Fact]
    public void Courses_on_one_ground_are_measured_alone_and_a_ground_without_courses_is_refused()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--course", "--ground", "stones", "--seeds", "4", "--kind", "walking", "--json", "--threads", "1"));
        Assert.All(run.Json().GetProperty("runs").EnumerateArray(), told => Assert.Equal("stones", told.GetProperty("ground").GetString()));
        using var wrong = new ConsoleRun();
        Assert.NotEqual(ExitCode.Done, wrong.Run("metrics", "--ground", "stones", "--seeds", "4"));
    }
}
