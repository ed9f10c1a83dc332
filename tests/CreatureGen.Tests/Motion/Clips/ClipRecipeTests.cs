using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Gltf.Models;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Clips;

public sealed class ClipRecipeTests
{
    private const int HighestRate = 240;

    // Each body with everything that it does: what goes and stands, what leads from one to another, and its acts.
    [Theory]
    [InlineData("feline", RequestedKind.Walking, "Idle Walk Trot Canter TurnLeft TurnRight StrafeLeft StrafeRight Reverse LookAround Start Stop Jump Fall Land", "Bite Claw Kick TailSweep Eat Drink Sniff Shake Scratch Groom Call Threaten Submit Dance Flinch Sit Lie Sleep Die")]
    [InlineData("frog", RequestedKind.Walking, "Idle Crawl Leap TurnLeft TurnRight StrafeLeft StrafeRight Reverse LookAround Start Stop Jump Fall Land", "Bite Claw TailSweep Eat Drink Sniff Shake Groom Call Threaten Submit Dance Flinch Lie Sleep Die")]
    [InlineData("cobra", RequestedKind.Walking, "Idle Slither Sidewind Rectilinear TurnLeft TurnRight LookAround Start Stop", "Bite Eat Sniff Call Threaten Submit Dance Flinch Sleep Die")]
    [InlineData("raptor", RequestedKind.Flying, "Idle Walk Run Fly Hover TakeOff Land TurnLeft TurnRight StrafeLeft StrafeRight Reverse LookAround BankLeft BankRight Glide Start Stop Jump Dart", "Bite Kick TailSweep Eat Drink Sniff Shake Groom Call Threaten Submit Dance Flinch Lie Sleep Die")]
    [InlineData("bee", RequestedKind.Flying, "Idle Wave Tripod Fly Hover TakeOff Land TurnLeft TurnRight StrafeLeft StrafeRight Reverse LookAround BankLeft BankRight Start Stop Jump Dart", "Bite Claw Sting TailSweep Eat Drink Sniff Shake Groom Threaten Submit Dance Flinch Lie Sleep Die")]
    [InlineData("fish", RequestedKind.Swimming, "Idle Swim TurnLeft TurnRight LookAround Start Stop Dart", "Bite Eat Sniff Call Threaten Submit Dance Flinch Sleep Die")]
    [InlineData("turtle", RequestedKind.Swimming, "Idle Swim TurnLeft TurnRight LookAround Start Stop Dart", "Bite Eat Sniff Call Threaten Submit Dance Flinch Sleep Die")]
    public void All_that_games_ask_for_is_baked(string body, RequestedKind kind, string ways, string acts)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        string[] all = [.. ClipBaker.RecipesOf(profile).Select(recipe => recipe.Name)];
        Assert.Equal($"{ways} {acts}", string.Join(' ', all));
        Assert.Equal(all.Length, all.Distinct(StringComparer.Ordinal).Count());
        Assert.Empty(all.Except(ClipBaker.Names));
        Assert.Equal(profile.Acts.Possible.Select(ability => ability.Act.Name), acts.Split(' '));
        Assert.Empty(Movement.Of(profile).Select(movement => movement.Name).Except(all));
    }

    [Theory]
    [InlineData("feline", RequestedKind.Walking, Explicit = true)]
    [InlineData("raptor", RequestedKind.Flying, Explicit = true)]
    [InlineData("bee", RequestedKind.Flying, Explicit = true)]
    [InlineData("fish", RequestedKind.Swimming)]
    [InlineData("cobra", RequestedKind.Walking, Explicit = true)]
    public void Every_clip_is_the_same_twice_closes_if_it_loops_and_nothing_jumps(string body, RequestedKind kind)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        foreach (ClipRecipe recipe in ClipBaker.RecipesOf(profile))
        {
            Clip clip = recipe.Bake();
            Clip again = recipe.Bake();
            Assert.Equal(recipe.Name, clip.Name);
            Assert.Equal((again.Frames, again.Speed, again.End), (clip.Frames, clip.Speed, clip.End));
            if (clip.End == ClipEnd.Loops)
            {
                Assert.True(clip.RotationsAt(0).SequenceEqual(clip.RotationsAt(clip.Frames - 1)) && clip.PositionsAt(0).SequenceEqual(clip.PositionsAt(clip.Frames - 1)), clip.Name);
            }

            for (int frame = 0; frame < clip.Frames; frame++)
            {
                Assert.True(clip.RotationsAt(frame).SequenceEqual(again.RotationsAt(frame)), clip.Name);
                for (int joint = 0; frame > 0 && joint < clip.Joints; joint++)
                {
                    float dot = Math.Abs(Quaternion.Dot(clip.RotationsAt(frame)[joint], clip.RotationsAt(frame - 1)[joint]));
                    bool blinks = profile.Subject.Skeleton.Joints[joint].Role == JointRole.Lid;
                    Assert.True(dot > (blinks ? 0.6f : 0.9689f) || (clip.Rate == HighestRate && dot > 0.9f), $"{clip.Name} at {clip.Rate} Hz, {2 * MathF.Acos(dot)} radians, frame {frame}, {profile.Subject.Skeleton.Joints[joint].Name}");
                }
            }
        }
    }

    [Fact]
    public void A_walker_starts_as_it_stands_and_comes_to_where_its_walk_begins()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        Clip Baked(string name) => ClipBaker.RecipesOf(profile).First(recipe => recipe.Name == name).Bake();
        Clip start = Baked("Start");
        Clip stop = Baked("Stop");
        Clip walk = Baked("Walk");
        Assert.True(FarthestApart(profile, start, start.Frames - 1, walk, 0) < 0.12f * profile.LegLength, $"{FarthestApart(profile, start, start.Frames - 1, walk, 0) / profile.LegLength}");
        Assert.True(FarthestApart(profile, stop, 0, walk, 0) < 0.12f * profile.LegLength, $"{FarthestApart(profile, stop, 0, walk, 0) / profile.LegLength}");
        Assert.True(FarthestApart(profile, start, 0, stop, stop.Frames - 1) < 0.12f * profile.LegLength, $"{FarthestApart(profile, start, 0, stop, stop.Frames - 1) / profile.LegLength}");
    }

    [Fact]
    public void Paths_go_where_their_names_say()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        ClipPlace End(string name)
        {
            Clip clip = ClipBaker.RecipesOf(profile).First(recipe => recipe.Name == name).Bake();
            Assert.Equal(clip.Frames, clip.Path.Count);
            return clip.Path[^1];
        }

        Assert.True(End("TurnLeft").Heading > 0.2f);
        Assert.True(End("TurnRight").Heading < -0.2f);
        Assert.True(End("StrafeLeft").Position.X > 0.05f * profile.LegLength);
        Assert.True(End("StrafeRight").Position.X < -0.05f * profile.LegLength);
        Assert.True(End("Reverse").Position.Z < -0.2f * profile.LegLength);
        Assert.True(End("Walk").Position.Z > 0.5f * profile.LegLength);
        Assert.True(End("Jump").Position.Z > 0.5f * profile.LegLength);
    }

    [Fact]
    public void A_flier_banks_into_its_turns()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("raptor", RequestedKind.Flying));
        int body = profile.Subject.Skeleton.IndexOf("Body");
        float LeftWingUp(string name)
        {
            Clip clip = ClipBaker.RecipesOf(profile).First(recipe => recipe.Name == name).Bake();
            Assert.Equal(Math.Sign(clip.Path[^1].Heading), name == "BankLeft" ? 1 : -1);
            return Enumerable.Range(0, clip.Frames).Average(frame => Rotation.Rotate(clip.RotationsAt(frame)[body], Vector3.UnitX).Y);
        }

        float left = LeftWingUp("BankLeft"), right = LeftWingUp("BankRight");
        Assert.True(left < -0.1f && right > 0.1f, $"{left} {right}");
    }

    [Fact]
    public void A_jump_leaves_the_ground_and_comes_back()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        Clip jump = ClipBaker.RecipesOf(profile).First(recipe => recipe.Name == "Jump").Bake();
        int body = profile.Subject.Skeleton.IndexOf("Body");
        float highest = Enumerable.Range(0, jump.Frames).Max(frame => jump.PositionsAt(frame)[body].Y);
        Assert.True(highest > jump.PositionsAt(0)[body].Y + (0.2f * profile.LegLength));
        Assert.Equal(jump.PositionsAt(0)[body].Y, jump.PositionsAt(jump.Frames - 1)[body].Y, 0.05f * profile.LegLength);
    }

    [Fact]
    public void With_root_motion_the_root_joint_travels_in_the_file_and_a_player_takes_it_up()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        Clip walk = ClipBaker.Bake(creature).First(clip => clip.Name == "Walk");
        SkinnedModel model = Written(creature, GltfOptions.Default with { Clips = [walk], RootMotion = RootMotionChoice.Travels });
        KeyedClip read = model.Clips[0];
        Assert.Equal((ClipEnd.Loops, 0f), (read.End, read.Speed));
        var player = new ClipPlayer(model.Skeleton, read, model.Skeleton.Joints[0].Name);
        var pose = new Pose(new Quaternion[model.Skeleton.Count], new Vector3[model.Skeleton.Count]);
        float way = 0f;
        for (int i = 0; i < 200; i++)
        {
            player.Update(walk.Duration / 50f, pose);
            way += player.Root.Shift.Z;
        }

        Assert.Equal(4f * walk.Path[^1].Position.Z, way, 1e-3f);
        Assert.Equal(0f, pose.Positions[0].Z, 1e-4f);
    }

    [Fact]
    public void Engines_find_loops_and_events_where_they_look()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        Clip[] clips = [.. ClipBaker.RecipesOf(new MotionProfile(creature)).Where(recipe => recipe.Name is "Walk" or "Jump").Select(recipe => recipe.Bake())];
        Assert.Equal(["Walk-loop", "Jump"], Written(creature, GltfOptions.Default with { Clips = clips, Engine = TargetEngine.Godot }).Clips.Select(clip => clip.Name));
        Assert.Equal(["Walk", "Jump"], Written(creature, GltfOptions.Default with { Clips = clips, Engine = TargetEngine.Unity }).Clips.Select(clip => clip.Name));
        foreach (TargetEngine engine in Enum.GetValues<TargetEngine>())
        {
            var stream = new MemoryStream();
            GlbWriter.Write(creature, GltfOptions.Default with { Clips = clips, Engine = engine }, stream);
            string json = System.Text.Encoding.UTF8.GetString(stream.ToArray().AsSpan(20, 200_000).ToArray());
            Assert.Equal(engine != TargetEngine.Generic, json.Contains("\"clips\":[{\"name\":\"Walk\",\"loop\":true", StringComparison.Ordinal));
        }
    }

    [Fact]
    public void A_file_of_fewer_keys_is_smaller_and_plays_the_same_within_a_tenth_of_a_millimetre()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        IReadOnlyList<Clip> clips = ClipBaker.Bake(creature);
        SkinnedModel all = Written(creature, GltfOptions.Default with { Clips = clips, ClipPrecision = null });
        SkinnedModel few = Written(creature, GltfOptions.Default with { Clips = clips });
        for (int i = 0; i < clips.Count; i++)
        {
            // A paw goes so far in the rounding of a moment in single precision.
            float rounded = ClipError.Between(clips[i], all.Clips[i], creature.Skeleton, clips[i].Frames).Worst;
            Assert.True(rounded < 2e-6f, $"{clips[i].Name}: {rounded} m");
            float apart = ClipError.Between(clips[i], few.Clips[i], creature.Skeleton, clips[i].Frames).P99;
            Assert.True(apart <= 1e-4f, $"{clips[i].Name}: {apart} m");
        }

        Assert.True(Bytes(creature, GltfOptions.Default with { Clips = clips }) < Bytes(creature, GltfOptions.Default with { Clips = clips, ClipPrecision = null }));
    }

    private static int Bytes(Creature creature, GltfOptions options)
    {
        var stream = new MemoryStream();
        GlbWriter.Write(creature, options, stream);
        return (int)stream.Length;
    }

    private static SkinnedModel Written(Creature creature, GltfOptions options)
    {
        var stream = new MemoryStream();
        GlbWriter.Write(creature, options, stream);
        stream.Position = 0;
        return ModelReader.Read(stream).Model!;
    }

    private static float FarthestApart(MotionProfile profile, Clip a, int frameOfA, Clip b, int frameOfB)
    {
        Skeleton skeleton = profile.Subject.Skeleton;
        Vector3[] Places(Clip clip, int frame)
        {
            var pose = new Pose(clip.RotationsAt(frame).ToArray(), clip.PositionsAt(frame).ToArray());
            ForwardKinematics.LocalToModel(skeleton, pose, pose);
            return pose.Positions.ToArray();
        }

        return Places(a, frameOfA).Zip(Places(b, frameOfB), Vector3.Distance).Where((_, joint) => skeleton.Joints[joint].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Spine or JointRole.Chest).Max();
    }
}
