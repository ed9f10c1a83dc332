using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Where a creature's model space, or a socket of it, is in the world: turned, grown by one factor, and moved.</summary>
public readonly struct RootPlace
{
    /// <summary>Metres from the origin along an axis: its square is still far from what single precision can hold.</summary>
    internal const float Farthest = 1e12f;

    /// <summary>Places a creature.</summary>
    /// <param name="position">Of the model's origin, world space, metres; at most 10¹² along each axis.</param>
    /// <param name="rotation">From model to world, unit.</param>
    /// <param name="scale">World metres per model metre, 10⁻⁶ to 10⁶.</param>
    /// <exception cref="ArgumentException">A number is not finite or out of its range, or the rotation is not a unit quaternion.</exception>
    public RootPlace(Vector3 position, Quaternion rotation, float scale = 1f)
    {
        Finite.RequireWithin(position, Farthest, nameof(position));
        Finite.RequireUnit(rotation, nameof(rotation));
        Finite.RequireWithin(scale, 1e-6f, 1e6f, nameof(scale));
        Position = position;
        Rotation = rotation;
        Scale = scale;
    }

    /// <summary>At the origin, unturned, at its own size.</summary>
    public static RootPlace Identity { get; } = new(Vector3.Zero, Quaternion.Identity);

    /// <summary>Of the model's origin, world space, metres.</summary>
    public Vector3 Position { get; }

    /// <summary>From model to world, unit.</summary>
    public Quaternion Rotation { get; }

    /// <summary>World metres per model metre.</summary>
    public float Scale { get; }

    /// <summary>A point of the model in the world.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 ToWorld(Vector3 model) => Position + Vec.Scale(Maths.Rotation.Rotate(Rotation, model), Scale);

    /// <summary>A point of the world in the model.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 ToModel(Vector3 world) => Vec.Divide(Maths.Rotation.Rotate(Maths.Rotation.Inverse(Rotation), world - Position), Scale);

    /// <summary>Whether a constructor made it.</summary>
    internal bool IsMade => Scale > 0f;

    /// <summary>Throws on a value that no constructor made.</summary>
    internal void Require(string name)
    {
        if (!IsMade)
        {
            throw new ArgumentException("a place without size; expected RootPlace.Identity or one made by its constructor", name);
        }
    }
}
