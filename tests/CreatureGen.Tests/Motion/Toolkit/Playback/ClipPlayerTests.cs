using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Playback;

public sealed class ClipPlayerTests
{
    private readonly Quaternion[] rotations = new Quaternion[2];
    private readonly Vector3[] positions = new Vector3[2];

    private Pose Pose => new(rotations, positions);

    [Theory]
    [InlineData(ClipChange.CrossFaded)]
    [InlineData(ClipChange.Inertialised)]
    public void A_change_jumps_neither_in_place_nor_in_speed_and_ends_at_the_new_clip(ClipChange change)
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Old", 4f, 0f, 1f));
        float[] angles = new float[200];
        for (int i = 0; i < angles.Length; i++)
        {
            if (i == 60)
            {
                player.Play(Clips.Swing("New", 4f, -1f, -0.5f), 0.4f, change);
            }

            player.Update(0.01f, Pose);
            angles[i] = Clips.ArmAngle(rotations);
        }

        for (int i = 2; i < angles.Length; i++)
        {
            // Half a radian a second before and a quarter after; between them 1.3 radians in 0.4 seconds.
            Assert.InRange(Math.Abs(angles[i] - angles[i - 1]), 0f, 0.08f);
            Assert.InRange(Math.Abs(angles[i] - (2 * angles[i - 1]) + angles[i - 2]), 0f, 0.008f);
        }

