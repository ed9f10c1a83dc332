using System;
using System.Numerics;

namespace CreatureGen.Gltf;

/// <summary>The one form in which the writer refuses a creature. It never repairs one.</summary>
internal static class ExportError
{
    /// <summary>The exception that says where the defect is, what it is, and what was expected.</summary>
    public static InvalidOperationException At(string where, string what, string expected) =>
        new("the creature cannot be written: " + where + ": " + what + "; expected " + expected);

    /// <summary>A vector in a message.</summary>
    public static string Text(Vector3 v) => FormattableString.Invariant($"({v.X}, {v.Y}, {v.Z})");

    /// <summary>Four numbers in a message.</summary>
    public static string Text(Vector4 v) => FormattableString.Invariant($"({v.X}, {v.Y}, {v.Z}, {v.W})");

    /// <summary>A rotation in a message.</summary>
    public static string Text(Quaternion q) => FormattableString.Invariant($"({q.X}, {q.Y}, {q.Z}, {q.W})");
}
