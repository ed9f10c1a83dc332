namespace CreatureGen.GodotAddon;

/// <summary>The library's space is Godot's; only the types differ.</summary>
public static class GodotSpace
{
    public static Godot.Vector3 Point(System.Numerics.Vector3 v) => new Godot.Vector3(v.X, v.Y, v.Z);

    public static System.Numerics.Vector3 Point(Godot.Vector3 v) => new System.Numerics.Vector3(v.X, v.Y, v.Z);

    /// <summary>A matrix for row vectors as Godot's columns and origin.</summary>
    public static Godot.Transform3D Transform(in System.Numerics.Matrix4x4 m) => new Godot.Transform3D(
        new Godot.Vector3(m.M11, m.M12, m.M13),
        new Godot.Vector3(m.M21, m.M22, m.M23),
        new Godot.Vector3(m.M31, m.M32, m.M33),
        new Godot.Vector3(m.M41, m.M42, m.M43));
}
