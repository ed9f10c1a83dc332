using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Engines;

/// <summary>
/// How an engine counts: which way its axes point, how long its unit is, which side of a triangle is its front, where its textures begin and how its matrices lie in memory; and what of a creature becomes of that.
/// </summary>
/// <remarks>
/// <para>The library counts right-handed, +Y up, +Z ahead, +X to the creature's left, in metres, with counter-clockwise front faces.</para>
/// <para>Front faces are told as they are seen: a change of handedness alone turns no triangle over, since the engine also shows its numbers the other way round. Immutable, and safe to share between threads.</para>
/// </remarks>
public sealed class EngineAxes
{
    /// <summary>1, or −1 for a left-handed engine.</summary>
    private readonly float handedness;

    /// <summary>Describes an engine.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="left">The creature's left (+X) in the engine: one of its axes or the opposite of one.</param>
    /// <param name="up">The creature's up (+Y) in the engine.</param>
    /// <param name="ahead">The creature's front (+Z) in the engine.</param>
    /// <param name="unitsPerMetre">Units of length in a metre, 0.0001 to 10 000.</param>
    /// <exception cref="ArgumentNullException">There is no name.</exception>
    /// <exception cref="ArgumentException">The three directions are not three different axes, or the unit is out of its range.</exception>
    public EngineAxes(string name, Vector3 left, Vector3 up, Vector3 ahead, float unitsPerMetre = 1f)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        RequireAxis(left, nameof(left));
        RequireAxis(up, nameof(up));
        RequireAxis(ahead, nameof(ahead));
        handedness = Vec.Dot(Vec.Cross(left, up), ahead);
        if (handedness == 0f)
        {
            throw new ArgumentException("left, up and ahead share an axis; expected three different ones", nameof(ahead));
        }

