using System;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Playback;

public sealed class PhaseBlendTests
{
    private readonly Quaternion[] rotations = new Quaternion[2];
    private readonly Vector3[] positions = new Vector3[2];

    private Pose Pose => new(rotations, positions);

    [Theory]
    [InlineData(0.25f, 0.75f, 0.1f, 1.75f)]
    [InlineData(0.5f, 0.5f, 0.2f, 1.5f)]
    [InlineData(1f, 0f, 0.4f, 1f)]
    public void A_quarter_and_a_half_of_a_walk_in_a_run_lie_between_them_in_pose_and_cycle(float run, float walk, float angle, float duration)
    {
        var blend = new PhaseBlend("Go", [Clips.Swing("Run", 1f, 0f, 0.8f), Clips.Swing("Walk", 2f, 0f, 0f)]);
        blend.SetWeights([run, walk]);
        Assert.Equal(duration, blend.Duration, 5);
        blend.Sample(duration / 4, Pose);
        Assert.Equal(angle, Clips.ArmAngle(rotations), 2);
    }

    [Fact]
    public void A_cycle_goes_on_from_its_part_when_weights_change_its_length()
    {
        var blend = new PhaseBlend("Go", [Clips.Swing("Run", 1f, 0f, 0.8f), Clips.Swing("Walk", 2f, 0f, 0.8f)]);
        var cursor = new ClipCursor(blend);
        cursor.Advance(0.3f);
        blend.SetWeights([0f, 1f]);
        Assert.Equal(0.3f, cursor.Phase, 5);
        cursor.Advance(0.2f);
        Assert.Equal(0.4f, cursor.Phase, 5);
    }

    [Theory]
    [InlineData(1f)]
    [InlineData(1.7f)]
    [InlineData(3f)]
    [InlineData(4.9f)]
    public void Asked_for_a_speed_it_goes_at_that_speed(float speed)
    {
        var blend = new PhaseBlend("Go", [Clips.Swing("Walk", 1f, 0f, 1f, speed: 1f), Clips.Swing("Trot", 0.7f, 0f, 1f, speed: 3f), Clips.Swing("Run", 0.5f, 0f, 1f, speed: 5f)]);
        blend.SetSpeed(speed);
        Assert.Equal(speed, blend.Speed, 4);
        blend.SetSpeed(9f);
        Assert.Equal(5f, blend.Speed, 4);
        blend.SetSpeed(-1f);
        Assert.Equal(1f, blend.Speed, 4);
    }

    [Fact]
    public void The_events_of_the_heaviest_happen_once_a_cycle()
    {
        var blend = new PhaseBlend("Go", [Clips.Swing("Walk", 2f, 0f, 1f, events: new ClipEvent(1f, "walk", "", 1f)), Clips.Swing("Run", 1f, 0f, 1f, events: new ClipEvent(0.5f, "run", "", 1f))]);
        var cursor = new ClipCursor(blend);
        int told = 0;
        for (int i = 0; i <= 100; i++)
        {
            blend.SetWeights([100 - i, i]);
            told += Clips.Names(cursor.Advance(blend.Duration * 0.1f)).Count;
        }

        Assert.Equal(10, told);
    }

    [Fact]
    public void Clips_that_do_not_go_together_are_refused()
    {
        Assert.Throws<ArgumentException>(() => new PhaseBlend("Go", []));
        Assert.Throws<ArgumentException>(() => new PhaseBlend("", [Clips.Swing("Run", 1f, 0f, 1f)]));
        Assert.Contains("Loops", Assert.Throws<ArgumentException>(() => new PhaseBlend("Go", [Clips.Swing("Run", 1f, 0f, 1f), Clips.Swing("Jump", 1f, 0f, 1f, ClipEnd.Stays)])).Message, StringComparison.Ordinal);
        var blend = new PhaseBlend("Go", [Clips.Swing("Run", 1f, 0f, 1f)]);
        Assert.Throws<ArgumentException>(() => blend.SetWeights([0f]));
        Assert.Throws<ArgumentException>(() => blend.SetWeights([1f, 1f]));
        Assert.Throws<ArgumentOutOfRangeException>(() => blend.SetWeights([-1f]));
        Assert.Throws<ArgumentException>(() => blend.SetSpeed(float.NaN));
    }
}
