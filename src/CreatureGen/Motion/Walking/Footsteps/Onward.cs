using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How the body goes on from a moment until feet are decided on again: found once for all its feet, for it costs as much as a foot does.</summary>
internal readonly struct Onward
{
    private readonly Quaternion turn;
    private readonly Vector3 way;
    private readonly bool goes;

    private Onward(Quaternion turn, Vector3 way)
    {
        this.turn = turn;
        this.way = way;
        goes = true;
    }

    /// <summary>From a moment on; not at all if the next decision comes before the next pose.</summary>
    public static Onward From(in StepContext step)
    {
        if (step.Left >= DecisionClock.Period)
        {
            return default;
        }

        Vector3 way = step.RootVelocity.Predict(DecisionClock.Period, out float yaw);
        return new Onward(AxisRotation.Yaw(-yaw), way);
    }

    /// <summary>Where a place of the world is then, model space.</summary>
    /// <param name="place">Where it is now, model space.</param>
    public Vector3 Later(Vector3 place) => goes ? Rotation.Rotate(turn, place - way) : place;
}
