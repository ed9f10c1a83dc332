using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>
/// Where the body of a creature is that a game moves: at the place that it is given, and behind it for a moment where that jumps or turns faster than legs bear. It catches up with bounded acceleration, so that a
/// shove moves the body on its feet instead of tearing these out from under it.
/// </summary>
internal struct PushedBody
{
    /// <summary>Greatest acceleration, parts of gravity: more than a creature moves itself with, so that it keeps up with a game that bounds its own.</summary>
    private const float Force = 1.5f;

    /// <summary>The same of turning, times the creature's own.</summary>
    private const float Turning = 4f;

    /// <summary>How quickly what is left is made up for, per second, and part of the speed from which it can still brake.</summary>
    private const float Rate = 8f;
    private const float BrakeFraction = 0.7f;

    /// <summary>Leg lengths from which on it was put elsewhere instead of pushed.</summary>
    private const float Farthest = 16f;

    private Vector3 behind;
    private Vector3 velocity;
    private float turned;
    private float turn;

    /// <summary>Whether it is not where it was put.</summary>
    public readonly bool IsBehind => behind != Vector3.Zero || turned != 0f;

    /// <summary>The body beside a place.</summary>
    /// <param name="goal">Where the creature was put.</param>
    public readonly RootPlace At(in RootPlace goal) => !IsBehind
        ? goal
        : new RootPlace(goal.Position + (behind * goal.Scale), UnitRotation.Renormalize(Rotation.Multiply(goal.Rotation, AxisRotation.Yaw(turned))), goal.Scale);

    /// <summary>Follows a place.</summary>
    /// <param name="before">Where the creature was put the last time.</param>
    /// <param name="goal">Where it is put now; its up is up.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="bounds">How quickly it changes its own motion.</param>
    /// <param name="gravity">Metres of the model per second squared.</param>
    /// <param name="legLength">Metres of the model.</param>
    /// <returns>Whether it follows; else it was put elsewhere, too far to be pushed.</returns>
    public bool Follow(in RootPlace before, in RootPlace goal, float dt, in VelocityBounds bounds, float gravity, float legLength)
    {
        Vector3 up = Rotation.Rotate(goal.Rotation, Vector3.UnitY);
        Vector3 went = Vec.Reject((goal.Position - before.Position) / goal.Scale, up);
        Vector3 left = went - Vec.Reject(behind, up);
        float distance = Vec.Length(left);
        Quaternion between = Rotation.Multiply(Rotation.Inverse(before.Rotation), goal.Rotation);
        float yawWent = 2f * FastTrigonometry.Of(between.W < 0f ? -between.Y : between.Y, Math.Abs(between.W));
        float yawLeft = yawWent - turned;
        if (distance > Farthest * legLength)
        {
            this = default;
            return false;
        }

        if (dt > 0f)
        {
            float change = Force * gravity * dt;
            Vector3 exact = left / dt;
            if (Vec.Length(exact - velocity) <= change)
            {
                velocity = exact;
                left = Vector3.Zero;
            }
            else
            {
                float catching = Math.Min(Rate * distance, BrakeFraction * (float)Math.Sqrt(2f * Force * gravity * distance));
                Vector3 wanted = (went / dt) + (left * (catching / Math.Max(distance, 1e-9f))) - velocity;
                velocity += wanted * Math.Min(1f, change / Vec.Length(wanted));
                left -= velocity * dt;
            }

            float swing = Turning * bounds.Yaw.Rise;
            float yawChange = swing * dt;
            if (Math.Abs((yawLeft / dt) - turn) <= yawChange)
            {
                turn = yawLeft / dt;
                yawLeft = 0f;
            }
            else
            {
                float catching = Math.Min(Rate * Math.Abs(yawLeft), BrakeFraction * (float)Math.Sqrt(2f * swing * Math.Abs(yawLeft)));
                float wanted = (yawWent / dt) + (yawLeft < 0f ? -catching : catching) - turn;
                turn += Scalar.Clamp(wanted, -yawChange, yawChange);
                yawLeft -= turn * dt;
            }
        }

        behind = -left;
        turned = -yawLeft;
        return true;
    }

    /// <summary>Shows the body where it is, in a pose that is seen from where the creature was put.</summary>
    /// <param name="goal">Where that is.</param>
    /// <param name="skeleton">Of the pose.</param>
    /// <param name="joint">The joint that carries the body.</param>
    /// <param name="local">The pose.</param>
    public readonly void Show(in RootPlace goal, Skeleton skeleton, int joint, in Pose local)
    {
        if (IsBehind)
        {
            RootFrame.Change(skeleton, joint, At(goal), goal, local);
        }
    }
}
