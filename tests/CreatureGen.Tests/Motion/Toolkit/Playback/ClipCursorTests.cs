using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Playback;

public sealed class ClipCursorTests
{
    private static readonly ClipEvent[] steps = [new(0f, "a", "", 1f), new(0.25f, "b", "", 1f), new(0.6f, "c", "", 1f), new(1f, "d", "", 1f)];

    [Fact]
    public void A_loop_tells_each_event_once_in_the_order_of_passing_and_its_end_is_its_beginning()
    {
        var cursor = new ClipCursor(Clips.Swing("Walk", 1f, 0f, 1f, events: steps));
        Assert.Equal(["d", "a", "b"], Clips.Names(cursor.Advance(0.5f)));
        Assert.Equal(["c"], Clips.Names(cursor.Advance(0.5f)));
        Assert.Equal(["d", "a", "b", "c", "d", "a"], Clips.Names(cursor.Advance(1.1f)));
        Assert.Equal(0.1f, cursor.Time, 5);
    }

    [Fact]
    public void Backwards_the_same_events_come_in_the_other_order()
    {
        var cursor = new ClipCursor(Clips.Swing("Walk", 1f, 0f, 1f, events: steps), 0.5f);
        Assert.Equal(["b", "a", "d", "c"], Clips.Names(cursor.Advance(-1f)));
        Assert.Equal(["b", "a", "d", "c"], Clips.Names(cursor.Advance(-1f)));
    }

    [Fact]
    public void A_clip_that_stays_tells_its_last_moment_when_it_gets_there_and_then_no_more()
    {
        var cursor = new ClipCursor(Clips.Swing("Jump", 1f, 0f, 1f, ClipEnd.Stays, 0f, steps));
        Assert.Equal(["a", "b", "c", "d"], Clips.Names(cursor.Advance(3f)));
        Assert.True(cursor.IsFinished);
        Assert.Empty(Clips.Names(cursor.Advance(1f)));
        Assert.Equal(1f, cursor.Time);
    }

    [Fact]
    public void The_end_of_a_loop_is_its_beginning_and_that_of_a_clip_that_stays_is_its_end()
    {
        var loop = new ClipCursor(Clips.Swing("Walk", 2f, 0f, 1f));
        loop.SeekPhase(1);
        Assert.Equal(0f, loop.Phase);
        var jump = new ClipCursor(Clips.Swing("Jump", 2f, 0f, 1f, ClipEnd.Stays, 0f, steps));
        jump.SeekPhase(1);
        Assert.Equal(1f, jump.Phase);
    }

    /// <summary>Any steps, to and fro, over the same way pass the same events as one step.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Whatever_the_steps_and_however_the_speed_changes_no_event_is_lost_or_told_twice(ulong seed)
    {
        KeyedClip clip = Clips.Swing("Walk", 0.7f, 0f, 1f, events: [new(0f, "a", "", 1f), new(0.31f, "b", "", 1f), new(0.7f, "c", "", 1f)]);
        var random = new RandomStream(seed);
        var cursor = new ClipCursor(clip);
        var told = new List<string>();
        double played = 0;
        for (int i = 0; i < 2000; i++)
        {
            float step = (float)random.Uniform(0, i % 7 == 0 ? 2 : 0.05);
            played += step;
            told.AddRange(Clips.Names(cursor.Advance(step)));
        }

        double rounds = played / 0.7f;
        Assert.InRange(told.Count(n => n == "a"), Math.Floor(rounds), Math.Ceiling(rounds));
        Assert.Equal(told.Count(n => n == "a"), told.Count(n => n == "c"));
        for (int i = 0; i < told.Count; i++)
        {
            Assert.Equal((i % 3) switch { 0 => "c", 1 => "a", _ => "b" }, told[i]);
        }
    }

    [Fact]
    public void To_and_fro_across_an_event_tells_it_each_time()
    {
        var cursor = new ClipCursor(Clips.Swing("Walk", 1f, 0f, 1f, events: steps), 0.2f);
        for (int i = 0; i < 10; i++)
        {
            Assert.Equal(["b"], Clips.Names(cursor.Advance(0.1f)));
            Assert.Equal(["b"], Clips.Names(cursor.Advance(-0.1f)));
        }
    }

    [Fact]
    public void Seeking_tells_nothing()
    {
        var cursor = new ClipCursor(Clips.Swing("Walk", 1f, 0f, 1f, events: steps));
        cursor.Seek(0.9f);
        Assert.Empty(Clips.Names(cursor.Advance(0f)));
        Assert.Empty(Clips.Names(cursor.Advance(0.05f)));
        cursor.Seek(-0.3f);
        Assert.Equal(0.7f, cursor.Time, 5);
    }

    [Fact]
    public void Times_that_are_no_numbers_are_refused()
    {
        var cursor = new ClipCursor(Clips.Swing("Walk", 1f, 0f, 1f));
        Assert.Throws<ArgumentException>(() => cursor.Seek(float.NaN));
        Assert.Throws<ArgumentException>(() => cursor.Advance(float.PositiveInfinity));
        Assert.Throws<ArgumentException>(() => cursor.SeekPhase(1.5));
        Assert.Throws<ArgumentNullException>(() => new ClipCursor(null!));
    }
}
