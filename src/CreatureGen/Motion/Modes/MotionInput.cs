using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Where a creature that can fly is to be. Others take no notice.</summary>
public enum MotionMedium
{
    /// <summary>On the ground, or in the water for swimmers.</summary>
    Ground,

    /// <summary>In the air.</summary>
    Air,
}

/// <summary>What a creature is asked to do until the next update: in its own axes, SI units. The default stands still.</summary>
/// <param name="Speed">Metres per second ahead; negative backs up; −10 000 to 10 000. A creature does what it can of it.</param>
/// <param name="YawRate">Radians per second about up; positive turns left; −1 000 to 1 000.</param>
/// <param name="Sideways">Metres per second to its left; −10 000 to 10 000.</param>
/// <param name="ClimbRate">Metres per second up, for swimmers and fliers; −10 000 to 10 000.</param>
/// <param name="Medium">Where a flier is to be.</param>
/// <param name="Escape">A change from <see cref="EscapeTurn.None"/> starts a C-start of a swimmer, which runs its course by itself; others take no notice.</param>
public readonly record struct MotionInput(float Speed, float YawRate = 0f, float Sideways = 0f, float ClimbRate = 0f, MotionMedium Medium = MotionMedium.Ground, EscapeTurn Escape = EscapeTurn.None)
{
    private const float Fastest = 1e4f;
    private const float FastestTurn = 1e3f;

    /// <summary>Whether it asks to go or to turn.</summary>
    internal bool Goes => Speed != 0f || Sideways != 0f || YawRate != 0f;

    /// <summary>Asks for a velocity, as <c>Seek</c> decides it: brought within the ranges above.</summary>
    /// <param name="velocity">World metres per second in the creature's axes; finite.</param>
    /// <param name="medium">Where a flier is to be.</param>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public static MotionInput From(in BodyVelocity velocity, MotionMedium medium = MotionMedium.Ground)
    {
        Finite.Require(velocity.Linear, nameof(velocity));
        Finite.Require(velocity.YawRate, nameof(velocity));
        return new MotionInput(Within(velocity.Linear.Z), Scalar.Clamp(velocity.YawRate, -FastestTurn, FastestTurn), Within(velocity.Linear.X), Within(velocity.Linear.Y), medium);

        static float Within(float speed) => Scalar.Clamp(speed, -Fastest, Fastest);
    }

    /// <summary>Throws unless all numbers are finite and in their ranges.</summary>
    internal void ThrowIfInvalid()
    {
        Finite.RequireWithin(Speed, -Fastest, Fastest, nameof(Speed));
        Finite.RequireWithin(YawRate, -FastestTurn, FastestTurn, nameof(YawRate));
        Finite.RequireWithin(Sideways, -Fastest, Fastest, nameof(Sideways));
        Finite.RequireWithin(ClimbRate, -Fastest, Fastest, nameof(ClimbRate));
    }
}
