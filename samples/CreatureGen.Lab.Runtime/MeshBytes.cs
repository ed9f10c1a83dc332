using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Engines;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Lab;

/// <summary>
/// A mesh as one block of little-endian bytes that a page can hand to its graphics library as it is: 8 whole numbers (vertices, indices, joints, indices of skin, bytes of an index, 1 with tangents, 0, 0), then
/// positions, normals and texture coordinates as floats, tangents if there are any, colours as four 16-bit parts of one, joints and weights as four bytes each, the parents of the joints and their places at rest, and indices.
/// </summary>
internal static class MeshBytes
{
    private const int HeadLength = 8;
    private const int MaxJoints = 256;

    public static byte[] Of(Creature creature, CreatureMesh source)
    {
        EngineMesh mesh = source.For(EngineAxes.ThreeJs);
        Skeleton skeleton = creature.Skeleton;
        if (skeleton.Count > MaxJoints)
        {
            throw new ArgumentException(FormattableString.Invariant($"{skeleton.Count} joints; expected at most {MaxJoints}"), nameof(creature));
        }

        int n = mesh.VertexCount;
        int indexBytes = mesh.FitsShortIndices ? 2 : 4;
        int tangentBytes = mesh.HasTangents ? 16 : 0;
        byte[] bytes = new byte[(4 * HeadLength) + (n * (12 + 12 + 8 + tangentBytes + 8 + 4 + 4)) + (skeleton.Count * 16) + (mesh.IndexCount * indexBytes)];
        Span<byte> rest = bytes;
        Span<int> head = Take<int>(ref rest, HeadLength);
        head[0] = n;
        head[1] = mesh.IndexCount;
        head[2] = skeleton.Count;
        head[3] = SkinIndices(mesh.Parts);
        head[4] = indexBytes;
        head[5] = mesh.HasTangents ? 1 : 0;
        mesh.FillPositions(Take<Vector3>(ref rest, n));
        mesh.FillNormals(Take<Vector3>(ref rest, n));
        mesh.FillTexcoords(Take<Vector2>(ref rest, n));
        if (mesh.HasTangents)
        {
            mesh.FillTangents(Take<Vector4>(ref rest, n));
        }

        FillColours(source, Take<ushort>(ref rest, 4 * n));
        Span<byte> joints = Take<byte>(ref rest, 4 * n);
        mesh.FillInfluences(joints, Take<byte>(ref rest, 4 * n));
        skeleton.Parents.CopyTo(Take<int>(ref rest, skeleton.Count));
        skeleton.ModelPositions.CopyTo(Take<Vector3>(ref rest, skeleton.Count));
        if (indexBytes == 2)
        {
            mesh.FillIndices(Take<ushort>(ref rest, mesh.IndexCount));
        }
        else
        {
            mesh.FillIndices(Take<int>(ref rest, mesh.IndexCount));
        }

        return bytes;
    }

    /// <summary>How many indices are of the skin, then the indices of a level, as 32-bit numbers.</summary>
    public static byte[] Level(CreatureLod level)
    {
        byte[] bytes = new byte[4 + (4 * level.Triangles.Length)];
        Span<int> numbers = MemoryMarshal.Cast<byte, int>(bytes.AsSpan());
        numbers[0] = SkinIndices(level.Parts);
        level.Triangles.CopyTo(numbers[1..]);
        return bytes;
    }

    /// <summary>The bones' capsules in the creature's space at rest: joint, start, end, radius; eight floats each.</summary>
    public static byte[] Capsules(Creature creature)
    {
        byte[] bytes = new byte[creature.Bones.Count * 32];
        Span<float> at = MemoryMarshal.Cast<byte, float>(bytes.AsSpan());
        foreach (CapsuleCollider bone in creature.Bones)
        {
            Joint joint = creature.Skeleton.Joints[bone.Joint];
            Vector3 start = joint.ModelPosition + Maths.Rotation.Rotate(joint.ModelRotation, bone.Start);
            Vector3 end = joint.ModelPosition + Maths.Rotation.Rotate(joint.ModelRotation, bone.End);
            at[0] = bone.Joint;
            start.CopyTo(at[1..]);
            end.CopyTo(at[4..]);
            at[7] = bone.Radius;
            at = at[8..];
        }

        return bytes;
    }

    /// <summary>Linear colours; the fourth part is one where a vertex keeps its colour under a texture.</summary>
    private static void FillColours(CreatureMesh mesh, Span<ushort> colours)
    {
        for (int i = 0; i < mesh.Colours.Length; i++)
        {
            Vector3 colour = mesh.Colours[i];
            colours[4 * i] = Part(colour.X);
            colours[(4 * i) + 1] = Part(colour.Y);
            colours[(4 * i) + 2] = Part(colour.Z);
            colours[(4 * i) + 3] = CreatureTextures.KeepsItsColour(mesh.Texcoords[i]) ? ushort.MaxValue : (ushort)0;
        }
    }

    private static ushort Part(float part) => (ushort)((Math.Clamp(part, 0f, 1f) * ushort.MaxValue) + 0.5f);

    private static int SkinIndices(IReadOnlyList<MeshPart> parts)
    {
        int count = 0;
        foreach (MeshPart part in parts)
        {
            count += part.Material == MaterialKind.Skin ? part.IndexCount : 0;
        }

        return count;
    }

    private static Span<T> Take<T>(ref Span<byte> rest, int count)
        where T : unmanaged
    {
        Span<T> taken = MemoryMarshal.Cast<byte, T>(rest)[..count];
        rest = rest[(count * System.Runtime.CompilerServices.Unsafe.SizeOf<T>())..];
        return taken;
    }
}
