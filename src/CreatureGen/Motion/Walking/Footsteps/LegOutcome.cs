using System.Numerics;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What came of a foot's place when its leg was last posed: how far it reached, and by how much joints and length kept the foot from its place. Planner and body look at it in the next update; who poses legs and makes room for them writes it.</summary>
internal struct LegOutcome
{
    /// <summary>From the hip to what the leg reaches for, when last posed, before the body was lowered for it. Model space.</summary>
    public Vector3 Chord;

    /// <summary>How quickly that changes as the foot stands, by all that moves its hip; none as it has just come down. Metres per second.</summary>
    public Vector3 Drift;

    /// <summary>How far its leg drew the body down when it last stood or was about to, metres.</summary>
    public float Drawn;

    /// <summary>How far it held the body down when it last stood, 0..1: one that is let go in the middle of its stance does not let the body rise at once.</summary>
    public float Held;

    /// <summary>How far the body was lowered when it was last posed, metres.</summary>
    public float Lowered;

    /// <summary>The hip of its leg, when last posed. Model space.</summary>
    public Vector3 Hip;

    /// <summary>Turn of the trunk at that hip from rest. Model space.</summary>
    public Quaternion Carrier;

    /// <summary>Length that the leg would need, as part of its reach, when last posed.</summary>
    public float Stretch;

    /// <summary>Distance by which the foot missed its place when last posed, metres.</summary>
    public float Residual;

    /// <summary>From where it was to be to where its leg brought it when last posed, the more of it the nearer it was to coming down, all of it as it came down. Model space.</summary>
    public Vector3 Astray;

    /// <summary>How far the joints of its leg kept it from lying on the ground as it should when it last stood, about half the angle in radians.</summary>
    public float Relaxation;

    /// <summary>How it then stood.</summary>
    public TurnedFoot Turned;

    /// <summary>That of a leg that has not been posed yet, under a trunk at rest.</summary>
    public static LegOutcome AtRest(LegRig leg) => new() { Chord = leg.Parts.Upper + leg.Shank, Hip = leg.HipRest, Carrier = Quaternion.Identity };
}
