using System;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What a foot remembers from update to update.</summary>
internal struct Foot
{
    /// <summary>Whether it is down.</summary>
    public FootPhase Phase;

    /// <summary>Where it is locked in stance, or comes from in a swing.</summary>
    public Foothold From;

    /// <summary>Progress of the swing, 0..1.</summary>
    public float Swing;

    /// <summary>Progress of the stance, 0..1.</summary>
    public float Stance;

    /// <summary>What is planned for it.</summary>
    public StepIntent Plan;

    /// <summary>Where it is on its way at present.</summary>
    public FootPath Path;

    /// <summary>What its leg made of that when it was last posed.</summary>
    public LegOutcome Leg;

    /// <summary>Its pitch, fold and load, without a jump where it leaves the cycle.</summary>
    public PostureFade Posture;

    /// <summary>Load: 0 in the air, about 1 in the middle of stance.</summary>
    public readonly float Load => Posture.Shown.Load;

    /// <summary>How far an act has taken it off the ground, 0..1: then it neither carries nor steps.</summary>
    public float Taken;

    /// <summary>What users see of it.</summary>
    /// <param name="joint">Joint of its ball.</param>
    public readonly FootReport Report(int joint)
    {
        bool down = Phase == FootPhase.Stance;
        Foothold place = down ? From : Plan.To;
        return new FootReport(Taken > 0f ? FootPhase.Swing : Phase, joint, place.Position, place.Normal, down ? Stance : Swing, Load * (1f - Taken), Leg.Stretch, Leg.Residual);
    }

    /// <summary>Whether all feet are down.</summary>
    public static bool AllStand(ReadOnlySpan<Foot> feet)
    {
        bool stand = true;
        foreach (ref readonly Foot foot in feet)
        {
            stand &= foot.Phase == FootPhase.Stance;
        }

        return stand;
    }
}
