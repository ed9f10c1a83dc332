using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>Which of the rules for walkers decided where the legs are.</summary>
internal enum WalkingRule
{
    /// <summary>There are no legs to place.</summary>
    NoLegs,

    /// <summary>A long or tube-like body: as many pairs as fit.</summary>
    AsManyAsFit,

    /// <summary>A pair at the widest bone and one at the next widest free bone that is nearly as wide.</summary>
    TwoWidest,

    /// <summary>One pair under the body's centre, as a tyrannosaur stands.</summary>
    OnePairAtCentre,

    /// <summary>A pair at the widest bone and one at the nearest free bone on the other side of the centre, for balance.</summary>
    Counterweight,

    /// <summary>A pair at the widest bone alone: no other bone was free.</summary>
    WidestAlone,

    /// <summary>One pair under the centre of mass, because a pair at the widest bone took all the room and could not carry the body alone.</summary>
    OnePairUnderMass,
}

/// <summary>Where a walker's limbs are, and what the rest of the creature must do for them.</summary>
/// <param name="Plan">The plan whose anatomy was asked for.</param>
/// <param name="Rule">The rule that decided.</param>
/// <param name="Legs">Pairs of legs, front to rear, with the shift of balance already in them.</param>
/// <param name="Completed">How many of them the rule did not ask for but the anatomy needs.</param>
/// <param name="Girth">Whether the legs had to be slimmed to make room.</param>
/// <param name="Arms">A pair of arms, or null.</param>
/// <param name="RaiseBody">How far the body must be raised for the legs to be as placed, metres; negative: lowered.</param>
/// <param name="PlanChange">The plan to try instead, when even a raised or lowered body cannot carry the legs that its anatomy needs; else null.</param>
/// <param name="Balance">How the creature is kept from falling over; null without legs.</param>
internal sealed record WalkingPlacement(
    BodyPlan Plan,
    WalkingRule Rule,
    IReadOnlyList<LegPlacement> Legs,
    int Completed,
    LegGirth Girth,
    ArmPlacement? Arms,
    double RaiseBody,
    BodyPlan? PlanChange,
    BalanceCorrection? Balance);
