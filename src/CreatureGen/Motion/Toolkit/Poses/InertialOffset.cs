using System.Numerics;
using CreatureGen.Motion.Toolkit.Poses;

namespace CreatureGen.Motion.Toolkit;

/// <summary>What one joint still has of the motion before a transition: a turn and a shift, each dying away. See <see cref="Inertialisation"/>.</summary>
public readonly struct InertialOffset
{
    private readonly FadingVector turn;
    private readonly FadingVector shift;

    internal InertialOffset(in FadingVector turn, in FadingVector shift)
    {
        this.turn = turn;
        this.shift = shift;
    }

    /// <summary>The turn left at a time: its axis times its angle, in the parent's space.</summary>
    internal Vector3 TurnAt(float time) => turn.At(time);

    /// <summary>The shift left at a time, in the parent's space.</summary>
    internal Vector3 ShiftAt(float time) => shift.At(time);
}
