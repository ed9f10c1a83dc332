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
            ref readonly Quaternion a = ref rotations[i];
            ref readonly Quaternion b = ref bindRotations[i];
            ref readonly Vector3 p = ref positions[i];
            ref readonly Vector3 o = ref bindPositions[i];
            float ax = a.X;
            float ay = a.Y;
            float az = a.Z;
            float aw = a.W;
            float bx = b.X;
            float by = b.Y;
            float bz = b.Z;
            float bw = b.W;

            // a times the conjugate of b; at rest exactly (0, 0, 0, w).
            float x = (ax * bw) - (aw * bx) + ((az * by) - (ay * bz));
            float y = (ay * bw) - (aw * by) + ((ax * bz) - (az * bx));
            float z = (az * bw) - (aw * bz) + ((ay * bx) - (ax * by));
            float w = (aw * bw) + (ax * bx) + (ay * by) + (az * bz);
            float m11 = 1f - (2f * ((y * y) + (z * z)));
            float m12 = 2f * ((x * y) + (w * z));
            float m13 = 2f * ((x * z) - (w * y));
            float m21 = 2f * ((x * y) - (w * z));
            float m22 = 1f - (2f * ((x * x) + (z * z)));
            float m23 = 2f * ((y * z) + (w * x));
            float m31 = 2f * ((x * z) + (w * y));
            float m32 = 2f * ((y * z) - (w * x));
            float m33 = 1f - (2f * ((x * x) + (y * y)));
            float ox = o.X;
            float oy = o.Y;
            float oz = o.Z;
            ref Matrix4x4 m = ref matrices[i];
            m.M11 = m11;
            m.M12 = m12;
            m.M13 = m13;
            m.M14 = 0f;
            m.M21 = m21;
            m.M22 = m22;
            m.M23 = m23;
            m.M24 = 0f;
            m.M31 = m31;
            m.M32 = m32;
            m.M33 = m33;
            m.M34 = 0f;
            m.M41 = p.X - ((ox * m11) + (oy * m21) + (oz * m31));
            m.M42 = p.Y - ((ox * m12) + (oy * m22) + (oz * m32));
            m.M43 = p.Z - ((ox * m13) + (oy * m23) + (oz * m33));
            m.M44 = 1f;
        }
    }
}
