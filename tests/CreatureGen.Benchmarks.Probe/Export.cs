#if !EARLIER
using System;
using System.Globalization;
using System.IO;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Benchmarks.Probe;

/// <summary>Writes creatures as bare numbers, for programs of other libraries that do the same work; <c>Peers/subject.h</c> of the benchmarks reads them.</summary>
internal static class Export
{
    /// <summary>Writes a file for each of the first creatures.</summary>
    public static void Write(Subjects subjects, string folder, int count)
    {
        Directory.CreateDirectory(folder);
        for (int i = 0; i < count; i++)
        {
            using var file = new BinaryWriter(File.Create(Path.Combine(folder, i.ToString("D4", CultureInfo.InvariantCulture) + ".subject")));
            Write(subjects.Profiles[i], file);
        }
    }

    private static void Write(MotionProfile profile, BinaryWriter file)
    {
        var pair = new PosePair(profile);
        CreatureMesh mesh = profile.Subject.Mesh;
        file.Write(pair.Skeleton.Count);
        WriteAll(file, pair.Skeleton.Parents);
        WritePose(file, pair.First);
        WritePose(file, pair.Second);
        ForwardKinematics.LocalToModel(pair.Skeleton, pair.First, pair.Result);
        var matrices = new Matrix4x4[pair.Skeleton.Count];
        SkinMatrices.Fill(pair.Skeleton, pair.Result, matrices);
        WriteAll<Matrix4x4>(file, matrices);
        file.Write(mesh.Positions.Length);
        WriteAll(file, mesh.Positions);
        WriteAll(file, mesh.Normals);
        foreach (SkinWeights w in mesh.Weights)
        {
            file.Write((ushort)w.Joint0);
            file.Write((ushort)w.Joint1);
            file.Write((ushort)w.Joint2);
            file.Write((ushort)w.Joint3);
        }

        foreach (SkinWeights w in mesh.Weights)
        {
            file.Write(w.Weights.X);
            file.Write(w.Weights.Y);
            file.Write(w.Weights.Z);
        }

        file.Write(mesh.Triangles.Length);
        WriteAll(file, mesh.Triangles);
    }

    private static void WritePose(BinaryWriter file, in Pose pose)
    {
        for (int i = 0; i < pose.Rotations.Length; i++)
        {
            WriteAll(file, pose.Positions.Slice(i, 1));
            WriteAll(file, pose.Rotations.Slice(i, 1));
        }
    }

    private static void WriteAll<T>(BinaryWriter file, ReadOnlySpan<T> values)
        where T : unmanaged
        => file.Write(MemoryMarshal.AsBytes(values));

    private static void WriteAll<T>(BinaryWriter file, Span<T> values)
        where T : unmanaged
        => file.Write(MemoryMarshal.AsBytes(values));
}
#endif
