using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Skinning;

/// <summary>Triangles whose vertices follow the joints of a skeleton. Immutable.</summary>
public sealed class SkinnedMesh
{
    private readonly Vector3[] positions;
    private readonly Vector3[] normals;
    private readonly SkinWeights[] weights;
    private readonly int[] triangles;

    /// <summary>Takes ownership of the arrays.</summary>
    /// <param name="positions">One per vertex, metres, in the space in which the joints were bound.</param>
    /// <param name="normals">One unit vector per vertex.</param>
    /// <param name="weights">Up to four joints per vertex.</param>
    /// <param name="triangles">Three vertices each, counter-clockwise seen from outside.</param>
    /// <exception cref="ArgumentException">Arrays differ in length, there is no triangle, an index is out of range or a number is not finite.</exception>
    public SkinnedMesh(Vector3[] positions, Vector3[] normals, SkinWeights[] weights, int[] triangles)
    {
        if (normals.Length != positions.Length || weights.Length != positions.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{positions.Length} positions, {normals.Length} normals and {weights.Length} weights; expected one of each per vertex"), nameof(normals));
        }

        if (triangles.Length == 0 || triangles.Length % 3 != 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"{triangles.Length} indices; expected three for each triangle, and one triangle at least"), nameof(triangles));
        }

        foreach (int index in triangles)
        {
            if ((uint)index >= (uint)positions.Length)
            {
                throw new ArgumentException(FormattableString.Invariant($"triangle index {index}; expected 0..{positions.Length - 1}"), nameof(triangles));
            }
        }

        for (int i = 0; i < positions.Length; i++)
        {
            if (!Finite.Is(positions[i]) || !Finite.Is(normals[i]))
            {
                throw new ArgumentException(FormattableString.Invariant($"vertex {i} has a position or a normal that is not finite; expected numbers"), nameof(positions));
            }
        }

        this.positions = positions;
        this.normals = normals;
        this.weights = weights;
        this.triangles = triangles;
    }

    /// <summary>Metres, in the space in which the joints were bound.</summary>
    public ReadOnlySpan<Vector3> Positions => positions;

    /// <summary>Unit vectors.</summary>
    public ReadOnlySpan<Vector3> Normals => normals;

    /// <summary>Up to four joints per vertex.</summary>
    public ReadOnlySpan<SkinWeights> Weights => weights;

    /// <summary>Three vertices each, counter-clockwise seen from outside.</summary>
    public ReadOnlySpan<int> Triangles => triangles;
}
