using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Sockets in the world as the creature moves.</summary>
public sealed class AnimatorSocketTests
{
    /// <summary>What is stuck to a socket keeps its distance to skin that only the socket's joint moves.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 42)]
    [InlineData(RequestedKind.Flying, 7)]
    [InlineData(RequestedKind.Swimming, 3)]
    public void A_socket_goes_with_the_skin_of_its_joint(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        var animator = new CreatureAnimator(creature);
        animator.Teleport(new RootPlace(new Vector3(3f, 0f, -2f), Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.7f), 1.5f), FlatGround.Level);
        for (int i = 0; i < 90; i++)
        {
            animator.Update(1f / 30f, new MotionInput(creature.DefaultSpeed, 0.4f), FlatGround.Level);
        }

        var matrices = new Matrix4x4[creature.Skeleton.Count];
        SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        var posed = new Vector3[creature.Mesh.Positions.Length];
        var normals = new Vector3[posed.Length];
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, posed, normals);
        int checkedSockets = 0;
        for (int s = 0; s < creature.Sockets.Count; s++)
        {
            CreatureSocket socket = creature.Sockets[s];
            Quaternion joint = creature.Skeleton.ModelRotations[socket.Joint];
            Vector3 rest = creature.Skeleton.ModelPositions[socket.Joint] + Vector3.Transform(socket.Position, joint);
            Quaternion restFrame = joint * socket.Rotation;
            RootPlace world = animator.Socket(s);
            for (int v = 0; v < posed.Length; v++)
            {
                if (creature.Mesh.Weights[v].Joint0 == socket.Joint && creature.Mesh.Weights[v].Weights.X > 0.9999f)
                {
                    Vector3 within = Vector3.Transform(creature.Mesh.Positions[v] - rest, Quaternion.Inverse(restFrame));
                    Assert.True(Vector3.Distance(animator.Root.ToWorld(posed[v]), world.ToWorld(within)) < 2e-4f, socket.Name);
                    checkedSockets++;
                    break;
                }
            }
        }

        Assert.True(checkedSockets > 3);
    }

    [Fact]
    public void A_rider_on_the_saddle_goes_where_its_mount_goes()
    {
        var mount = new CreatureAnimator(CreatureGenerator.Generate(42));
        var rider = new CreatureAnimator(CreatureGenerator.Generate(1));
        int saddle = mount.Profile.Subject.Sockets.ToList().FindIndex(s => s.Kind == SocketKind.Saddle);
        for (int i = 0; i < 30; i++)
        {
            mount.Update(1f / 30f, new MotionInput(1f), FlatGround.Level);
            rider.Follow(1f / 30f, mount.Socket(saddle), FlatGround.Level);
        }

        Assert.Equal(mount.Socket(saddle).Position, rider.Root.Position);
        Assert.True(Vector3.Transform(Vector3.UnitZ, rider.Root.Rotation).Z > 0.8f);
        Assert.True(rider.Root.Position.Y > 0.5f * mount.Profile.Subject.StandingHeight);
    }

    [Fact]
    public void A_socket_that_is_not_there_is_refused()
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(42));
        Assert.Throws<ArgumentOutOfRangeException>("socket", () => animator.Socket(-1));
        Assert.Throws<ArgumentOutOfRangeException>("socket", () => animator.Socket(animator.Profile.Subject.Sockets.Count));
    }

    [Fact]
    public void Reading_sockets_allocates_nothing()
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(42));
        int next = 0;
        Assert.Equal(0, MovingPose.Allocated(() => animator.Socket(next++ % animator.Profile.Subject.Sockets.Count), 100));
    }
}
