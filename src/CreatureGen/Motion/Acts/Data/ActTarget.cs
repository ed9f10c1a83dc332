using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What an act goes for. The default is what suits the creature: ahead of it for strikes, the ground ahead for eating.</summary>
public readonly struct ActTarget : IEquatable<ActTarget>
{
    private readonly Vector3 point;

    private ActTarget(Vector3 point)
    {
        this.point = point;
        IsPoint = true;
    }

    /// <summary>What suits the creature.</summary>
    public static ActTarget Usual => default;

    /// <summary>Whether it is a point of the world.</summary>
    public bool IsPoint { get; }

    /// <summary>The point, world space, metres; null for what suits the creature.</summary>
    public Vector3? Point => IsPoint ? point : null;

    /// <summary>A point of the world.</summary>
    /// <exception cref="ArgumentException">The point is not finite, or farther than 10¹² m along an axis.</exception>
    public static ActTarget At(Vector3 point)
    {
        Finite.RequireWithin(point, RootPlace.Farthest, nameof(point));
        return new ActTarget(point);
    }

    /// <summary>Whether both are the same.</summary>
    public static bool operator ==(ActTarget left, ActTarget right) => left.Equals(right);

    /// <summary>Whether they differ.</summary>
    public static bool operator !=(ActTarget left, ActTarget right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(ActTarget other) => IsPoint == other.IsPoint && point == other.point;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is ActTarget other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => point.GetHashCode();
}
