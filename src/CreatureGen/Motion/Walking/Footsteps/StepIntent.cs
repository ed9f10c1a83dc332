using System.Numerics;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What is planned for a foot: whether it steps, and to where.</summary>
internal struct StepIntent
{
    /// <summary>Where a swing goes.</summary>
    public Foothold To;

    /// <summary>Where a swing would go on level ground, followed smoothly: what is asked may change in mid step. World space.</summary>
    public Vector3 Wanted;

    /// <summary>Whether there is ground where it goes.</summary>
    public bool HasTarget;

    /// <summary>Shift of the target off an edge, along the foot, metres.</summary>
    public float Nudge;

    /// <summary>Place in the swing's share of the cycle at which it left the ground.</summary>
    public float LiftAt;

    /// <summary>Whether it leaves the ground when the gait has it do so next.</summary>
    public bool Steps;

    /// <summary>Whether it sits out a swing because it is where it should be.</summary>
    public bool Held;

    /// <summary>Whether the present swing has a target.</summary>
    public bool Aimed;

    /// <summary>Whether it swings by its own clock, out of step with the gait: a correction.</summary>
    public bool Correcting;

    /// <summary>Seconds of such a swing.</summary>
    public float Flight;
}
