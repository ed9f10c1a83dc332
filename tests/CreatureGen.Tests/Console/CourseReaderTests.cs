using System;
using System.Linq;
using CreatureGen.Console;
using CreatureGen.Console.Arguments;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class CourseReaderTests
{
    private static readonly MotionProfile cat = new(SpeciesSubject.Of("feline", RequestedKind.Walking));

    [Fact]
    public void Commands_ask_one_after_the_other_and_turns_keep_the_speed()
    {
        CourseScript script = CourseReader.Read("idle 1; walk; run 2.5; turn left at 1.5; straight; turn right 0.5; strafe left at 0.4; reverse; stop;", cat);
        float run = cat.Gaits!.Speeds[^1].Comfortable;
        Assert.Equal([1f, 2f, 2.5f, 2f, 2f, 0.5f, 2f, 2f, 2f], script.Commands.Select(command => command.Seconds));
        Assert.Equal([0f, cat.Gaits.Speeds[0].Comfortable, run, run, run, run, 0f], script.Commands.Take(7).Select(command => command.Input.Speed));
        Assert.Equal([0f, 0f, 0f, 1.5f, 0f, -1f, 0f, 0f, 0f], script.Commands.Select(command => command.Input.YawRate));
        Assert.Equal(0.4f, script.Commands[6].Input.Sideways);
        Assert.True(script.Commands[7].Input.Speed < 0f);
        Assert.Equal(default, script.Commands[8].Input);
        Assert.Equal("turn left at 1.5", script.Commands[3].ToString());
    }

    [Fact]
    public void Words_are_those_of_the_creature()
    {
        var bird = new MotionProfile(SpeciesSubject.Of("raptor", RequestedKind.Flying));
        var eel = new MotionProfile(SpeciesSubject.Of("eel", RequestedKind.Swimming));
        CourseScript flight = CourseReader.Read("idle; take-off; fly; climb at 0.5; dive; land", bird);
        Assert.Equal([MotionMedium.Ground, MotionMedium.Air, MotionMedium.Air, MotionMedium.Air, MotionMedium.Air, MotionMedium.Ground], flight.Commands.Select(command => command.Input.Medium));
        Assert.Equal(0.5f, flight.Commands[3].Input.ClimbRate);
        Assert.True(flight.Commands[4].Input.ClimbRate < 0f);
        CourseScript dart = CourseReader.Read("swim; c-start right; turn left", eel);
        Assert.Equal([EscapeTurn.None, EscapeTurn.Right, EscapeTurn.None], dart.Commands.Select(command => command.Input.Escape));
        Assert.Contains("expected one of swim", Assert.Throws<FormatException>(() => CourseReader.Read("walk", eel)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_measured_scripts_have_names()
    {
        Assert.Equal(CourseScripts.Random(cat, 5f, 2.5f).Commands, CourseReader.Read("random 5", cat).Commands);
        Assert.Equal(CourseScripts.Spin(cat).Commands, CourseReader.Read(" spin ", cat).Commands);
        Assert.Equal(CourseScripts.Runner(cat, 12f).Commands, CourseReader.Read("RUNNER", cat).Commands);
    }

    [Theory]
    [InlineData("", "command 1 ''; expected one of walk")]
    [InlineData("walk;;stop", "command 2 ''; expected one of walk")]
    [InlineData("walk; rnu 2", "command 2 'rnu 2'; expected one of walk")]
    [InlineData("walk; rnu 2", "did you mean run?")]
    [InlineData("turn", "command 1 'turn'; expected turn left or turn right")]
    [InlineData("turn up", "expected turn left or turn right")]
    [InlineData("walk at fast", "expected a number after at")]
    [InlineData("walk -1", "expected seconds")]
    [InlineData("walk NaN", "expected seconds")]
    [InlineData("walk 1 2", "expected nothing after the seconds, not '2'")]
    [InlineData("walk 50; run 50", "the script takes 100 s; expected at most 60 s")]
    public void Bad_scripts_are_refused_by_their_command(string script, string expected) =>
        Assert.Contains(expected, Assert.Throws<FormatException>(() => CourseReader.Read(script, cat)).Message, StringComparison.Ordinal);

    [Fact]
    public void A_course_is_written_as_a_moving_picture_and_a_strip_the_same_on_any_threads()
    {
        using var one = new ConsoleRun();
        using var two = new ConsoleRun();
        string[] arguments = ["animate", "--seed", "42", "--course", "walk 0.3; turn left 0.2; stop 0.1", "--ground", "stairs", "--out", "go.png", "--size", "64"];
        Assert.Equal(ExitCode.Done, one.Run([.. arguments, "--threads", "1"]));
        Assert.Equal(ExitCode.Done, two.Run([.. arguments, "--threads", "2"]));
        Assert.Equal(["go-strip.png", "go.png"], one.Files);
        Assert.Contains("3 commands in 0.6 s, 13 frames", one.Out, StringComparison.Ordinal);
        Assert.All(one.Files, name => Assert.Equal(System.IO.File.ReadAllBytes(System.IO.Path.Combine(one.Folder, name)), System.IO.File.ReadAllBytes(System.IO.Path.Combine(two.Folder, name))));
    }

    [Fact]
    public void Bad_courses_leave_no_file()
    {
        using var run = new ConsoleRun();
        Assert.Equal("creaturegen: animate: --course: command 1 'turn'; expected turn left or turn right", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--course", "turn", "--out", "a.png"));
        Assert.Contains("--course and --gait; expected one of them", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--course", "walk", "--gait", "walk", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("expected one of flat, rough, stairs, lift, slope, gap, platform", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--course", "walk", "--ground", "steep", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }
}
