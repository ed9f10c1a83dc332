using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using CreatureGen.Rigging;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ragdolls;

public sealed class RagdollTests
{
    private const float Frame = 1f / 60f;
    private static readonly RagdollSettings weightless = new(Vector3.Zero, 0f, 0f);

    [Theory]
    [InlineData(5)]
    [InlineData(300, Explicit = true)]
    public void Creatures_of_every_kind_fall_stay_whole_above_ground_and_within_their_limits_and_come_to_rest(int count)
    {
        var complaints = new List<string>();
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed);
            RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
            var state = new RagdollState(rig);
            MovingPose pose = new(creature.Skeleton);
            Vector3 axis = Vec.Normalize(new Vector3(1f, 0.3f, (0.2f * (seed % 7)) - 0.6f));
            var root = new RootPlace(new Vector3(0f, 0.3f * rig.Size, 0f), Rotation.FromAxisAngle(axis, (0.5 * (seed % 5)) - 1));
            Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
            int frames = 0;
            float gap = 0f;
            for (; frames < 900 && !state.IsAsleep; frames++)
            {
                Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
                gap = Math.Max(gap, WidestGap(state));
            }

            Ragdoll.Show(rig, state, root, pose.Local, pose.Model);
            float deepest = creature.Bones.Max(b => b.Radius - Math.Min(Height(b, b.Start), Height(b, b.End)));
            float excess = Enumerable.Range(0, creature.Skeleton.Count).Max(j => Excess(creature.Skeleton, pose, j));
            float furthest = pose.ModelPositions.Max(p => Vec.Length(root.ToWorld(p)));
            if (!state.IsAsleep || !(deepest < 0.03f * rig.Size) || !(gap < 0.02f * rig.Size) || !(excess < 2e-4f) || !(furthest < 5f * rig.Size))
            {
                complaints.Add(FormattableString.Invariant($"seed {seed} {creature.Blueprint.Plan}: asleep {state.IsAsleep}, {deepest / rig.Size:P1} deep, gap {gap / rig.Size:P1}, excess {excess}, {furthest / rig.Size:F1} away"));
            }

