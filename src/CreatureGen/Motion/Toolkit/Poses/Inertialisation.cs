using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Transitions without a second motion: at the switch, the difference between what was shown and what comes next is kept, joint by joint with its velocity, and dies away on top of the
/// new motion. Only the new motion is evaluated, and neither place nor speed of any joint jumps. Nothing is allocated.
/// </summary>
/// <remarks>
/// Based on: D. Bollo, "Inertialization: high-performance animation transitions in Gears of War" (GDC 2018). Unlike there, the velocity kept is that of the difference (shown less new
/// motion), and whole vectors
/// are kept rather than one axis, so that the sum has exactly the velocity that was shown.
/// </remarks>
public static class Inertialisation
{
    private const float MinAngle = 1e-5f;
    private const float MinShift = 1e-7f;

    /// <summary>Notes what has to die away.</summary>
    /// <param name="shown">The local pose shown last, transitions included.</param>
    /// <param name="shownBefore">The one shown a step earlier.</param>
    /// <param name="next">The new motion at the moment of <paramref name="shown"/>.</param>
    /// <param name="nextBefore">The new motion a step earlier; <paramref name="next"/> again if it has no past.</param>
    /// <param name="step">Seconds between them; 0 when there is no earlier pose.</param>
    /// <param name="duration">Seconds until all is gone; about 0.2 to 0.5 looks natural.</param>
    /// <param name="offsets">Receives one entry per joint.</param>
    /// <exception cref="ArgumentException">Poses or offsets differ in length, or a number is not finite.</exception>
    public static void Start(in Pose shown, in Pose shownBefore, in Pose next, in Pose nextBefore, float step, float duration, Span<InertialOffset> offsets)
    {
        Finite.RequireStep(step);
        Finite.RequireStep(duration);
        PoseCheck.SameLength(shown, shownBefore);
        PoseCheck.SameLength(shown, next);
        PoseCheck.SameLength(shown, nextBefore);
        RequireLength(offsets.Length, shown.Rotations.Length);
        float perSecond = step > 0f ? 1f / step : 0f;
        float nought = 0f;
        for (int i = 0; i < offsets.Length; i++)
        {
            Vector3 turn = Vector(Rotation.Multiply(shown.Rotations[i], Rotation.Inverse(next.Rotations[i])), Vector3.Zero);
            Vector3 turnBefore = Vector(Rotation.Multiply(shownBefore.Rotations[i], Rotation.Inverse(nextBefore.Rotations[i])), turn);
            Vector3 shift = shown.Positions[i] - next.Positions[i];
            Vector3 shiftBefore = shownBefore.Positions[i] - nextBefore.Positions[i];
            nought += (Vec.Dot(turn, turnBefore) + Vec.Dot(shift, shiftBefore)) * 0f;
            offsets[i] = new InertialOffset(
                new FadingVector(turn, (turn - turnBefore) * perSecond, duration, MinAngle),
                new FadingVector(shift, (shift - shiftBefore) * perSecond, duration, MinShift));
        }

        if (nought != 0f)
        {
            PoseCheck.Refuse(shown, ReadOnlySpan<float>.Empty);
            PoseCheck.Refuse(shownBefore, ReadOnlySpan<float>.Empty);
            PoseCheck.Refuse(next, ReadOnlySpan<float>.Empty);
            PoseCheck.Refuse(nextBefore, ReadOnlySpan<float>.Empty);
        }
    }

    /// <summary>Lays what is left on the new motion.</summary>
    /// <param name="offsets">From <see cref="Start"/>; none of them does anything if they were never started.</param>
    /// <param name="elapsed">Seconds since the start.</param>
    /// <param name="pose">The new motion's local pose, changed in place.</param>
    /// <exception cref="ArgumentException">The offsets are not as many as the joints, or the time is negative or not finite.</exception>
    public static void Apply(ReadOnlySpan<InertialOffset> offsets, float elapsed, in Pose pose)
    {
        Finite.RequireStep(elapsed);
        RequireLength(offsets.Length, pose.Rotations.Length);
        for (int i = 0; i < offsets.Length; i++)
        {
            ref readonly InertialOffset offset = ref offsets[i];
            Vector3 turn = offset.TurnAt(elapsed);
            float angle = Vec.Length(turn);
            if (angle > 0f)
            {
                pose.Rotations[i] = Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(turn / angle, angle), pose.Rotations[i]));
            }

            pose.Positions[i] += offset.ShiftAt(elapsed);
        }
    }

    private static void RequireLength(int offsets, int joints)
    {
        if (offsets != joints)
        {
            throw new ArgumentException(FormattableString.Invariant($"{offsets} offsets; expected {joints}, one per joint"), nameof(offsets));
        }
    }

    /// <summary>Axis times angle of a rotation: of all that differ by whole turns, the one nearest to <paramref name="near"/>.</summary>
    private static Vector3 Vector(Quaternion q, Vector3 near)
    {
        Vector3 v = new(q.X, q.Y, q.Z);
        float length = Vec.Length(v);
        if (length <= float.Epsilon)
        {
            return Finite.Is(q) ? Vector3.Zero : new Vector3(float.NaN);
        }

        Vector3 axis = v / length;
        double angle = 2 * PortableMath.Atan2(length, q.W);
        double turns = Math.Round((Vec.Dot(near, axis) - angle) / PortableMath.Tau);
        return axis * (float)(angle + (turns * PortableMath.Tau));
    }
}
