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
        Fill(skeleton.ModelRotations, skeleton.ModelPositions, model, matrices);
    }

    /// <summary>The same for skin that was bound in another pose than the skeleton's rest pose.</summary>
    /// <param name="bindRotations">Rotation of each joint in the space in which the skin was bound, unit.</param>
    /// <param name="bindPositions">Position of each joint there, metres.</param>
    /// <param name="model">The pose in model space.</param>
    /// <param name="matrices">Receives one matrix per joint, for row vectors.</param>
    /// <exception cref="ArgumentException">Spans differ in length.</exception>
    public static void Fill(ReadOnlySpan<Quaternion> bindRotations, ReadOnlySpan<Vector3> bindPositions, in Pose model, Span<Matrix4x4> matrices)
    {
        int count = model.Rotations.Length;
        if (matrices.Length != count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{matrices.Length} matrices; expected one for each of the {count} joints"), nameof(matrices));
        }

        if (bindRotations.Length != count || bindPositions.Length != count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{bindRotations.Length} rotations and {bindPositions.Length} positions of bound joints; expected one of each for the {count} joints"), nameof(bindRotations));
        }

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

    /// <summary>Fills in one matrix per joint that carries model space at rest into the joint's space: its inverse bind matrix.</summary>
    /// <param name="skeleton">Its rest pose is the bind pose.</param>
    /// <param name="matrices">Receives one matrix per joint, for row vectors (v · M, translation in the fourth row). In memory this is also a matrix for column vectors stored column by column, as OpenGL and glTF have it.</param>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    /// <exception cref="ArgumentException">There is not one matrix for each joint.</exception>
    public static void FillInverseBinds(Skeleton skeleton, Span<Matrix4x4> matrices)
    {
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        if (matrices.Length != skeleton.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{matrices.Length} matrices; expected one for each of the {skeleton.Count} joints"), nameof(matrices));
        }

        for (int i = 0; i < matrices.Length; i++)
        {
            matrices[i] = Inverse(skeleton.ModelRotations[i], skeleton.ModelPositions[i]);
        }
    }

    /// <summary>The inverse of a turn, of any length but zero, and a move, worked out in double precision.</summary>
    private static Matrix4x4 Inverse(Quaternion rotation, Vector3 position)
    {
        double x = rotation.X;
        double y = rotation.Y;
        double z = rotation.Z;
        double w = rotation.W;
        double s = 2.0 / ((x * x) + (y * y) + (z * z) + (w * w));
        double xx = 1.0 - (s * ((y * y) + (z * z)));
        double xy = s * ((x * y) + (w * z));
        double xz = s * ((x * z) - (w * y));
        double yx = s * ((x * y) - (w * z));
        double yy = 1.0 - (s * ((x * x) + (z * z)));
        double yz = s * ((y * z) + (w * x));
        double zx = s * ((x * z) + (w * y));
        double zy = s * ((y * z) - (w * x));
        double zz = 1.0 - (s * ((x * x) + (y * y)));
        double px = position.X;
        double py = position.Y;
        double pz = position.Z;
        return new Matrix4x4(
            (float)xx,
            (float)yx,
            (float)zx,
            0f,
            (float)xy,
            (float)yy,
            (float)zy,
            0f,
            (float)xz,
            (float)yz,
            (float)zz,
            0f,
            (float)-((xx * px) + (xy * py) + (xz * pz)),
            (float)-((yx * px) + (yy * py) + (yz * pz)),
            (float)-((zx * px) + (zy * py) + (zz * pz)),
            1f);
    }
}
