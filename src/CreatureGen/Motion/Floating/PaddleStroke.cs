namespace CreatureGen.Motion.Floating;

/// <summary>The moment of a body that paddles.</summary>
internal struct PaddleStroke
{
    /// <summary>Place in the cycle, 0..1.</summary>
    public double Phase;

    /// <summary>How far legs go to and fro, 1 at cruise.</summary>
    public float Width;

    /// <summary>Turn to the left, 1 for the sharpest.</summary>
    public float Steer;

    /// <summary>How far legs reach for the ground that comes up under them, 0..1: at 1 it is as it stands.</summary>
    public float Reach;
}
