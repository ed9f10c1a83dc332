using System;
using System.Numerics;
using CreatureGen.Json;
using CreatureGen.Maths;

namespace CreatureGen.Gltf.Models;

/// <summary>A transform of the document as rotation, position and one factor of scale.</summary>
/// <param name="Rotation">Unit.</param>
/// <param name="Position">In the outer space.</param>
/// <param name="Scale">The same along all axes, above 0.</param>
internal readonly record struct NodePlace(Quaternion Rotation, Vector3 Position, float Scale)
{
    /// <summary>Most that scale may differ between axes, and axes be off a right angle, as a part of one: what exporters lose in rounding.</summary>
    private const float Slack = 2e-3f;

    /// <summary>The transform of a node, from its matrix or from its parts.</summary>
    public static NodePlace Of(JsonValue node)
    {
        Span<float> numbers = stackalloc float[16];
        if (ModelDocument.TryNumbers(node, "matrix", numbers))
        {
            return OfMatrix(numbers, node.Path);
        }

        Vector3 position = ModelDocument.TryNumbers(node, "translation", numbers.Slice(0, 3)) ? new Vector3(numbers[0], numbers[1], numbers[2]) : Vector3.Zero;
        Quaternion rotation = Quaternion.Identity;
        if (ModelDocument.TryNumbers(node, "rotation", numbers.Slice(0, 4)))
        {
            rotation = UnitOf(new Quaternion(numbers[0], numbers[1], numbers[2], numbers[3]), node.Path + ".rotation");
        }

        return ModelDocument.TryNumbers(node, "scale", numbers.Slice(0, 3))
            ? new NodePlace(rotation, position, Uniform(numbers[0], numbers[1], numbers[2], node.Path + ".scale"))
            : new NodePlace(rotation, position, 1f);
    }

    /// <summary>A matrix of 16 numbers, columns one after the other.</summary>
    public static NodePlace OfMatrix(ReadOnlySpan<float> m, string where)
    {
        var x = new Vector3(m[0], m[1], m[2]);
        var y = new Vector3(m[4], m[5], m[6]);
        var z = new Vector3(m[8], m[9], m[10]);
        float scale = Uniform(Vec.Length(x), Vec.Length(y), Vec.Length(z), where);
        x /= Vec.Length(x);
        y /= Vec.Length(y);
        z /= Vec.Length(z);
        bool square = Math.Abs(Vec.Dot(x, y)) < Slack && Math.Abs(Vec.Dot(y, z)) < Slack && Math.Abs(Vec.Dot(x, z)) < Slack;
        if (!square || Vec.Dot(Vec.Cross(x, y), z) < 0f)
        {
            throw new ModelFault(where, "a matrix that shears or mirrors", "rotation, translation and one factor of scale");
        }

        y = Vec.Normalize(Vec.Reject(y, x));
        return new NodePlace(Maths.Rotation.Normalize(Maths.Rotation.FromBasis(x, y, Vec.Cross(x, y))), new Vector3(m[12], m[13], m[14]), scale);
    }

    /// <summary>A quaternion at unit length.</summary>
    public static Quaternion UnitOf(Quaternion q, string where)
    {
        float squared = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
        return squared is > 0.25f and < 4f
            ? Maths.Rotation.Normalize(q)
            : throw new ModelFault(where, FormattableString.Invariant($"({q.X}, {q.Y}, {q.Z}, {q.W})"), "a quaternion of length 1");
    }

    /// <summary>One factor for three that are nearly equal.</summary>
    public static float Uniform(float x, float y, float z, string where)
    {
        float min = Math.Min(x, Math.Min(y, z));
        float max = Math.Max(x, Math.Max(y, z));
        return min > 0f && max <= min * (1f + Slack)
            ? (x + y + z) / 3f
            : throw new ModelFault(where, FormattableString.Invariant($"scale ({x}, {y}, {z})"), "the same scale along all axes, above 0");
    }
}
