using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>The plan of a foot: how far it is in its step, whether it steps, and to where. The planner of footsteps writes it, and nobody else.</summary>
internal struct FootPlan
{
    /// <summary>How quickly a foot that sits out goes back to the middle of its stance, stances per second.</summary>
    private const float MidstanceRate = 3f;

    /// <summary>Whether it is down.</summary>
    public FootPhase Phase;

    /// <summary>Where it is locked in stance, or comes from in a swing.</summary>
    public Foothold From;

    /// <summary>Whether it has just come down, and has not been posed since or not been looked at.</summary>
    public bool Arrived;

    /// <summary>Progress of the swing, 0..1.</summary>
    public float Swing;

    /// <summary>Progress of the stance, 0..1.</summary>
    public float Stance;

    /// <summary>Where a swing goes.</summary>
    public Foothold To;

    /// <summary>How far that still is from the place on the ground to which it comes round, world metres.</summary>
    public Vector3 Left;

    /// <summary>Where a swing would go on level ground, followed smoothly: what is asked may change in mid step. World space.</summary>
    public Vector3 Wanted;

    /// <summary>How far ahead of its home a body that stands has set it, metres of the model.</summary>
    public float Ahead;

    /// <summary>Whether there is ground where it goes.</summary>
    public bool HasTarget;

    /// <summary>Shift of the target off an edge, along the foot, metres.</summary>
    public float Shift;

    /// <summary>The wanted place for which that was found. World space.</summary>
    public Vector3 Sought;

    /// <summary>Place in the swing's share of the cycle at which it left the ground.</summary>
    public float LiftAt;

    /// <summary>Whether it leaves the ground when the gait has it do so next.</summary>
    public bool Steps;

    /// <summary>Whether it sits out a swing because it is where it should be.</summary>
    public bool Held;

    /// <summary>Whether the present swing has a target.</summary>
    public bool Aimed;

    /// <summary>Whether it goes to where it will stand for good.</summary>
    public bool ForGood;

    /// <summary>Whether it has stepped under a body that stands from its beginning on and is not asked to creep, and so is as near to its home as its leg and the ground let it come: it need not try again. In the air whether it does so.</summary>
    public bool AsNear;

    /// <summary>Whether it swings by its own clock, out of step with the gait: a correction.</summary>
    public bool Correcting;

    /// <summary>Seconds of such a swing.</summary>
    public float Flight;

    /// <summary>How far its leg reached when it was last looked at whether it has to leave the ground, metres.</summary>
    public float Reached;

    /// <summary>By how much it missed its place then, metres.</summary>
    public float Missed;

    /// <summary>Takes what its swing goes by along with the ground that it goes to.</summary>
    /// <param name="way">How far that has moved, world space.</param>
    public void TakeAlong(Vector3 way)
    {
        Wanted += way;
        Sought += way;
    }

    /// <summary>The place on the ground to which a swing comes round, world space.</summary>
    public readonly Vector3 Goal => To.Position + Left;

    /// <summary>Brings a swing that no longer seeks ground the rest of the way to the place that it has found.</summary>
    /// <param name="fraction">Share of what is left.</param>
    public void Near(float fraction)
    {
        To.Position += Left * fraction;
        Left *= 1f - fraction;
    }

    /// <summary>Lets the stance go on with the cycle; a foot that sits out goes back to the middle of its stance and is taken up again there.</summary>
    /// <param name="seconds">That have passed.</param>
    /// <param name="stance">Progress of the stance by the cycle.</param>
    public void Rest(float seconds, float stance)
    {
        if (Held && stance < 0.5f)
        {
            float max = MidstanceRate * seconds;
            Stance += Scalar.Clamp(0.5f - Stance, -max, max);
            return;
        }

        Held = false;
        Stance = stance;
    }
}
