namespace CreatureGen.Motion.Metrics;

/// <summary>How well a creature copes with a course. Lengths are in leg lengths, so that creatures of all sizes compare. What does not apply is null: a fish has no feet that could slip.</summary>
/// <param name="Frames">Number of updates.</param>
/// <param name="Seconds">Their time.</param>
/// <param name="LimitExcess">Most that a joint was beyond its limits, radians; root, body, eyes, lids and ears do not count.</param>
/// <param name="LimitExcessJoint">Skeleton index of that joint; −1 for none.</param>
/// <param name="JointSpeed">Greatest rate of a joint relative to its parent from update to update, radians per second; what looks about or swings by itself (eyes, lids, ears, feelers, tails of those that walk) does not count.</param>
/// <param name="JointSpeedJoint">Skeleton index of that joint; −1 for none.</param>
/// <param name="JointAcceleration">Greatest change of such a rate, radians per second squared.</param>
/// <param name="FastJoints">How often such a rate was above 60 rad/s, over all joints and updates.</param>
/// <param name="LinearAcceleration">Greatest change of the root's velocity as seen 60 times a second, metres per second squared.</param>
public sealed record CourseReport(int Frames, float Seconds, float LimitExcess, int LimitExcessJoint, float JointSpeed, int JointSpeedJoint, float JointAcceleration, int FastJoints, float LinearAcceleration)
{
    /// <summary>Greatest rate at which the head turned as seen from the root, radians per second: joints of a neck share its turns, so that none of them need be fast. Acts and gaze count.</summary>
    public float? HeadSpeed { get; init; }

    /// <summary>Farthest that a foot slipped in a whole stance: the sum, from update to update, of the way over the ground of that touching vertex which moved least. A foot that rolls or turns about a point of its sole does not slip.</summary>
    public float? StanceSlip { get; init; }

    /// <summary>The same, of which 1 % of the stances have more.</summary>
    public float? StanceSlip99 { get; init; }

    /// <summary>Number of stances.</summary>
    public int? Stances { get; init; }

    /// <summary>Deepest that any part of a foot was in the ground: the shortest way out of it, up or level.</summary>
    public float? Penetration { get; init; }

    /// <summary>Least height of the lowest point of a foot in the middle of its swing; below 0 in the ground.</summary>
    public float? Clearance { get; init; }

    /// <summary>Farthest that the root was above or below the mean height of the ground below its hips.</summary>
    public float? RootLag { get; init; }

    /// <summary>How often it lost the ground: it came to be more than a leg above or below it, or where there is none.</summary>
    public int? LostGround { get; init; }

    /// <summary>How long it had lost the ground, seconds.</summary>
    public float? LostGroundSeconds { get; init; }

    /// <summary>Least number of feet down.</summary>
    public int? MinSupport { get; init; }

    /// <summary>Mean number of feet down.</summary>
    public float? MeanSupport { get; init; }

    /// <summary>Longest time with no foot down, seconds.</summary>
    public float? LongestFlight { get; init; }

    /// <summary>Farthest that a resting foot ended from where it does at 480 Hz, leg lengths; of one that still takes its last step, where that goes.</summary>
    public float? RestingFootSpread { get; init; }

    /// <summary>How far the root ended from where it does at 480 Hz, world space.</summary>
    public float? RestingRootSpread { get; init; }
}
