using System.Numerics;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How a foot lay that stood otherwise than it should, since its joints did not let it. In the axes of its foothold: their origin under the ball where it should stand, turned as it should be.</summary>
internal struct TurnedFoot
{
    /// <summary>Whether it stood so when its leg was last posed.</summary>
    public bool Stood;

    /// <summary>Turn of the foot from how it should lie.</summary>
    public Quaternion Foot;

    /// <summary>Turn of the toes from how they should lie.</summary>
    public Quaternion Toes;

    /// <summary>The ball's joint, metres.</summary>
    public Vector3 Ball;

    /// <summary>How far it has come away from its place by rolling from edge to edge, metres.</summary>
    public Vector3 Away;
}
