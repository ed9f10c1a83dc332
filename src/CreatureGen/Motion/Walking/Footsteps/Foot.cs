using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What a foot remembers from update to update: its plan, where it is on its way, and what its leg made of that. Each part has its own writer; all others read.</summary>
internal struct Foot
{
    /// <summary>How far it is in its step, and what is planned for it.</summary>
    public FootPlan Plan;

    /// <summary>Where it is on its way at present.</summary>
    public FootPath Path;

    /// <summary>What its leg made of that when it was last posed.</summary>
    public LegOutcome Leg;

    /// <inheritdoc cref="FootPlan.Phase"/>
    public readonly FootPhase Phase => Plan.Phase;

    /// <inheritdoc cref="FootPlan.Swing"/>
    public readonly float Swing => Plan.Swing;

    /// <inheritdoc cref="FootPlan.Stance"/>
    public readonly float Stance => Plan.Stance;

    /// <summary>Load: 0 in the air, about 1 in the middle of stance.</summary>
    public readonly float Load
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Path.Posture.Shown.Load;
    }

    /// <inheritdoc cref="FootPath.Taken"/>
    public readonly float Taken => Path.Taken;

    /// <summary>How high the ground under its sole is in the mean above that, not above 0: where it stands, or on its way from there to where it will; metres of the model.</summary>
    public readonly float Below
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Phase == FootPhase.Stance ? Plan.From.Below : Plan.From.Below + ((Plan.To.Below - Plan.From.Below) * Swing);
    }

    /// <summary>What users see of it.</summary>
    /// <param name="joint">Joint of its ball.</param>
    public readonly FootReport Report(int joint)
    {
        bool down = Phase == FootPhase.Stance;
        Foothold place = down ? Plan.From : Plan.To;
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
