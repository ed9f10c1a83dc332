using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>Where the animation has a bone. World axes, from the creature's place.</summary>
internal struct SpringAim
{
    /// <summary>Place of its joint.</summary>
    public Vector3 Position;

    /// <summary>Direction to its tip, unit.</summary>
    public Vector3 Along;
}
