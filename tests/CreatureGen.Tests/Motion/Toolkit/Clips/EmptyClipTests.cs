using System;
using System.Numerics;
using CreatureGen.Events;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Tests.Motion.Toolkit.Playback;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Clips;

/// <summary>What has no frame, no track, no key or no time is no clip; each says so in one sentence that names it and what was expected.</summary>
public sealed class EmptyClipTests
{
    private static readonly KeyTrack still = KeyTrack.OfRotations([0f], [Quaternion.Identity], KeyInterpolation.Step);
    private static readonly KeyTrack placed = KeyTrack.OfPositions([0f], [Vector3.Zero], KeyInterpolation.Step);

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void A_recording_of_fewer_than_two_frames_is_refused_with_what_it_has(int frames)
    {
        Refused(
            $"clip Walk has {frames * 2} rotations and {frames * 2} positions of 2 joints; expected one of each for every joint of at least two frames",
            () => new Clip("Walk", ClipEnd.Stays, Clip.UsualRate, 0f, 2, new Quaternion[frames * 2], new Vector3[frames * 2]));
    }

    [Fact]
    public void A_recording_without_joints_is_refused_with_what_it_has() =>
        Refused("clip Walk has 0 rotations and 0 positions of 0 joints; expected one of each for every joint of at least two frames", () => new Clip("Walk", ClipEnd.Stays, Clip.UsualRate, 0f, 0, [], []));

    [Fact]
    public void A_clip_without_tracks_is_refused_with_what_it_has()
    {
        Refused("clip Walk has 0 tracks of rotations and 0 of positions; expected one of each per joint", () => new KeyedClip("Walk", ClipEnd.Stays, 1f, 0f, [], [], []));
        Refused("clip Walk has 1 tracks of rotations and 0 of positions; expected one of each per joint", () => new KeyedClip("Walk", ClipEnd.Stays, 1f, 0f, [still], [], []));
    }

    [Theory]
    [InlineData(0f, "0")]
    [InlineData(-1f, "-1")]
    [InlineData(float.NaN, "NaN")]
    public void A_clip_that_lasts_no_time_is_refused_with_its_time(float duration, string told) =>
        Refused($"clip Walk lasts {told} s at 0 m/s; expected a time above 0 and a finite speed", () => new KeyedClip("Walk", ClipEnd.Stays, duration, 0f, [still], [placed], []));

    [Fact]
    public void A_track_without_keys_is_refused() =>
        Refused("0 times and 0 values; expected 1 for each time, and one time at least", () => KeyTrack.OfRotations([], [], KeyInterpolation.Linear));

    [Fact]
    public void A_blend_of_no_clips_is_refused() =>
        Refused("blend Go has no clips; expected one at least", () => new PhaseBlend("Go", []));

    [Fact]
    public void A_clip_of_no_joints_of_a_skeleton_is_refused_by_the_rule_that_looks_into_it() =>
        Refused("clip Walk has 1 joints; expected the 2 of the skeleton", () => AngularEventDetector.Find(new KeyedClip("Walk", ClipEnd.Stays, 1f, 0f, [still], [placed], []), Playback.Clips.Skeleton, new AngularRule("turn") { Joints = ["Arm"] }));

    private static void Refused(string message, Func<object> make)
    {
        ArgumentException refusal = Assert.ThrowsAny<ArgumentException>(make);
        Assert.StartsWith(message, refusal.Message, StringComparison.Ordinal);
    }
}
