using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Clips;

public sealed class ClipBakerTests
{
    public static TheoryData<string, RequestedKind, string> Creatures => new()
    {
        { "feline", RequestedKind.Walking, "Walk" },
        { "bison", RequestedKind.Walking, "Walk" },
        { "cobra", RequestedKind.Walking, "Slither" },
        { "raptor", RequestedKind.Flying, "Fly" },
        { "fish", RequestedKind.Swimming, "Swim" },
    };

    [Theory]
    [MemberData(nameof(Creatures))]
    public void A_creature_idles_and_does_what_its_build_is_for(string body, RequestedKind kind, string name)
    {
        IReadOnlyList<Clip> clips = Bake(body, kind);
        Assert.Equal("Idle", clips[0].Name);
        Assert.Equal(0f, clips[0].Speed, 3);
        Clip moving = Assert.Single(clips, clip => clip.Name == name);
        Assert.True(moving.Speed > 0.05f);
        Assert.Equal(clips.Count, clips.Select(clip => clip.Name).Distinct(StringComparer.Ordinal).Count());
    }

    [Theory]
    [MemberData(nameof(Creatures))]
    public void Every_clip_closes_and_nothing_jumps_on_the_way(string body, RequestedKind kind, string name)
    {
        _ = name;
        Creature creature = SpeciesSubject.Of(body, kind);
        bool IsLid(int joint) => creature.Skeleton.Joints[joint].Role == JointRole.Lid;
        foreach (Clip clip in ClipBaker.Bake(creature))
        {
            bool once = clip.Name is "TakeOff" or "Land" or "CStart";
            Assert.Equal(once ? ClipEnd.Stays : ClipEnd.Loops, clip.End);
            Assert.True(once || clip.RotationsAt(0).SequenceEqual(clip.RotationsAt(clip.Frames - 1)));
            Assert.True(once || clip.PositionsAt(0).SequenceEqual(clip.PositionsAt(clip.Frames - 1)));
            for (int frame = 1; frame < clip.Frames; frame++)
            {
                for (int joint = 0; joint < clip.Joints; joint++)
                {
                    float dot = Math.Abs(Quaternion.Dot(clip.RotationsAt(frame)[joint], clip.RotationsAt(frame - 1)[joint]));
                    Assert.True(dot > (IsLid(joint) ? 0.6f : 0.968f), $"{clip.Name}, frame {frame}, joint {joint}");
                }
            }
        }
    }

    [Fact]
    public void A_flier_takes_off_from_where_it_stands_and_lands_on_its_feet()
    {
        Creature creature = SpeciesSubject.Of("raptor", RequestedKind.Flying);
        var profile = new MotionProfile(creature);
        IReadOnlyList<Clip> clips = ClipBaker.Bake(creature);
        Clip idle = clips.Single(clip => clip.Name == "Idle");
        Clip up = clips.Single(clip => clip.Name == "TakeOff");
        Clip down = clips.Single(clip => clip.Name == "Land");
        int body = creature.Skeleton.IndexOf("Body");
        float stands = idle.PositionsAt(0)[body].Y;
        Assert.Equal(stands, up.PositionsAt(0)[body].Y, 0.05f * profile.LegLength);
        Assert.True(up.PositionsAt(up.Frames - 1)[body].Y > stands + (2.5f * profile.LegLength));
        Assert.True(down.PositionsAt(0)[body].Y > stands + (2f * profile.LegLength));
        Assert.Equal(stands, down.PositionsAt(down.Frames - 1)[body].Y, 0.05f * profile.LegLength);
    }

    [Fact]
    public void Quick_wings_get_more_frames_and_keep_their_time()
    {
        IReadOnlyList<Clip> bird = Bake("raptor", RequestedKind.Flying);
        Assert.True(bird.Single(clip => clip.Name == "Hover").Rate > Clip.UsualRate);
        Assert.All(Bake("rhino", RequestedKind.Walking).Where(clip => clip.Name is "Idle" or "Walk"), clip => Assert.Equal(Clip.UsualRate, clip.Rate));
        Clip fly = bird.Single(clip => clip.Name == "Fly");
        Assert.Equal((fly.Frames - 1) / (float)fly.Rate, fly.Duration);
    }

