using System.Numerics;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Where a leg has to bring its foot. Model space.</summary>
internal struct FootPose
{
    /// <summary>The ball's joint.</summary>
    public Vector3 Ball;

    /// <summary>What the two solved parts have to reach: the ball, or the ankle of legs whose foot has its own angle.</summary>
    public Vector3 Target;

    /// <summary>Turn of the foot from rest, ankle to ball.</summary>
    public Quaternion Foot;

    /// <summary>Turn of the toes from rest.</summary>
    public Quaternion Toes;

    /// <summary>Fold of the metatarsus, radians.</summary>
    public float Fold;

    /// <summary>Brings it farther, metres; turned as it is.</summary>
    public void MoveBy(Vector3 way)
    {
        Ball += way;
        Target += way;
    }
}
