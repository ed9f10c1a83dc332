namespace CreatureGen.Anatomy.Legs;

/// <summary>Angles of a leg away from its rest pose, radians: hip, knee, ankle and ball, positive swinging what hangs backward.</summary>
internal readonly struct LegPosture
{
    public LegPosture(double hip, double knee, double ankle, double ball)
    {
        Hip = hip;
        Knee = knee;
        Ankle = ankle;
        Ball = ball;
    }

    public double Hip { get; }

    public double Knee { get; }

    public double Ankle { get; }

    public double Ball { get; }

    /// <summary>Turn of what lies out to the side about its thigh, positive laying the shank back.</summary>
    public double Twist { get; init; }

    /// <summary>So much of one posture and the rest of another.</summary>
    public static LegPosture Between(LegPosture a, LegPosture b, double fraction) => new(
        a.Hip + ((b.Hip - a.Hip) * fraction),
        a.Knee + ((b.Knee - a.Knee) * fraction),
        a.Ankle + ((b.Ankle - a.Ankle) * fraction),
        a.Ball + ((b.Ball - a.Ball) * fraction))
    {
        Twist = a.Twist + ((b.Twist - a.Twist) * fraction),
    };
}