            float Height(CapsuleCollider b, Vector3 end) => root.ToWorld(pose.ModelPositions[b.Joint] + Rotation.Rotate(pose.ModelRotations[b.Joint], end)).Y;
        }

        Assert.True(complaints.Count == 0, string.Join("; ", complaints));
    }

    /// <summary>A wing's tip of it shakes where it lies, by joints that pull apart.</summary>
    [Fact]
    public void Who_shakes_where_it_lies_comes_to_rest_and_a_copy_of_it_in_the_same_moment()
    {
        const int Copied = 60;
        Creature creature = KeptCreatures.Of(94);
        var rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        var copy = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(new Vector3(0f, 0.3f * rig.Size, 0f), Rotation.FromAxisAngle(Vec.Normalize(new Vector3(1f, 0.3f, 0f)), 1));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        int frames = 0;
        for (; frames < 900 && !state.IsAsleep; frames++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
            if (frames == Copied)
            {
                copy.CopyFrom(state);
            }
            else if (frames > Copied)
            {
                Ragdoll.Advance(rig, copy, RagdollSettings.Default, FlatGround.Level, Frame);
            }
        }

        Assert.InRange(frames, Copied + 2, 899);
        Assert.True(copy.IsAsleep);
        Assert.Equal(state.Positions, copy.Positions);
    }

    [Fact]
    public void A_single_part_falls_by_half_g_t_squared_and_lies_on_its_radius()
    {
        (RagdollRig rig, RagdollState state, MovingPose pose) = Rope(0);
        var root = new RootPlace(new Vector3(0f, 10f, 0f), Rotation.FromAxisAngle(Vector3.UnitX, 0.8));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        float start = state.Anchor.Y + state.Positions[0].Y;
        for (int i = 0; i < 60; i++)
        {
            Ragdoll.Advance(rig, state, new RagdollSettings(new Vector3(0f, -9.81f, 0f), 0f, 0f), FlatGround.Level, Frame);
        }

        Assert.Equal(start - (0.5f * 9.81f), state.Anchor.Y + state.Positions[0].Y, 0.05f);
        for (int i = 0; i < 600; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
        }

        Assert.Equal(0.05f, state.Anchor.Y + state.Positions[0].Y, 0.003f);
        Assert.True(state.IsAsleep);
    }

    [Fact]
    public void In_the_air_joints_and_limits_do_not_change_the_momentum()
    {
        (RagdollRig rig, RagdollState state, MovingPose pose) = Rope(6);
        Ragdoll.Start(rig, state, RootPlace.Identity, pose.Model, RootPlace.Identity, pose.Model, 0f, default(NoGround));
        state.Push(3, new Vector3(2f, 0f, 1f), pose.ModelPositions[3]);
        Vector3 before = Momentum(state);
        Assert.True(Vec.Length(before) > 0.01f);
        for (int i = 0; i < 60; i++)
        {
            Ragdoll.Advance(rig, state, weightless, default(NoGround), Frame);
        }

        Assert.True(Vec.Distance(before, Momentum(state)) < 0.02f * Vec.Length(before), $"{before} {Momentum(state)}");
    }

    [Fact]
    public void At_the_moment_of_going_limp_the_pose_is_the_motion_s_and_the_velocity_goes_on()
    {
        Creature creature = CreatureGenerator.Generate(3);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose before = new MovingPose(creature.Skeleton).Shaken(1, 0.02);
        MovingPose now = new MovingPose(creature.Skeleton).Shaken(1, 0.02);
        var rootBefore = new RootPlace(new Vector3(0f, 5f, 0f), Quaternion.Identity);
        var root = new RootPlace(new Vector3(0f, 5f, 3f * Frame), Quaternion.Identity);
        Ragdoll.Start(rig, state, root, now.Model, rootBefore, before.Model, Frame, FlatGround.Level);
        MovingPose shown = new MovingPose(creature.Skeleton).Shaken(1, 0.02);
        Ragdoll.Show(rig, state, root, shown.Local, shown.Model);
        for (int j = 0; j < creature.Skeleton.Count; j++)
        {
            Assert.True(Vec.Distance(now.ModelPositions[j], shown.ModelPositions[j]) < 1e-4f);
        }

        Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
        Ragdoll.Show(rig, state, root, shown.Local, shown.Model);
        for (int j = 1; j < creature.Skeleton.Count; j++)
        {
            Assert.Equal(3f * Frame, shown.ModelPositions[j].Z - now.ModelPositions[j].Z, 0.01f);
        }
    }

    [Fact]
    public void The_same_time_in_other_frames_gives_the_same_fall()
    {
        Vector3[] expected = FallFor(1f, 60);
        foreach (int frames in new[] { 30, 120, 480 })
        {
            Vector3[] actual = FallFor(1f, frames);
            for (int j = 0; j < expected.Length; j++)
            {
                Assert.True(Vec.Distance(expected[j], actual[j]) < 0.03f, $"{frames}: {Vec.Distance(expected[j], actual[j])}");
            }
        }
    }

    [Theory]
    [InlineData(0.05f)]
    [InlineData(20f, Explicit = true)]
    public void Small_and_large_creatures_come_to_rest_too_and_any_step_is_safe(float scale)
    {
        foreach (float step in new[] { Frame, 0.25f, 3f })
        {
            Creature creature = CreatureGenerator.Generate(2);
            RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
            var state = new RagdollState(rig);
            MovingPose pose = new(creature.Skeleton);
            var root = new RootPlace(new Vector3(1000f, 0.2f * scale, -1000f), Quaternion.Identity, scale);
            Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, 0f);
            for (int i = 0; i < 60 / Math.Min(step, 0.25f) && !state.IsAsleep; i++)
            {
                Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, step);
            }

            Assert.True(state.IsAsleep);
            Ragdoll.Show(rig, state, root, pose.Local, pose.Model);
            Assert.All(pose.ModelPositions, p => Assert.True(p - p == Vector3.Zero && Vec.Length(p) < 5f * rig.Size));
        }
    }

    [Fact]
    public void It_falls_alike_on_a_plane_a_height_field_and_a_mesh()
    {
        Creature creature = CreatureGenerator.Generate(5);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(new Vector3(0f, 0.3f, 0f), Quaternion.Identity);
        float slope = 0.3f;
        Vector3 At(float x, float z) => new(x, slope * x, z);
        var field = new HeightFieldGround([-6f, 0f, 6f, -6f, 0f, 6f, -6f, 0f, 6f], 3, 20f, new Vector3(-20f, 0f, -20f));
        var mesh = new MeshGround([At(-20f, -20f), At(20f, -20f), At(20f, 20f), At(-20f, 20f)], [0, 2, 1, 0, 3, 2]);
        var grounds = new IGround[] { new FlatGround(Vector3.Zero, new Vector3(-slope, 1f, 0f)), field, mesh };
        Vector3[]? first = null;
        foreach (IGround ground in grounds)
        {
            var state = new RagdollState(rig);
            Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, ground);
            for (int i = 0; i < 30; i++)
            {
                Ragdoll.Advance(rig, state, RagdollSettings.Default, ground, Frame);
            }

            first ??= state.Positions.ToArray();
            for (int i = 0; i < rig.Count; i++)
            {
                Assert.True(Vec.Distance(first[i], state.Positions[i]) < 0.01f, FormattableString.Invariant($"{ground.GetType().Name}, part {i}: {Vec.Distance(first[i], state.Positions[i])}"));
            }

            RootPlace up = Ragdoll.PlaceUnder(rig, state, ground);
            Assert.Equal(slope * up.Position.X, up.Position.Y, 1e-3f);
        }
    }

    [Fact]
    public void A_moved_origin_does_not_disturb_the_fall()
    {
        Creature creature = CreatureGenerator.Generate(5);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var here = new RagdollState(rig);
        var there = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(new Vector3(0f, 0.3f, 0f), Quaternion.Identity);
        Ragdoll.Start(rig, here, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        Ragdoll.Start(rig, there, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        there.Rebase(new Vector3(64f, 32f, -128f));
        var raised = new FlatGround(new Vector3(0f, 32f, 0f), Vector3.UnitY);
        for (int i = 0; i < 30; i++)
        {
            Ragdoll.Advance(rig, here, RagdollSettings.Default, FlatGround.Level, Frame);
            Ragdoll.Advance(rig, there, RagdollSettings.Default, raised, Frame);
        }

        for (int i = 0; i < rig.Count; i++)
        {
            Assert.True(Vec.Distance(here.Positions[i], there.Positions[i]) < 0.01f);
        }
    }

    [Fact]
    public void The_mirror_image_falls_the_other_way()
    {
        (RagdollRig rig, RagdollState left, MovingPose pose) = Rope(5);
        var right = new RagdollState(rig);
        var root = new RootPlace(new Vector3(0f, 0.4f, 0f), Rotation.FromAxisAngle(Vector3.UnitX, 1.2));
        foreach (RagdollState state in new[] { left, right })
        {
            Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
            state.Push(2, new Vector3(state == left ? 1f : -1f, 0f, 0f), root.ToWorld(pose.ModelPositions[2]));
        }

        for (int i = 0; i < 40; i++)
        {
            Ragdoll.Advance(rig, left, RagdollSettings.Default, FlatGround.Level, Frame);
            Ragdoll.Advance(rig, right, RagdollSettings.Default, FlatGround.Level, Frame);
        }

        for (int i = 0; i < rig.Count; i++)
        {
            Assert.True(Vec.Distance(Vec.Mirror(left.Positions[i]), right.Positions[i]) < 1e-3f);
        }
    }

    [Fact]
    public void Muscles_pull_to_the_pose_they_are_given()
    {
        (RagdollRig rig, RagdollState state, MovingPose pose) = Rope(4);
        Ragdoll.Start(rig, state, RootPlace.Identity, pose.Model, RootPlace.Identity, pose.Model, 0f, default(NoGround));
        MovingPose bent = new(rig.Skeleton);
        for (int j = 1; j < 5; j++)
        {
            bent.LocalRotations[j] = Rotation.FromAxisAngle(Vector3.UnitX, 0.3);
        }

        bent.Chained();
        Ragdoll.Aim(rig, state, bent.Model);
        for (int i = 0; i < 120; i++)
        {
            Ragdoll.Advance(rig, state, new RagdollSettings(Vector3.Zero, tone: 20f), default(NoGround), Frame);
        }

        Ragdoll.Show(rig, state, RootPlace.Identity, pose.Local, pose.Model);
        for (int j = 2; j < 5; j++)
        {
            Assert.Equal(0.3, Rotation.Angle(pose.LocalRotations[j]), 0.05);
        }
    }

    [Fact]
    public void Getting_up_starts_upright_on_the_ground_under_the_body_with_the_pose_where_it_lay()
    {
        Creature creature = CreatureGenerator.Generate(2);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(new Vector3(3f, 0.5f, 1f), Rotation.FromAxisAngle(Vec.Normalize(new Vector3(0.3f, 1f, 0.2f)), 1.3));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        for (int i = 0; i < 200; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
        }

        Ragdoll.Show(rig, state, root, pose.Local, pose.Model);
        RootPlace up = Ragdoll.PlaceUnder(rig, state, FlatGround.Level);
        Assert.Equal(0f, up.Position.Y, 1e-5f);
        Assert.True(Vec.Distance(Rotation.Rotate(up.Rotation, Vector3.UnitY), Vector3.UnitY) < 1e-5f);
        MovingPose again = new(creature.Skeleton);
        Ragdoll.Show(rig, state, up, again.Local, again.Model);
        for (int j = 1; j < creature.Skeleton.Count; j++)
        {
            Assert.True(Vec.Distance(root.ToWorld(pose.ModelPositions[j]), up.ToWorld(again.ModelPositions[j])) < 2e-3f);
        }
    }

    [Fact]
    public void A_push_wakes_a_sleeper_and_a_stopped_ragdoll_leaves_the_pose_alone()
    {
        (RagdollRig rig, RagdollState state, MovingPose pose) = Rope(3);
        Ragdoll.Start(rig, state, RootPlace.Identity, pose.Model, RootPlace.Identity, pose.Model, 0f, FlatGround.Level);
        for (int i = 0; i < 900 && !state.IsAsleep; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
        }

        Assert.True(state.IsAsleep);
        state.Push(1, new Vector3(3f, 1f, 0f), Vector3.Zero);
        Assert.False(state.IsAsleep);
        Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
        Assert.True(state.Speed > 0.1f);
        state.Stop();
        MovingPose rest = new(rig.Skeleton);
        Ragdoll.Show(rig, state, RootPlace.Identity, rest.Local, rest.Model);
        Assert.Equal(rig.Skeleton.LocalRotations.ToArray(), rest.LocalRotations);
    }

    [Fact]
    public void Falling_allocates_nothing_and_refuses_what_is_no_number()
    {
        Creature creature = CreatureGenerator.Generate(2);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        Ragdoll.Start(rig, state, RootPlace.Identity, pose.Model, RootPlace.Identity, pose.Model, 0f, FlatGround.Level);
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
            Ragdoll.Show(rig, state, RootPlace.Identity, pose.Local, pose.Model);
            Ragdoll.PlaceUnder(rig, state, FlatGround.Level);
        }));
        Assert.Throws<ArgumentOutOfRangeException>(() => Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, float.NaN));
        Assert.ThrowsAny<ArgumentException>(() => state.Push(1, new Vector3(float.NaN), Vector3.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(() => new RagdollSettings(new Vector3(float.NaN)));
        Assert.Throws<ArgumentException>(() => new RagdollRig(creature.Skeleton, Array.Empty<CapsuleCollider>()));
        Assert.Throws<ArgumentException>(() => Ragdoll.Advance(new RagdollRig(creature.Skeleton, creature.Bones), state, RagdollSettings.Default, FlatGround.Level, Frame));
        MovingPose broken = new(creature.Skeleton);
        Array.Fill(broken.ModelPositions, new Vector3(float.NaN));
        Assert.Throws<ArgumentException>(() => Ragdoll.Start(rig, state, RootPlace.Identity, broken.Model, RootPlace.Identity, broken.Model, 0f, FlatGround.Level));
    }

    private static Vector3[] FallFor(float seconds, int frames)
    {
        (RagdollRig rig, RagdollState state, MovingPose pose) = Rope(5);
        var root = new RootPlace(new Vector3(0f, 0.5f, 0f), Rotation.FromAxisAngle(Vec.Normalize(new Vector3(1f, 0f, 0.4f)), 1));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        for (int i = 0; i < frames; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, seconds / frames);
        }

        Ragdoll.Show(rig, state, root, pose.Local, pose.Model);
        return pose.ModelPositions;
    }

    /// <summary>A row of bones of 0.2 m along +Y, each with a capsule of 0.05 m.</summary>
    private static (RagdollRig Rig, RagdollState State, MovingPose Pose) Rope(int joints)
    {
        Skeleton skeleton = MovingPose.Chain(joints + 1, 0.2f, new JointLimit(0.8f, 0.6f, 0.3f));
        var capsules = Enumerable.Range(0, joints + 1).Select(j => new CapsuleCollider(j, new Vector3(0f, 0.05f, 0f), new Vector3(0f, 0.15f, 0f), 0.05f)).ToArray();
        var rig = new RagdollRig(skeleton, capsules);
        return (rig, new RagdollState(rig), new MovingPose(skeleton));
    }

    private static Vector3 Momentum(RagdollState state)
    {
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < state.Rig.Count; i++)
        {
            sum += state.Velocities[i] / state.Rig.Parts[i].InverseMass;
        }

        return sum;
    }

    private static float WidestGap(RagdollState state)
    {
        float widest = 0f;
        for (int i = 1; i < state.Rig.Count; i++)
        {
            RagdollPart part = state.Rig.Parts[i];
            Vector3 own = state.Positions[i] - (Rotation.Rotate(state.Rotations[i], part.Centre) * state.Scale);
            Vector3 other = state.Positions[part.Parent] + (Rotation.Rotate(state.Rotations[part.Parent], part.PivotInParent) * state.Scale);
            float gap = Vec.Distance(own, other);
            widest = gap > widest || float.IsNaN(gap) ? gap : widest;
        }

        return widest;
    }

    private static float Excess(Skeleton skeleton, MovingPose pose, int joint) =>
        SwingTwistLimit.Excess(Rotation.Multiply(Rotation.Inverse(skeleton.LocalRotations[joint]), pose.LocalRotations[joint]), skeleton.Joints[joint].Limit);

    /// <summary>No ground anywhere.</summary>
    private readonly struct NoGround : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            hit = default;
            return false;
        }
    }
}