        Assert.Equal(-1f + (0.25f * 1.4f), angles[^1], 2);
    }

    [Fact]
    public void A_change_during_a_change_does_not_jump()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Old", 4f, 0f, 1f));
        float before = 0f;
        for (int i = 0; i < 120; i++)
        {
            if (i is 20 or 30 or 37 or 60)
            {
                player.Play(Clips.Swing("New", 1f + (i / 10f), i / 60f, 0.5f), 0.4f, i == 37 ? ClipChange.Inertialised : ClipChange.CrossFaded);
            }

            player.Update(0.01f, Pose);
            float angle = Clips.ArmAngle(rotations);
            Assert.True(i == 0 || Math.Abs(angle - before) < 0.05f, $"frame {i}: {before} to {angle}");
            before = angle;
        }
    }

    [Fact]
    public void Seeking_playing_on_and_backwards_show_what_the_clip_has_there()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Walk", 2f, 0f, 1f)) { Speed = 2f };
        player.Update(0.25f, Pose);
        Assert.Equal(0.5f, Clips.ArmAngle(rotations), 4);
        player.Seek(1.75f);
        player.Update(0f, Pose);
        Assert.Equal(0.25f, Clips.ArmAngle(rotations), 4);
        player.Speed = -1f;
        player.Update(0.5f, Pose);
        Assert.Equal(0.75f, Clips.ArmAngle(rotations), 4);
        Assert.Equal(1.25f, player.Time, 4);
    }

    [Fact]
    public void A_layer_covers_the_joints_of_its_mask_as_far_as_its_weight_goes()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Still", 1f, 0f, 0f));
        ClipLayer layer = player.AddLayer(Clips.Swing("Up", 1f, 1f, 1f), LayerKind.Covers, [1f, 0.5f]);
        layer.Weight = 0.5f;
        player.Update(0.1f, Pose);
        Assert.Equal(0.25f, Clips.ArmAngle(rotations), 2);
        player.Remove(layer);
        player.Update(0.1f, Pose);
        Assert.Equal(0f, Clips.ArmAngle(rotations), 4);
    }

    [Fact]
    public void A_layer_adds_what_it_differs_by_from_its_beginning()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Half", 1f, 0.5f, 0.5f));
        ClipLayer layer = player.AddLayer(Clips.Swing("Breath", 2f, 0.3f, 0.5f), LayerKind.Adds);
        player.Update(0f, Pose);
        Assert.Equal(0.5f, Clips.ArmAngle(rotations), 4);
        player.Update(1f, Pose);
        Assert.Equal(0.7f, Clips.ArmAngle(rotations), 4);
        layer.Weight = 0f;
        player.Update(1f, Pose);
        Assert.Equal(0.5f, Clips.ArmAngle(rotations), 4);
    }

    [Theory]
    [InlineData(0.013f, 0f)]
    [InlineData(0.013f, 1.2f)]
    [InlineData(0.7f, 1.2f)]
    [InlineData(3.1f, -0.9f)]
    public void The_root_travels_as_the_clip_does_through_all_rounds_and_the_pose_stays_in_place(float step, float turn)
    {
        const float Duration = 1f;
        var player = new ClipPlayer(Clips.Skeleton, Clips.Travel(Duration, 2f, turn), "Root");
        RootPlace place = RootPlace.Identity;
        double time = 0;
        while (time < 4)
        {
            player.Update(step, Pose);
            place = player.Root.From(place);
            time += step;
            Assert.InRange(new Vector2(positions[0].X, positions[0].Z).Length(), 0f, 1e-4f);
            Assert.Equal(0.5f, positions[0].Y, 4);
            Assert.Equal(1f, Math.Abs(rotations[0].W), 3);
        }

        // An arc of 2 metres a second and so many radians a second.
        float angle = (float)(time * turn);
        Vector3 expected = turn == 0f ? new Vector3(0f, 0f, (float)(2 * time)) : new Vector3(2f / turn * (1f - MathF.Cos(angle)), 0f, 2f / turn * MathF.Sin(angle));
        Assert.True(Vector3.Distance(expected, place.Position) < 0.02f, $"{place.Position}; expected {expected}");
    }

    [Fact]
    public void A_clip_in_place_travels_at_its_speed_and_back_with_a_speed_below_nought()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Walk", 1f, 0f, 1f, speed: 1.5f));
        player.Update(0.2f, Pose);
        Assert.Equal(0.3f, player.Root.Shift.Z, 5);
        player.Speed = -2f;
        player.Update(0.2f, Pose);
        Assert.Equal(-0.6f, player.Root.Shift.Z, 5);
    }

    [Fact]
    public void Events_of_the_clip_and_of_layers_that_show_are_told_once()
    {
        var player = new ClipPlayer(Clips.Skeleton, Clips.Swing("Walk", 1f, 0f, 1f, events: new ClipEvent(0.5f, "step", "", 1f)));
        ClipLayer layer = player.AddLayer(Clips.Swing("Wave", 0.5f, 0f, 1f, events: new ClipEvent(0.1f, "wave", "", 1f)), LayerKind.Adds);
        int steps = 0, waves = 0;
        for (int i = 0; i < 300; i++)
        {
            layer.Weight = i < 150 ? 1f : 0f;
            player.Update(0.01f, Pose);
            steps += player.Events.Count(e => e.Name == "step");
            waves += player.Events.Count(e => e.Name == "wave");
        }

        Assert.Equal(3, steps);
        Assert.Equal(3, waves);
    }

    [Fact]
    public void Playing_allocates_nothing()
    {
        var walk = Clips.Swing("Walk", 1f, 0f, 1f, speed: 1f, events: new ClipEvent(0.5f, "step", "", 1f));
        var blend = new PhaseBlend("Go", [walk, Clips.Swing("Run", 0.6f, 0f, 1f, speed: 3f)]);
        var player = new ClipPlayer(Clips.Skeleton, walk, "Root");
        player.AddLayer(Clips.Swing("Breath", 2f, 0.3f, 0.5f), LayerKind.Adds);
        Run(60);
        Assert.Equal(0, MovingPose.Allocated(() => Run(600), 1));

        void Run(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                if (i % 50 == 0)
                {
                    player.PlayInPhase(i % 100 == 0 ? walk : blend, 0.3f, i % 150 == 0 ? ClipChange.Inertialised : ClipChange.CrossFaded);
                }

                blend.SetSpeed(i / 200f);
                player.Update(1f / 60f, Pose);
            }
        }
    }

    [Fact]
    public void What_does_not_fit_the_skeleton_is_refused()
    {
        KeyedClip clip = Clips.Swing("Walk", 1f, 0f, 1f);
        Assert.Contains("Tail", Assert.Throws<ArgumentException>(() => new ClipPlayer(Clips.Skeleton, clip, "Tail")).Message, StringComparison.Ordinal);
        var player = new ClipPlayer(Clips.Skeleton, clip);
        Assert.Throws<ArgumentException>(() => player.AddLayer(clip, LayerKind.Covers, [1f]));
        Assert.Throws<ArgumentOutOfRangeException>(() => player.AddLayer(clip, LayerKind.Covers, [1f, 2f]));
        Assert.Throws<ArgumentNullException>(() => player.Play(null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => player.Update(-1f, Pose));
        Assert.Throws<ArgumentException>(() => player.Update(1f, new Pose(new Quaternion[1], new Vector3[1])));
        player.Speed = float.NaN;
        Assert.Throws<ArgumentException>(() => player.Update(1f, Pose));
    }
}
