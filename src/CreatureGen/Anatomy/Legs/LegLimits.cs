namespace CreatureGen.Anatomy.Legs;

/// <summary>How far the joints of a leg or arm turn from rest.</summary>
internal sealed class LegLimits
{
    public LegLimits(JointRange hip, JointRange knee, JointRange ankle, JointRange ball)
    {
        Hip = hip;
        Knee = knee;
        Ankle = ankle;
        Ball = ball;
    }

    public JointRange Hip { get; }

    public JointRange Knee { get; }

    public JointRange Ankle { get; }

    public JointRange Ball { get; }
}

/// <summary>Angles of a joint about its axes, degrees, for the left side.</summary>
internal readonly struct JointRange
{
    public JointRange((int Min, int Max) swingX, (int Min, int Max) swingZ, (int Min, int Max) twist)
    {
        SwingX = swingX;
        SwingZ = swingZ;
        Twist = twist;
    }

    public (int Min, int Max) SwingX { get; }

    public (int Min, int Max) SwingZ { get; }

    public (int Min, int Max) Twist { get; }
}
