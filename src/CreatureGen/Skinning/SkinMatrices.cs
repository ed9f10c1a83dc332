using System;
using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>The matrices that carry the skin of each joint from the rest pose to a pose.</summary>
public static class SkinMatrices
{
    /// <summary>Fills in one matrix per joint: inverse bind transform, then the posed model transform. Nothing is allocated.</summary>
    /// <param name="skeleton">Its rest pose is the bind pose.</param>
    /// <param name="model">The pose in model space.</param>
    /// <param name="matrices">Receives one matrix per joint, for row vectors (v · M, translation in the fourth row).</param>
    /// <exception cref="ArgumentException">A span is not as long as the skeleton.</exception>
    public static void Fill(Skeleton skeleton, in Pose model, Span<Matrix4x4> matrices)
    {
        model.Require(skeleton);
        int count = skeleton.Count;
        if (matrices.Length != count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{matrices.Length} matrices; expected one for each of the {count} joints"), nameof(matrices));
        }

        ReadOnlySpan<Quaternion> bindRotations = skeleton.ModelRotations;
        ReadOnlySpan<Vector3> bindPositions = skeleton.ModelPositions;
        ReadOnlySpan<Quaternion> rotations = model.Rotations;
        ReadOnlySpan<Vector3> positions = model.Positions;
        for (int i = 0; i < count; i++)
        {
            Quaternion a = rotations[i];
            Quaternion b = bindRotations[i];
            Vector3 p = positions[i];
            Vector3 o = bindPositions[i];

            // a times the conjugate of b; at rest exactly (0, 0, 0, w).
            float x = (a.X * b.W) - (a.W * b.X) + ((a.Z * b.Y) - (a.Y * b.Z));
            float y = (a.Y * b.W) - (a.W * b.Y) + ((a.X * b.Z) - (a.Z * b.X));
            float z = (a.Z * b.W) - (a.W * b.Z) + ((a.Y * b.X) - (a.X * b.Y));
            float w = (a.W * b.W) + (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);
            float m11 = 1f - (2f * ((y * y) + (z * z)));
            float m12 = 2f * ((x * y) + (w * z));
            float m13 = 2f * ((x * z) - (w * y));
            float m21 = 2f * ((x * y) - (w * z));
            float m22 = 1f - (2f * ((x * x) + (z * z)));
            float m23 = 2f * ((y * z) + (w * x));
            float m31 = 2f * ((x * z) + (w * y));
            float m32 = 2f * ((y * z) - (w * x));
            float m33 = 1f - (2f * ((x * x) + (y * y)));
            matrices[i] = new Matrix4x4(
                m11, m12, m13, 0f,
                m21, m22, m23, 0f,
                m31, m32, m33, 0f,
                p.X - ((o.X * m11) + (o.Y * m21) + (o.Z * m31)),
                p.Y - ((o.X * m12) + (o.Y * m22) + (o.Z * m32)),
                p.Z - ((o.X * m13) + (o.Y * m23) + (o.Z * m33)),
                1f);
        }
    }
}
