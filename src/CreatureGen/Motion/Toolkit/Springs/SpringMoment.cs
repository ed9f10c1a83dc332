using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>A spring bone at one moment within the frame. World axes, from the creature's place.</summary>
internal struct SpringMoment
{
    /// <summary>Turn from the animated to the simulated rotation.</summary>
    public Quaternion Deviation;

    /// <summary>Simulated place of its joint.</summary>
    public Vector3 Place;

    /// <summary>Animated place of its joint.</summary>
    public Vector3 Animated;
}
