using CreatureGen.Rigging;

namespace CreatureGen.Animation;

/// <summary>A way to move a body that the animator calls: swimming, flying, crawling on the belly. One instance for each creature on the scene.</summary>
internal interface IBodyMotion
{
    /// <summary>Moves on and writes the joints it moves into a local pose; other joints are left alone.</summary>
    /// <param name="context">Time and what is asked.</param>
    /// <param name="local">Pose in the parents' space, one entry per joint.</param>
    void Update(in MotionContext context, in Pose local);
}