    [Fact]
    public void The_same_creature_gives_the_same_clips()
    {
        IReadOnlyList<Clip> first = Bake("feline", RequestedKind.Walking);
        IReadOnlyList<Clip> second = Bake("feline", RequestedKind.Walking);
        Assert.Equal(first.Select(clip => (clip.Name, clip.Frames, clip.Speed)), second.Select(clip => (clip.Name, clip.Frames, clip.Speed)));
        for (int i = 0; i < first.Count; i++)
        {
            for (int frame = 0; frame < first[i].Frames; frame++)
            {
                Assert.True(first[i].RotationsAt(frame).SequenceEqual(second[i].RotationsAt(frame)));
                Assert.True(first[i].PositionsAt(frame).SequenceEqual(second[i].PositionsAt(frame)));
            }
        }
    }

    [Fact]
    public void The_root_stays_where_it_is()
    {
        foreach (Clip clip in Bake("feline", RequestedKind.Walking))
        {
            for (int frame = 0; frame < clip.Frames; frame++)
            {
                Assert.Equal(clip.PositionsAt(0)[0], clip.PositionsAt(frame)[0]);
                Assert.Equal(clip.RotationsAt(0)[0], clip.RotationsAt(frame)[0]);
            }
        }
    }

    [Theory]
    [InlineData("feline", RequestedKind.Walking, "ant", RequestedKind.Walking, "Tripod")]
    [InlineData("feline", RequestedKind.Walking, "shark", RequestedKind.Swimming, "Swim")]
    [InlineData("shark", RequestedKind.Swimming, "feline", RequestedKind.Walking, "Walk")]
    [InlineData("shark", RequestedKind.Swimming, "feline", RequestedKind.Walking, "Kick")]
    public void What_only_another_creature_does_is_refused_by_name(string body, RequestedKind kind, string otherBody, RequestedKind otherKind, string name)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        Movement foreign = Movement.Of(new MotionProfile(SpeciesSubject.Of(otherBody, otherKind))).First(movement => movement.Name == name);
        Assert.Contains($"\"{name}\"", Assert.Throws<ArgumentException>(() => ClipBaker.Bake(profile, foreign)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_movement_at_another_speed_is_still_the_creatures_own()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        Movement walk = Movement.OfGoing(profile).First(movement => movement.Name == "Walk");
        Assert.True(ClipBaker.Bake(profile, walk.At(0.6f * walk.Input.Speed)).Speed < ClipBaker.Bake(profile, walk).Speed);
    }

    [Fact]
    public void One_movement_alone_is_baked_to_the_bit_as_it_is_among_all()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        var profile = new MotionProfile(creature);
        Same(ClipBaker.Bake(creature)[1], ClipBaker.Bake(profile, Movement.OfGoing(profile)[1]));
        Same(ClipBaker.BakeActs(creature)[0], ClipBaker.Bake(profile, Movement.Of(profile).First(movement => movement.Act != null)));
        Assert.Throws<ArgumentNullException>(() => ClipBaker.Bake(null!, Movement.OfGoing(profile)[0]));
        Assert.Throws<ArgumentNullException>(() => ClipBaker.Bake(profile, null!));

        void Same(Clip expected, Clip actual)
        {
            Assert.Equal(expected.Name, actual.Name);
            Assert.Equal(expected.Frames, actual.Frames);
            var pose = new Pose(new Quaternion[creature.Skeleton.Count], new Vector3[creature.Skeleton.Count]);
            var other = new Pose(new Quaternion[creature.Skeleton.Count], new Vector3[creature.Skeleton.Count]);
            expected.Sample(0.4f * expected.Duration, pose);
            actual.Sample(0.4f * actual.Duration, other);
            Assert.Equal(pose.Rotations.ToArray(), other.Rotations.ToArray());
            Assert.Equal(pose.Positions.ToArray(), other.Positions.ToArray());
        }
    }

    private static IReadOnlyList<Clip> Bake(string body, RequestedKind kind) => ClipBaker.Bake(SpeciesSubject.Of(body, kind));
}
