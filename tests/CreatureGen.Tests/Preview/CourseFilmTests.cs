using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class CourseFilmTests
{
    private static readonly MotionProfile cat = new(SpeciesSubject.Of("feline", RequestedKind.Walking));
    private static readonly FilmOptions small = new() { Width = 64, Height = 48 };

    [Theory]
    [InlineData(CourseGround.Lift)]
    [InlineData(CourseGround.Gap, Explicit = true)]
    [InlineData(CourseGround.Slope, Explicit = true)]
    [InlineData(CourseGround.Pipe)]
    public void A_film_has_twenty_frames_a_second_which_are_the_same_every_time(CourseGround ground)
    {
        var script = new CourseScript("go", [new CourseCommand(0.5f, new MotionInput(1f)), new CourseCommand(0.5f, default)]);
        var film = new CourseFilm(cat, script, ground, small);
        Assert.Equal(21, film.FrameCount);
        Assert.Equal(50, film.MillisecondsPerFrame);
        Picture frame = film.Frame(12);
        Assert.True(frame.Bytes.SequenceEqual(new CourseFilm(cat, script, ground, small).Frame(12).Bytes));
        Assert.False(frame.Bytes.SequenceEqual(film.Frame(0).Bytes));
        Assert.Throws<ArgumentOutOfRangeException>(() => film.Frame(21));
    }

    [Fact]
    public void A_camera_that_turns_along_sees_a_creature_that_turns_from_the_same_side()
    {
        // A quarter of a turn to the left: the front is towards the left, which a camera at the side sees from the back unless it turns along.
        var script = new CourseScript("turn", [new CourseCommand(1.5f, new MotionInput(0f, 1.5f)), new CourseCommand(1f, default)]);
        FilmOptions side = small with { View = View.Side };
        var still = new CourseFilm(cat, script, CourseGround.Flat, side);
        var along = new CourseFilm(cat, script, CourseGround.Flat, side with { Camera = CameraTurn.Along });
        int moment = CourseTake.Rate * 2;
        float seenStill = Extent(still, moment, CameraTurn.Still);
        float seenAlong = Extent(along, moment, CameraTurn.Along);
        Assert.True(seenAlong > 1.5f * seenStill, $"{seenAlong} against {seenStill}");
        Assert.False(still.Frame(40).Bytes.SequenceEqual(along.Frame(40).Bytes));
        Assert.True(along.Frame(40).Bytes.SequenceEqual(new CourseFilm(cat, script, CourseGround.Flat, side with { Camera = CameraTurn.Along }).Frame(40).Bytes));
    }

    [Fact]
    public void Its_strip_shows_the_view_that_is_asked_for()
    {
        var script = new CourseScript("go", [new CourseCommand(0.5f, new MotionInput(1f))]);
        Picture usual = new CourseFilm(cat, script, CourseGround.Flat, small).Strip(TestContext.Current.CancellationToken);
        Assert.True(usual.Bytes.SequenceEqual(new CourseFilm(cat, script, CourseGround.Flat, small with { View = View.ThreeQuarter }).Strip(TestContext.Current.CancellationToken).Bytes));
        Assert.False(usual.Bytes.SequenceEqual(new CourseFilm(cat, script, CourseGround.Flat, small with { View = View.Front }).Strip(TestContext.Current.CancellationToken).Bytes));
    }

    [Fact]
    public void Too_long_scripts_are_refused()
    {
        var script = new CourseScript("long", [new CourseCommand(61f, default)]);
        Assert.Contains("at most 60 seconds", Assert.Throws<ArgumentOutOfRangeException>(() => new CourseFilm(cat, script, CourseGround.Flat, small)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new CourseFilm(cat, script, CourseGround.Flat, small with { Width = 1 }));
    }

    /// <summary>How far a creature extends across a picture from the side, metres.</summary>
    private static float Extent(CourseFilm film, int moment, CameraTurn turning) => BoundingBox.Of(film.Take.SkinAt(moment, film.Take.CameraAt(moment, turning)).Positions).Size.Z;
}
