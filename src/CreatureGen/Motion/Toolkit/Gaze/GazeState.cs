using System.Numerics;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where a head and a pair of eyes are on their way: a value to keep per creature. The default value looks straight ahead and at nothing.</summary>
public struct GazeState
{
    /// <summary>From model space to the trunk, as of the last update.</summary>
    internal Quaternion ToTrunk;
    internal float Yaw;
    internal float Pitch;
    internal float YawVelocity;
    internal float PitchVelocity;
    internal float Attention;
    internal float AttentionVelocity;
    internal float EyeYaw;
    internal float EyePitch;

    /// <summary>Where the head points or is on its way to, relative to the trunk that carries the neck.</summary>
    public readonly LookAngles Angles => new(Yaw, Pitch);

    /// <summary>How far the head has taken up its target, 0..1.</summary>
    public readonly float Weight => Attention;
}