        Finite.RequireWithin(unitsPerMetre, 1e-4f, 1e4f, nameof(unitsPerMetre));
        Left = left;
        Up = up;
        Ahead = ahead;
        UnitsPerMetre = unitsPerMetre;
    }

    /// <summary>Unity: left-handed, +Y up, +Z ahead.</summary>
    public static EngineAxes Unity { get; } = new("Unity", -Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ) { FrontFace = FrontFace.Clockwise, TextureOrigin = TextureOrigin.BottomLeft };

    /// <summary>Godot 3 and 4: right-handed, +Y up. The creature faces +Z, which Godot 4 names <c>MODEL_FRONT</c>; nodes and cameras look along −Z.</summary>
    public static EngineAxes Godot { get; } = new("Godot", Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ) { FrontFace = FrontFace.Clockwise };

    /// <summary>Unreal: left-handed, +Z up, +X ahead, centimetres.</summary>
    public static EngineAxes Unreal { get; } = new("Unreal", -Vector3.UnitY, Vector3.UnitZ, Vector3.UnitX, 100f);

    /// <summary>MonoGame, FNA and KNI: right-handed, +Y up, −Z ahead (<c>Vector3.Forward</c>).</summary>
    public static EngineAxes MonoGame { get; } = new("MonoGame", -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitZ) { FrontFace = FrontFace.Clockwise };

    /// <summary>Stride: right-handed, +Y up, −Z ahead.</summary>
    public static EngineAxes Stride { get; } = new("Stride", -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitZ) { FrontFace = FrontFace.Clockwise, MatrixMemory = MatrixMemory.Transposed };

    /// <summary>raylib: as the library. Pictures are uploaded with their top row first.</summary>
    public static EngineAxes Raylib { get; } = new("raylib", Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ);

    /// <summary>three.js: as the library, with <c>flipY = false</c> on textures.</summary>
    public static EngineAxes ThreeJs { get; } = new("three.js", Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ);

    /// <summary>The engines that are known by name.</summary>
    public static IReadOnlyList<EngineAxes> All { get; } = new[] { Unity, Godot, Unreal, MonoGame, Stride, Raylib, ThreeJs };

    /// <summary>Name of the engine.</summary>
    public string Name { get; }

    /// <summary>The creature's left (+X) in the engine, a unit vector along one of its axes.</summary>
    public Vector3 Left { get; }

    /// <summary>The creature's up (+Y) in the engine.</summary>
    public Vector3 Up { get; }

    /// <summary>The creature's front (+Z) in the engine.</summary>
    public Vector3 Ahead { get; }

    /// <summary>Units of length in a metre.</summary>
    public float UnitsPerMetre { get; }

    /// <summary>Whether the engine is left-handed.</summary>
    public bool IsLeftHanded => handedness < 0f;

    /// <summary>The order of a triangle's corners.</summary>
    public FrontFace FrontFace { get; init; }

    /// <summary>Where texture coordinates begin.</summary>
    public TextureOrigin TextureOrigin { get; init; }

    /// <summary>How matrices lie in memory.</summary>
    public MatrixMemory MatrixMemory { get; init; }

    /// <summary>A point or a way, in the engine's units: also of root motion, sockets and ground contacts.</summary>
    public Vector3 Point(Vector3 metres) => Direction(metres) * UnitsPerMetre;

    /// <summary>A direction, such as a normal: its length stays.</summary>
    public Vector3 Direction(Vector3 d) => (Left * d.X) + (Up * d.Y) + (Ahead * d.Z);

    /// <summary>A rotation: what it turns in the library, the result turns in the engine. Components in the order x, y, z, w.</summary>
    public Quaternion Rotation(Quaternion q)
    {
        // A mirror turns the sense of rotation round.
        Vector3 axis = Direction(new Vector3(q.X, q.Y, q.Z)) * handedness;
        return new Quaternion(axis.X, axis.Y, axis.Z, q.W);
    }

    /// <summary>A tangent with the side of the third axis in w, so that w · (normal × tangent), as the engine multiplies, points up the picture: normal maps with green up, as <c>CreatureTextures</c> bakes them, need no change.</summary>
    public Vector4 Tangent(Vector4 tangent)
    {
        Vector3 direction = Direction(new Vector3(tangent.X, tangent.Y, tangent.Z));
        return new Vector4(direction, tangent.W * handedness);
    }

    /// <summary>Texture coordinates.</summary>
    public Vector2 Texcoord(Vector2 texcoord) => TextureOrigin == TextureOrigin.BottomLeft ? new Vector2(texcoord.X, 1f - texcoord.Y) : texcoord;

    /// <summary>A matrix of rotation and translation, such as a bind matrix or one of <see cref="Skinning.SkinMatrices"/>: its bytes are those of the engine's own type of 16 floats.</summary>
    /// <param name="m">For row vectors: v · M, translation in metres in the fourth row.</param>
    public Matrix4x4 Matrix(in Matrix4x4 m)
    {
        // The rows are where the library's axes go to; the engine's axes are, but for their signs, other ones of them.
        Vector3 x = Direction(new Vector3(m.M11, m.M12, m.M13));
        Vector3 y = Direction(new Vector3(m.M21, m.M22, m.M23));
        Vector3 z = Direction(new Vector3(m.M31, m.M32, m.M33));
        Vector3 ex = (x * Left.X) + (y * Up.X) + (z * Ahead.X);
        Vector3 ey = (x * Left.Y) + (y * Up.Y) + (z * Ahead.Y);
        Vector3 ez = (x * Left.Z) + (y * Up.Z) + (z * Ahead.Z);
        Vector3 o = Point(new Vector3(m.M41, m.M42, m.M43));
        return MatrixMemory == MatrixMemory.Transposed
            ? new Matrix4x4(ex.X, ey.X, ez.X, o.X, ex.Y, ey.Y, ez.Y, o.Y, ex.Z, ey.Z, ez.Z, o.Z, 0f, 0f, 0f, 1f)
            : new Matrix4x4(ex.X, ex.Y, ex.Z, 0f, ey.X, ey.Y, ey.Z, 0f, ez.X, ez.Y, ez.Z, 0f, o.X, o.Y, o.Z, 1f);
    }

    /// <summary>A pose, in the parents' space or in model space, the same in the result. Nothing is allocated.</summary>
    /// <exception cref="ArgumentException">The poses differ in length.</exception>
    public void Convert(in Pose pose, in Pose destination)
    {
        RequireLength(destination.Rotations.Length, pose.Rotations.Length, "joints", nameof(destination));
        for (int i = 0; i < pose.Rotations.Length; i++)
        {
            destination.Rotations[i] = Rotation(pose.Rotations[i]);
            destination.Positions[i] = Point(pose.Positions[i]);
        }
    }

    /// <summary>Corners of triangles in the engine's order. Nothing is allocated.</summary>
    /// <exception cref="ArgumentException">The spans differ in length, or that is no multiple of 3.</exception>
    public void Convert(ReadOnlySpan<int> triangles, Span<int> destination)
    {
        RequireTriangles(triangles.Length, destination.Length);
        int second = FrontFace == FrontFace.Clockwise ? 2 : 1;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            destination[t] = triangles[t];
            destination[t + second] = triangles[t + 1];
            destination[t + 3 - second] = triangles[t + 2];
        }
    }

    /// <summary>Corners of triangles in the engine's order, 16 bits each. Nothing is allocated.</summary>
    /// <exception cref="ArgumentException">The spans differ in length, that is no multiple of 3, or an index is beyond 65 535.</exception>
    public void Convert(ReadOnlySpan<int> triangles, Span<ushort> destination)
    {
        RequireTriangles(triangles.Length, destination.Length);
        int second = FrontFace == FrontFace.Clockwise ? 2 : 1;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            destination[t] = Short(triangles[t]);
            destination[t + second] = Short(triangles[t + 1]);
            destination[t + 3 - second] = Short(triangles[t + 2]);
        }
    }

    /// <summary>The name.</summary>
    public override string ToString() => Name;

    /// <summary>Throws unless a caller's span has one entry for each thing.</summary>
    internal static void RequireLength(int length, int expected, string things, string name)
    {
        if (length != expected)
        {
            throw new ArgumentException(FormattableString.Invariant($"{length} entries; expected {expected}, one for each of the {things}"), name);
        }
    }

    private static void RequireTriangles(int triangles, int destination)
    {
        RequireLength(destination, triangles, "corners", nameof(destination));
        if (triangles % 3 != 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"{triangles} corners; expected three for each triangle"), nameof(triangles));
        }
    }

    private static ushort Short(int index) => (uint)index <= ushort.MaxValue
        ? (ushort)index
        : throw new ArgumentException(FormattableString.Invariant($"vertex {index} of a triangle; expected 0..{ushort.MaxValue} in 16 bits"));

    private static void RequireAxis(Vector3 d, string name)
    {
        Vector3 a = d * d;
        if (a != Vector3.UnitX && a != Vector3.UnitY && a != Vector3.UnitZ)
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} = ({d.X}, {d.Y}, {d.Z}); expected an axis of the engine or the opposite of one, such as (0, 0, -1)"), name);
        }
    }
}
