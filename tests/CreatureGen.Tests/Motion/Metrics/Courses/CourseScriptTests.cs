using System;
using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

public sealed class CourseScriptTests
{
    [Fact]
    public void A_command_holds_from_the_end_of_the_one_before_it()
    {
        var script = new CourseScript("two", [new CourseCommand(1f, default), new CourseCommand(0.5f, new MotionInput(2f))]);
        Assert.Equal(1.5, script.Seconds);
        Assert.Equal([0, 0, 1, 1, 1], new[] { 0, 0.999, 1, 1.2, 9 }.Select(script.IndexAt));
        Assert.False(script.IsOver(1.49));
        Assert.True(script.IsOver(1.5));
    }

    [Fact]
    public void Bad_commands_are_refused_by_their_number()
    {
        Assert.Contains("at least one", Assert.Throws<ArgumentException>(() => new CourseScript("none", [])).Message, StringComparison.Ordinal);
        Assert.Contains("commands[1].Seconds", Assert.ThrowsAny<ArgumentException>(() => new CourseScript("s", [new CourseCommand(1f, default), new CourseCommand(0f, default)])).Message, StringComparison.Ordinal);
        Assert.Contains("commands[0].Input", Assert.ThrowsAny<ArgumentException>(() => new CourseScript("s", [new CourseCommand(1f, new MotionInput(float.NaN))])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => new CourseScript(null!, [new CourseCommand(1f, default)]));
    }

    [Fact]
    public void Random_scripts_are_those_of_the_seed_and_end_in_rest()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        CourseScript script = CourseScripts.Random(profile, 12f, 2.5f);
        Assert.Equal(script.Commands, CourseScripts.Random(profile, 12f, 2.5f).Commands);
        Assert.Equal(12 + CourseScripts.RestSeconds, script.Seconds, 1e-4);
        Assert.Equal(default, script.Commands[^1].Input);
        Assert.Contains(script.Commands, command => command.Input.YawRate > 0.5f);
        Assert.Contains(script.Commands, command => command.Input.YawRate < -0.5f);
        Assert.All(script.Commands, command => Assert.InRange(command.Input.Speed, 0f, profile.Gaits!.TopSpeed));
        Assert.All(CourseScripts.Random(profile, 12f, 0f).Commands, command => Assert.Equal(0f, command.Input.YawRate));
        Assert.All(CourseScripts.Runner(profile, 12f).Commands.SkipLast(1), command => Assert.InRange(command.Input.Speed, 0.5f * profile.Gaits!.TopSpeed, profile.Gaits.TopSpeed));
        CourseScript mixed = CourseScripts.Mixed(profile, 60f);
        Assert.Contains(mixed.Commands, command => command.Input.Speed < 0f);
        Assert.Contains(mixed.Commands, command => command.Input.Sideways != 0f);
        Assert.Contains(mixed.Commands, command => command.Gait != null);
    }

    [Fact]
    public void Keys_are_pressed_to_the_full_or_not_at_all()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        float top = profile.Gaits!.TopSpeed;
        CourseScript keys = CourseScripts.Keys(profile, 60f);
        Assert.Equal([-0.25f * top, 0f, 0.5f * top, top], keys.Commands.Select(command => command.Input.Speed).Distinct().Order());
        Assert.Equal([-2.5f, 0f, 2.5f], keys.Commands.Select(command => command.Input.YawRate).Distinct().Order());
    }

    [Fact]
    public void Commands_begin_with_an_update_at_every_rate()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        double time = 0;
        foreach (CourseCommand command in CourseScripts.Random(profile, 30f, 2f).Commands)
        {
            time += command.Seconds;
            Assert.All([30, 60, 144, 480], rate => Assert.Equal(Math.Round(time * rate), time * rate, 1e-3));
        }
    }

    [Fact]
    public void Only_what_flies_is_asked_into_the_air_and_only_what_swims_or_flies_to_climb()
    {
        CourseScript walker = CourseScripts.Random(new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking)), 30f, 2f);
        CourseScript flier = CourseScripts.Random(new MotionProfile(SpeciesSubject.Of("raptor", RequestedKind.Flying)), 30f, 2f);
        CourseScript fish = CourseScripts.Random(new MotionProfile(SpeciesSubject.Of("fish", RequestedKind.Swimming)), 30f, 2f);
        Assert.All(walker.Commands.Concat(fish.Commands), command => Assert.Equal(MotionMedium.Ground, command.Input.Medium));
        Assert.All(walker.Commands, command => Assert.Equal(0f, command.Input.ClimbRate));
        Assert.Contains(flier.Commands, command => command.Input.Medium == MotionMedium.Air && command.Input.ClimbRate != 0f);
        Assert.Contains(flier.Commands, command => command.Input.Medium == MotionMedium.Ground && command.Input.Speed > 0f);
        Assert.Contains(fish.Commands, command => command.Input.ClimbRate != 0f);
    }

    [Fact]
    public void Rates_are_even_or_those_of_a_game_that_stutters()
    {
        Assert.All(CourseRate.Of(144f).Steps(new Seed(1)).Take(10), step => Assert.Equal(1.0 / 144, step));
        double[] uneven = CourseRate.Uneven.Steps(new Seed(1)).Take(1000).ToArray();
        Assert.Equal([0.004, 0.016, 0.033, 0.1, 0.25], uneven.Distinct().Order());
        Assert.Equal(uneven, CourseRate.Uneven.Steps(new Seed(1)).Take(1000));
        Assert.Equal(["144", "uneven"], new[] { CourseRate.Of(144f), CourseRate.Uneven }.Select(rate => rate.ToString()));
        Assert.ThrowsAny<ArgumentException>(() => CourseRate.Of(float.NaN));
        Assert.ThrowsAny<ArgumentException>(() => CourseRate.Of(2000f));
    }
}
