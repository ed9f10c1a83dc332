using System;
using System.IO;
using System.Linq;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sounds;
using Xunit;

namespace CreatureGen.Tests.Sounds;

public sealed class EventSoundTests
{
    private static readonly SoundSettings cat = new(5f, 7);

    [Theory]
    [InlineData("footstep")]
    [InlineData("land")]
    [InlineData("flap")]
    [InlineData("whoosh")]
    [InlineData("bite")]
    [InlineData("splash")]
    [InlineData("call")]
    [InlineData("stuff")]
    public void An_event_sounds_from_its_time_on_and_dies_away(string name)
    {
        float[] sound = EventSounds.Render([new ClipEvent(1f, name, "", 1f)], 4f, cat);
        Assert.Equal(5 * 44_100, sound.Length);
        Assert.All(sound.Take(44_100), sample => Assert.Equal(0f, sample));
        Assert.True(Power(sound, 1f, 1.4f) > 1e-6f);
        Assert.True(Power(sound, 4.5f, 5f) < 1e-4f * Power(sound, 1f, 1.4f));
        Assert.True(sound.Max(Math.Abs) <= 1f);
    }

    [Fact]
    public void Feet_that_leave_the_ground_are_silent() => Assert.All(EventSounds.Render([new ClipEvent(0f, "liftoff", "", 1f)], 1f, cat), sample => Assert.Equal(0f, sample));

    [Fact]
    public void Heavy_creatures_step_lower_and_louder()
    {
        ClipEvent[] step = [new ClipEvent(0f, "footstep", "", 1f)];
        float[] mouse = EventSounds.Render(step, 1f, new SoundSettings(0.05f, 1));
        float[] bull = EventSounds.Render(step, 1f, new SoundSettings(800f, 1));
        Assert.True(Power(bull, 0f, 0.5f) > 4f * Power(mouse, 0f, 0.5f));
        Assert.True(Crossings(bull) < 0.5 * Crossings(mouse));
    }

    [Fact]
    public void Hard_steps_are_louder_than_soft_ones_and_no_two_are_alike()
    {
        float[] sound = EventSounds.Render([new ClipEvent(0f, "footstep", "", 0.3f), new ClipEvent(1f, "footstep", "", 2f), new ClipEvent(2f, "footstep", "", 2f)], 3f, cat);
        Assert.True(Power(sound, 1f, 2f) > 3f * Power(sound, 0f, 1f));
        Assert.NotEqual(sound.AsSpan(44_100, 2000).ToArray(), sound.AsSpan(88_200, 2000).ToArray());
    }

    [Fact]
    public void The_same_events_give_the_same_file_with_a_header_that_players_read()
    {
        byte[] File(ulong seed)
        {
            var stream = new MemoryStream();
            WavWriter.Write(EventSounds.Render([new ClipEvent(0.2f, "call", "", 1f)], 0.5f, new SoundSettings(30f, seed, 22_050)), 22_050, stream);
            return stream.ToArray();
        }

        byte[] file = File(1);
        Assert.Equal(file, File(1));
        Assert.NotEqual(file, File(2));
        Assert.Equal("RIFF"u8.ToArray(), file[..4]);
        Assert.Equal("WAVEfmt "u8.ToArray(), file[8..16]);
        Assert.Equal(file.Length - 8, BitConverter.ToInt32(file, 4));
        Assert.Equal((1, 1, 22_050, 44_100, 2, 16), (BitConverter.ToInt16(file, 20), BitConverter.ToInt16(file, 22), BitConverter.ToInt32(file, 24), BitConverter.ToInt32(file, 28), BitConverter.ToInt16(file, 32), BitConverter.ToInt16(file, 34)));
        Assert.Equal(file.Length - 44, BitConverter.ToInt32(file, 40));
    }

    [Fact]
    public void What_cannot_be_heard_is_refused()
    {
        Assert.ThrowsAny<ArgumentException>(() => new SoundSettings(float.NaN, 1));
        Assert.ThrowsAny<ArgumentException>(() => new SoundSettings(1f, 1, 100));
        Assert.ThrowsAny<ArgumentException>(() => EventSounds.Render([new ClipEvent(9f, "bite", "", 1f)], 1f, cat));
        Assert.ThrowsAny<ArgumentException>(() => EventSounds.Render([], float.PositiveInfinity, cat));
        Assert.ThrowsAny<ArgumentException>(() => EventSounds.Render([], 1f, default));
        Assert.ThrowsAny<ArgumentException>(() => WavWriter.Write([float.NaN], 44_100, new MemoryStream()));
    }

    private static float Power(float[] sound, float from, float to)
    {
        ReadOnlySpan<float> part = sound.AsSpan((int)(44_100 * from), Math.Min((int)(44_100 * (to - from)), sound.Length - (int)(44_100 * from)));
        float sum = 0f;
        foreach (float sample in part)
        {
            sum += sample * sample;
        }

        return sum / part.Length;
    }

    private static int Crossings(float[] sound) => Enumerable.Range(1, 4000).Count(i => sound[i] * sound[i - 1] < 0f);
}
