namespace CreatureGen.Motion.Metrics;

/// <summary>How well a creature does an act. What does not apply is null.</summary>
/// <param name="Frames">Updates.</param>
/// <param name="Seconds">How long it took.</param>
/// <param name="LimitExcess">Most that a joint was beyond its limits, radians.</param>
/// <param name="LimitExcessJoint">Which; −1 for none.</param>
/// <param name="JointSpeed">Fastest turn of a joint, radians per second.</param>
/// <param name="JointSpeedJoint">Which; −1 for none.</param>
/// <param name="Penetration">Deepest that the skin was below where it is as the creature stands, parts of the body's length.</param>
/// <param name="PenetrationJoint">The joint that carries the skin there; −1 for none.</param>
/// <param name="ContactError">How far what strikes was from its target at the contact, parts of the body's length.</param>
/// <param name="FootSlip">Most that a planted foot went from where it stood, leg lengths.</param>
/// <param name="TrunkJolt">Farthest that the middle of the trunk was from half way between where it was .05 s before and where it was .05 s after, parts of the body's length: how abruptly it went, whichever way. Going evenly is 0, falling freely .012 m, and a body that is raised at once half of what it is raised by.</param>
public sealed record ActReport(
    int Frames,
    float Seconds,
    float LimitExcess,
    int LimitExcessJoint,
    float JointSpeed,
    int JointSpeedJoint,
    float? Penetration,
    int PenetrationJoint,
    float? ContactError,
    float? FootSlip,
    float TrunkJolt);
