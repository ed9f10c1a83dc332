using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The axis about which a joint folds, read from its limits: knees about local X, elbows of wings about local Z, in the direction in which they turn farthest.</summary>
public static class HingeAxis
{
    /// <summary>Unit axis in the joint's own space; a turn about it by a positive angle folds the joint.</summary>
    public static Vector3 Of(JointLimit limit)
    {
        float min = -limit.SwingX.Min;
        float max = limit.SwingX.Max;
        Vector3 axis = max >= min ? Vector3.UnitX : -Vector3.UnitX;
        float widest = max >= min ? max : min;
        if (-limit.SwingZ.Min > widest)
        {
            axis = -Vector3.UnitZ;
            widest = -limit.SwingZ.Min;
        }

        return limit.SwingZ.Max > widest ? Vector3.UnitZ : axis;
    }
}
