using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>
/// The other direction of root motion: the game moves the creature, and its velocity is read off its places, smoothed, for the animation to follow. A value to keep per creature. Nothing is allocated.
/// For clips and rigs of one's own: <see cref="CreatureAnimator.Follow"/> does it for grown creatures.
/// </summary>
public struct PushedRoot
{
    private RootPlace last;
    private Vector3 measured;
    private float measuredTurn;
    private Vector3 velocity;
    private float yawRate;
    private bool started;

    /// <summary>The smoothed velocity, in the creature's axes at its size: model metres per second.</summary>
    public readonly BodyVelocity Velocity => new(velocity, yawRate);

    /// <summary>Takes the creature's place after a step.</summary>
    /// <param name="place">Where the game has put it.</param>
    /// <param name="rate">s⁻¹ of the smoothing; about 15 takes out the jitter of physics steps.</param>
    /// <param name="seconds">Time since the last place; 0 changes nothing but the place.</param>
    /// <param name="teleportDistance">World metres in one step beyond which the creature was put elsewhere: its velocity stays what it was.</param>
    /// <returns>The smoothed velocity.</returns>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public BodyVelocity Observe(in RootPlace place, float rate, float seconds, float teleportDistance = 5f)
    {
        place.Require(nameof(place));
        Finite.RequireStep(seconds);
        Finite.RequireWithin(rate, 0f, 1e6f, nameof(rate));
        Finite.RequireWithin(teleportDistance, 0f, float.MaxValue, nameof(teleportDistance));
        if (started && seconds > 1e-5f && Vec.Distance(place.Position, last.Position) <= teleportDistance)
        {
            // Measured in the axes half way through the step, which a steady curve has on average.
            Quaternion turned = Rotation.Multiply(Rotation.Inverse(last.Rotation), place.Rotation);
            Rotation.SwingTwist(turned, Vector3.UnitY, out _, out Quaternion yaw);
            Quaternion middle = Rotation.Nlerp(last.Rotation, place.Rotation, 0.5);
            Vector3 now = Rotation.Rotate(Rotation.Inverse(middle), place.Position - last.Position) / (seconds * place.Scale);
            float turnNow = (float)(2 * PortableMath.Atan2(yaw.Y, yaw.W)) / seconds;
            velocity = Damping.Follow(velocity, measured, now, rate, seconds);
            yawRate = Damping.Follow(yawRate, measuredTurn, turnNow, rate, seconds);
            measured = now;
            measuredTurn = turnNow;
        }

        last = place;
        started = true;
        return Velocity;
    }

    /// <summary>Tells that the world's origin was moved, so that all positions changed by an offset and nothing else did.</summary>
    /// <param name="offset">Added to every position of the world, metres.</param>
    /// <exception cref="ArgumentException">The offset is not finite.</exception>
    public void Rebase(Vector3 offset)
    {
        Finite.Require(offset, nameof(offset));
        if (started)
        {
            last = new RootPlace(last.Position + offset, last.Rotation, last.Scale);
        }
    }
}
