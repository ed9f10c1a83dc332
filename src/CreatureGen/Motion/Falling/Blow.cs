using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Falling;

/// <summary>A blow that the next update tells of.</summary>
/// <param name="Joint">Skeleton index; −1 for none.</param>
/// <param name="Impulse">World N·s.</param>
/// <param name="Strength">Change of the body's speed, √(gℓ).</param>
internal readonly record struct Blow(int Joint, Vector3 Impulse, float Strength)
{
    /// <summary>No blow.</summary>
    public static Blow None => new(-1, Vector3.Zero, 0f);
}

/// <summary>How a blow carries off a body in air or water, which slows it down.</summary>
internal struct Drift
{
    /// <summary>How quickly, 1/τ with τ = √(ℓ/g).</summary>
    private const float Rate = 1f;

    /// <summary>Metres per second below which it is over.</summary>
    private const float Over = 1e-4f;

    private Vector3 velocity;

    /// <summary>Whether nothing carries it off.</summary>
    public readonly bool IsOver => velocity == Vector3.Zero;

    /// <summary>Pushes it, world m/s.</summary>
    public void Push(Vector3 change) => velocity += change;

    /// <summary>Carries it on.</summary>
    /// <param name="place">Where it is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public RootPlace Carry(in RootPlace place, float dt, float tau)
    {
        if (IsOver)
        {
            return place;
        }

        Vector3 way = velocity * Damping.Integral(Rate / tau, dt);
        velocity *= Damping.Left(Rate / tau, dt);
        velocity = Vec.LengthSquared(velocity) < Over * Over ? Vector3.Zero : velocity;
        return new RootPlace(place.Position + way, place.Rotation, place.Scale);
    }
}
