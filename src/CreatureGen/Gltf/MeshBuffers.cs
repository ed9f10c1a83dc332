using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Gltf;

/// <summary>The accessors of a creature's mesh and skin. All parts share one set of vertices and have indices of their own.</summary>
internal sealed class MeshBuffers
{
    /// <summary>The largest vertex index that 16 bits hold: 65535 restarts a strip.</summary>
    private const int LastShortIndex = ushort.MaxValue - 1;

    private readonly CreatureMesh mesh;
    private readonly Skeleton skeleton;
    private readonly List<Accessor> indices = new();

    /// <summary>Appends the accessors of <paramref name="mesh"/> and of the skin of <paramref name="skeleton"/> to <paramref name="plan"/>.</summary>
    /// <param name="mesh">What is drawn.</param>
    /// <param name="skeleton">Its joints.</param>
    /// <param name="plan">Takes the accessors.</param>
    public MeshBuffers(CreatureMesh mesh, Skeleton skeleton, BufferPlan plan)
    {
        this.mesh = mesh;
        this.skeleton = skeleton;
        int vertices = mesh.Positions.Length;
        ComponentFormat joint = skeleton.Joints.Count > byte.MaxValue ? ComponentFormat.Short : ComponentFormat.Byte;
        ComponentFormat index = vertices - 1 > LastShortIndex ? ComponentFormat.Integer : ComponentFormat.Short;
        Positions = plan.Add(ElementShape.Vector3, ComponentFormat.Float, vertices, BufferTarget.Vertices);
        Normals = plan.Add(ElementShape.Vector3, ComponentFormat.Float, vertices, BufferTarget.Vertices);
        Tangents = mesh.Tangents.IsEmpty ? null : plan.Add(ElementShape.Vector4, ComponentFormat.Float, vertices, BufferTarget.Vertices);
        Texcoords = plan.Add(ElementShape.Vector2, ComponentFormat.Float, vertices, BufferTarget.Vertices);
        Colours = plan.Add(ElementShape.Vector4, ComponentFormat.ShortFraction, vertices, BufferTarget.Vertices);
        Joints = plan.Add(ElementShape.Vector4, joint, vertices, BufferTarget.Vertices);
        Weights = plan.Add(ElementShape.Vector4, ComponentFormat.Float, vertices, BufferTarget.Vertices);
        foreach (MeshPart part in mesh.Parts)
        {
            indices.Add(plan.Add(ElementShape.Scalar, index, part.IndexCount, BufferTarget.Indices));
        }

        InverseBinds = plan.Add(ElementShape.Matrix4, ComponentFormat.Float, skeleton.Joints.Count, BufferTarget.None);
    }

    public Accessor Positions { get; }

    public Accessor Normals { get; }

    /// <summary>Null without a normal map.</summary>
    public Accessor? Tangents { get; }

    public Accessor Texcoords { get; }

    public Accessor Colours { get; }

    public Accessor Joints { get; }

    public Accessor Weights { get; }

    /// <summary>The corners of each part's triangles, part by part.</summary>
    public IReadOnlyList<Accessor> Indices => indices;

    /// <summary>One matrix for each joint, from model space to the joint's.</summary>
    public Accessor InverseBinds { get; }

    /// <summary>Writes all accessors into the binary chunk and returns the bounding box of the positions.</summary>
    /// <exception cref="InvalidOperationException">The mesh holds something that a file must not.</exception>
    public (Vector3 Min, Vector3 Max) Write(Span<byte> binary)
    {
        (Vector3 Min, Vector3 Max) box = VertexWriter.Positions(mesh.Positions, BufferPlan.Bytes(Positions, binary));
        VertexWriter.Normals(mesh.Normals, BufferPlan.Bytes(Normals, binary));
        if (Tangents != null)
        {
            VertexWriter.Tangents(mesh.Tangents, BufferPlan.Bytes(Tangents, binary));
        }

        VertexWriter.Texcoords(mesh.Texcoords, BufferPlan.Bytes(Texcoords, binary));
        VertexWriter.Colours(mesh.Colours, BufferPlan.Bytes(Colours, binary));
        WriteJoints(BufferPlan.Bytes(Joints, binary));
        InfluenceWriter.Weights(mesh.Weights, BufferPlan.Bytes(Weights, binary));
        for (int i = 0; i < indices.Count; i++)
        {
            WriteIndices(mesh.Parts[i], indices[i], BufferPlan.Bytes(indices[i], binary));
        }

        WriteInverseBinds(BufferPlan.Bytes(InverseBinds, binary));
        return box;
    }

    private void WriteJoints(Span<byte> destination)
    {
        if (Joints.Format == ComponentFormat.Byte)
        {
            InfluenceWriter.ByteJoints(mesh.Weights, skeleton.Joints.Count, destination);
        }
        else
        {
            InfluenceWriter.ShortJoints(mesh.Weights, skeleton.Joints.Count, destination);
        }
    }

    private void WriteIndices(MeshPart part, Accessor accessor, Span<byte> destination)
    {
        ReadOnlySpan<int> corners = mesh.Triangles.Slice(part.FirstIndex, part.IndexCount);
        if (accessor.Format == ComponentFormat.Short)
        {
            VertexWriter.ShortIndices(corners, part.FirstIndex / 3, destination);
        }
        else
        {
            VertexWriter.Indices(corners, part.FirstIndex / 3, destination);
        }
    }

    private void WriteInverseBinds(Span<byte> destination)
    {
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.FillInverseBinds(skeleton, matrices);
        ReadOnlySpan<float> numbers = MemoryMarshal.Cast<Matrix4x4, float>(matrices);
        for (int k = 0; k < numbers.Length; k++)
        {
            LittleEndian.Write(destination, 4 * k, numbers[k]);
        }
    }
}
