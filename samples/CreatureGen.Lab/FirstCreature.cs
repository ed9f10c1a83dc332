using System;
using System.IO;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using CreatureGen.Skinning;

namespace CreatureGen.Lab;

/// <summary>
/// The creature that the page shows before the library runs in it: its mesh, and how it stands and breathes for a while. Whole numbers come first (bytes of the mesh, frames, joints, 0), then the mesh and the matrices
/// of all joints, frame by frame, as floats of half precision.
/// </summary>
internal static class FirstCreature
{
    /// <summary>The same seed and kind as in the page's own code.</summary>
    private const ulong Seed = 25;
    private const int Frames = 48;
    private const float Rate = 12f;
    private const float SettleSeconds = 2f;
    private const int StillWidth = 640;
    private const int StillHeight = 560;

    /// <summary>It, as it is seen first of all: on nothing but its shadow.</summary>
    public static byte[] Still() =>
        PngWriter.ToBytes(Portrait.Take(Grow(), View.ThreeQuarter, new RenderOptions { Width = StillWidth, Height = StillHeight, Backdrop = BackdropKind.Transparent }));

    /// <summary>Its mesh and poses.</summary>
    public static byte[] Bake()
    {
        Creature creature = Grow();
        byte[] mesh = MeshBytes.Of(creature, creature.Mesh);
        byte[] poses = Poses(creature);
        using var all = new MemoryStream();
        Span<byte> head = stackalloc byte[16];
        MemoryMarshal.Cast<int, byte>([mesh.Length, Frames, creature.Skeleton.Count, 0]).CopyTo(head);
        all.Write(head);
        all.Write(mesh);
        all.Write(poses);
        return all.ToArray();
    }

    private static Creature Grow() => CreatureGenerator.Generate(Seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });

    private static byte[] Poses(Creature creature)
    {
        var animator = new CreatureAnimator(creature);
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        var poses = new Half[Frames * 16 * matrices.Length];
        for (float t = 0f; t < SettleSeconds; t += 1f / Rate)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
        }

        for (int frame = 0, at = 0; frame < Frames; frame++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
            foreach (float number in MemoryMarshal.Cast<Matrix4x4, float>(matrices))
            {
                poses[at++] = (Half)number;
            }
        }

        return MemoryMarshal.AsBytes<Half>(poses).ToArray();
    }
}
