using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Inspection;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Creatures.Forks;

public sealed class TwoHeadTests
{
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Bodies_with_two_heads_keep_every_invariant_and_cross_themselves_no_more_often_than_with_one(LocomotionKind kind)
    {
        int count = Thoroughness.Of(60);
        int torn = 0;
        foreach ((CreatureBlueprint one, CreatureBlueprint two) in ForkedCreatures.Of(kind, count))
        {
            Assert.Empty(BlueprintValidator.Validate(two));
            Creature creature = CreatureAssembler.Assemble(two);
            Assert.Empty(CreatureInspection.Inspect(creature).Select(violation => $"{one.Seed} {violation.Invariant}: {violation.Detail}"));
            if (CreatureInspection.CountSelfIntersections(creature) > 0)
            {
                torn += CreatureInspection.CountSelfIntersections(CreatureAssembler.Assemble(one)) > 0 ? 0 : 1;
            }
        }

        // Forelegs of a mantis are beside its head.
        Assert.InRange(torn, 0, Math.Max(1, count / 30));
    }

    [Fact]
    public void The_second_head_is_the_mirror_image_of_the_first_joint_for_joint()
    {
        foreach ((_, CreatureBlueprint two) in ForkedCreatures.Of(LocomotionKind.Walking, 6))
        {
            Skeleton skeleton = CreatureAssembler.Assemble(two).Skeleton;
            Joint[] second = skeleton.Joints.Where(joint => joint.Name.EndsWith(Heads.Suffix, StringComparison.Ordinal) && skeleton.IndexOf(joint.Name[..^Heads.Suffix.Length]) >= 0).ToArray();
            Assert.Equal(2, skeleton.Joints.Count(joint => joint.Role == JointRole.Head));
            Assert.Equal(2 * second.Count(joint => joint.Role == JointRole.Jaw), skeleton.Joints.Count(joint => joint.Role == JointRole.Jaw));
            Assert.Equal(2 * second.Count(joint => joint.Role == JointRole.Eye), skeleton.Joints.Count(joint => joint.Role == JointRole.Eye));
            foreach (Joint joint in second)
            {
                string name = joint.Name[..^Heads.Suffix.Length];
                int mirrored = skeleton.Mirrors[skeleton.IndexOf(name)];
                Vector3 expected = Vec.Mirror(skeleton.ModelPositions[mirrored]);
                Assert.True(Vec.Distance(expected, joint.ModelPosition) < 1e-4f * (1f + Vec.Length(expected)), $"{two.Seed} {joint.Name}: {joint.ModelPosition}, expected {expected}");
                Assert.True(joint.ModelPosition.X < 0f || name.StartsWith("Ear", StringComparison.Ordinal), $"{two.Seed} {joint.Name} is on the left");
            }
        }
    }

    [Fact]
    public void What_is_behind_the_fork_stays_where_it_was()
    {
        foreach ((CreatureBlueprint one, CreatureBlueprint two) in ForkedCreatures.Of(LocomotionKind.Walking, 6))
        {
            Skeleton before = CreatureAssembler.Assemble(one).Skeleton;
            Skeleton after = CreatureAssembler.Assemble(two).Skeleton;
            Assert.True(after.Count > before.Count);
            for (int j = 0; j < before.Count; j++)
            {
                Assert.Equal(before.Joints[j].Name, after.Joints[j].Name);
                Assert.Equal(before.Joints[j].Parent, after.Joints[j].Parent);
                Assert.True(after.IndexOf(before.Joints[j].Name + Heads.Suffix) >= 0 || Vec.Distance(before.ModelPositions[j], after.ModelPositions[j]) < 1e-4f, before.Joints[j].Name);
            }
        }
    }

    [Fact]
    public void Each_head_moves_its_own_half_of_the_skin()
    {
        foreach ((_, CreatureBlueprint two) in ForkedCreatures.Of(LocomotionKind.Flying, 4))
        {
            Creature creature = CreatureAssembler.Assemble(two);
            int[] moved = new int[2];
            for (int v = 0; v < creature.Mesh.Positions.Length; v++)
            {
                SkinWeights weights = creature.Mesh.Weights[v];
                int head = Heads.Above(creature.Skeleton, weights.Joint0);
                if (head >= 0 && weights.Weights.X > 0.9f)
                {
                    bool second = creature.Skeleton.Joints[head].Name.EndsWith(Heads.Suffix, StringComparison.Ordinal);
                    moved[second ? 1 : 0]++;
                    Assert.True(creature.Skeleton.Joints[weights.Joint0].Role is JointRole.Ear or JointRole.Antenna || (creature.Mesh.Positions[v].X < 0f) == second, $"{two.Seed}: vertex {v} at {creature.Mesh.Positions[v]}");
                }
            }

            Assert.InRange(moved[0], 100, int.MaxValue);
            Assert.InRange(moved[1], (int)(0.9 * moved[0]), (int)(1.1 * moved[0]));
        }
    }

    [Fact]
    public void Limbs_sockets_and_points_of_the_head_are_there_twice_under_names_of_their_own()
    {
        foreach ((CreatureBlueprint one, CreatureBlueprint two) in ForkedCreatures.Of(LocomotionKind.Walking, 6))
        {
            Creature before = CreatureAssembler.Assemble(one);
            Creature after = CreatureAssembler.Assemble(two);
            int Ears(Creature creature) => creature.Limbs.Count(limb => limb.Kind is LimbKind.Ear or LimbKind.Antenna);
            Assert.Equal(2 * Ears(before), Ears(after));
            Assert.Equal(after.Limbs.Count, after.Limbs.Select(limb => (limb.Kind, limb.Side, limb.Pair)).Distinct().Count());
            Assert.Equal(2, after.Sockets.Count(socket => socket.Kind == SocketKind.Mouth));
            Assert.Equal(2, after.Sockets.Count(socket => socket.Kind == SocketKind.Head));
            Assert.Equal(after.Sockets.Count, after.Sockets.Select(socket => socket.Name).Distinct().Count());
            Assert.Equal(after.AttachmentPoints.Count, after.AttachmentPoints.Select(point => point.Name).Distinct().Count());
        }
    }

    [Fact]
    public void Two_heads_weigh_little_more_than_one()
    {
        foreach (LocomotionKind kind in Enum.GetValues<LocomotionKind>())
        {
            foreach ((CreatureBlueprint one, CreatureBlueprint two) in ForkedCreatures.Of(kind, 4))
            {
                Assert.InRange(CreatureAssembler.Assemble(two).Mass.Mass / CreatureAssembler.Assemble(one).Mass.Mass, 0.95f, 1.45f);
            }
        }
    }

    [Fact]
    public void Both_heads_are_written_into_a_file_and_read_from_it()
    {
        CreatureBlueprint two = ForkedCreatures.Of(LocomotionKind.Walking, 1).Single().Two;
        using var stream = new MemoryStream();
        GlbWriter.Write(CreatureAssembler.Assemble(two), new GltfOptions(), stream);
        stream.Position = 0;
        Assert.Equal(two, GlbReader.ReadBlueprint(stream).Blueprint);
        Assert.Equal(two, BlueprintJson.Read(BlueprintJson.Write(two)).Blueprint);
    }
}
