using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Skinning;

namespace CreatureGen.Engines;

/// <summary>A mesh as an engine takes it. It holds no numbers of its own: each method fills a span that the caller owns, and allocates nothing.</summary>
/// <remarks>Vertices keep their numbers, so that what is kept for each vertex of the creature's mesh suits the engine's as well.</remarks>
public sealed class EngineMesh
{
    private readonly CreatureMesh mesh;

    /// <summary>The mesh for an engine.</summary>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public EngineMesh(CreatureMesh mesh, EngineAxes axes)
    {
        this.mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        Axes = axes ?? throw new ArgumentNullException(nameof(axes));
    }

    /// <summary>How the engine counts.</summary>
    public EngineAxes Axes { get; }

    /// <summary>Number of vertices.</summary>
    public int VertexCount => mesh.Positions.Length;

    /// <summary>Number of corners of all triangles.</summary>
    public int IndexCount => mesh.Triangles.Length;

    /// <summary>Whether 16 bits hold every index; 65 535, which restarts a strip, is not used.</summary>
    public bool FitsShortIndices => VertexCount <= ushort.MaxValue;

    /// <summary>Whether there are tangents: those of a mesh made by <see cref="CreatureMesh.Textured"/>.</summary>
    public bool HasTangents => !mesh.Tangents.IsEmpty;

    /// <summary>The triangles by material, in order: sub-meshes, surfaces or sections of the engine.</summary>
    public IReadOnlyList<MeshPart> Parts => mesh.Parts;

    /// <summary>Fills in positions, in the engine's units.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per vertex.</exception>
    public void FillPositions(Span<Vector3> destination)
    {
        RequireVertices(destination.Length);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = Axes.Point(mesh.Positions[i]);
        }
    }

    /// <summary>Fills in unit normals.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per vertex.</exception>
    public void FillNormals(Span<Vector3> destination)
    {
        RequireVertices(destination.Length);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = Axes.Direction(mesh.Normals[i]);
        }
    }

    /// <summary>Fills in tangents with the side of the third axis in w: see <see cref="EngineAxes.Tangent"/>.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per vertex.</exception>
    /// <exception cref="InvalidOperationException">The mesh has no tangents.</exception>
    public void FillTangents(Span<Vector4> destination)
    {
        if (!HasTangents)
        {
            throw new InvalidOperationException("the mesh has no tangents; expected one made by CreatureMesh.Textured()");
        }

        RequireVertices(destination.Length);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = Axes.Tangent(mesh.Tangents[i]);
        }
    }

    /// <summary>Fills in texture coordinates.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per vertex.</exception>
    public void FillTexcoords(Span<Vector2> destination)
    {
        RequireVertices(destination.Length);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = Axes.Texcoord(mesh.Texcoords[i]);
        }
    }

    /// <summary>Fills in linear colours: red, green, blue, 0..1, and full opacity.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per vertex.</exception>
    public void FillColours(Span<Vector4> destination)
    {
        RequireVertices(destination.Length);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = new Vector4(mesh.Colours[i], 1f);
        }
    }

    /// <summary>Fills in four joints and four weights for each vertex, a byte each: weights are parts of 255 and sum to it, the largest first. Equal weights give equal bytes.</summary>
    /// <param name="joints">Four per vertex.</param>
    /// <param name="weights">Four per vertex, in the same order; an unused one is joint 0 with weight 0.</param>
    /// <exception cref="ArgumentException">A span does not have four entries per vertex, or a joint is beyond 255.</exception>
    public void FillInfluences(Span<byte> joints, Span<byte> weights)
    {
        RequireFours(joints.Length, nameof(joints));
        RequireFours(weights.Length, nameof(weights));
        for (int i = 0; i < VertexCount; i++)
        {
            SkinWeights s = mesh.Weights[i];
            Span<byte> w = weights.Slice(4 * i, 4);
            Pack(s.Weights, w);
            Span<byte> j = joints.Slice(4 * i, 4);
            j[0] = PackedJoint(s.Joint0, w[0]);
            j[1] = PackedJoint(s.Joint1, w[1]);
            j[2] = PackedJoint(s.Joint2, w[2]);
            j[3] = PackedJoint(s.Joint3, w[3]);
        }
    }

    /// <summary>Fills in four joints of two bytes and four weights for each vertex.</summary>
    /// <param name="joints">Four per vertex.</param>
    /// <param name="weights">One entry per vertex, the largest first; they sum to 1.</param>
    /// <exception cref="ArgumentException">A span does not have four joints, or one entry of weights, per vertex.</exception>
    public void FillInfluences(Span<ushort> joints, Span<Vector4> weights)
    {
        RequireFours(joints.Length, nameof(joints));
        RequireVertices(weights.Length);
        for (int i = 0; i < VertexCount; i++)
        {
            SkinWeights s = mesh.Weights[i];
            joints[4 * i] = (ushort)s.Joint0;
            joints[(4 * i) + 1] = (ushort)s.Joint1;
            joints[(4 * i) + 2] = (ushort)s.Joint2;
            joints[(4 * i) + 3] = (ushort)s.Joint3;
            weights[i] = s.Weights;
        }
    }

    /// <summary>Fills in the corners of all triangles, in the engine's order.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per corner.</exception>
    public void FillIndices(Span<int> destination) => Axes.Convert(mesh.Triangles, destination);

    /// <summary>Fills in the corners of all triangles, in the engine's order, 16 bits each.</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per corner, or 16 bits do not hold them: see <see cref="FitsShortIndices"/>.</exception>
    public void FillIndices(Span<ushort> destination) => Axes.Convert(mesh.Triangles, destination);

    /// <summary>Parts of 255: what rounding down leaves over goes to those that lost most. Descending weights stay so.</summary>
    private static void Pack(Vector4 weights, Span<byte> packed)
    {
        Span<float> lost = stackalloc float[4] { weights.X, weights.Y, weights.Z, weights.W };
        int rest = byte.MaxValue;
        for (int k = 0; k < 4; k++)
        {
            float fraction = lost[k] * byte.MaxValue;
            packed[k] = (byte)Math.Min((int)fraction, rest);
            lost[k] = fraction - packed[k];
            rest -= packed[k];
        }

        for (; rest > 0; rest--)
        {
            int max = 0;
            for (int k = 1; k < 4; k++)
            {
                max = lost[k] > lost[max] ? k : max;
            }

            packed[max]++;
            lost[max] -= 1f;
        }
    }

    private static byte PackedJoint(int joint, byte weight)
    {
        if (weight == 0)
        {
            return 0;
        }

        return (uint)joint <= byte.MaxValue
            ? (byte)joint
            : throw new ArgumentException(FormattableString.Invariant($"joint {joint}; expected 0..{byte.MaxValue} in a byte: the overload with two bytes takes more"));
    }

    private void RequireVertices(int length) => EngineAxes.RequireLength(length, VertexCount, "vertices", "destination");

    private void RequireFours(int length, string name)
    {
        if (length != 4 * VertexCount)
        {
            throw new ArgumentException(FormattableString.Invariant($"{length} entries; expected {4 * VertexCount}, four for each vertex"), name);
        }
    }
}
