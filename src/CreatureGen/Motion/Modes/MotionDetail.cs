namespace CreatureGen.Motion;

/// <summary>How much of a creature's motion is worked out.</summary>
public enum MotionDetail
{
    /// <summary>All of it.</summary>
    Full,

    /// <summary>
    /// What is seen from afar, where a creature is as high as a twentieth of the picture or less. What walks travels as it is asked and shows the recorded cycle of its gait: one ray feels the ground, the body tilts with it, feet are not planted and tell no
    /// steps, nothing looks about, blinks or swings by itself, idle acts wait, and an update costs the same however long it is. What flies, swims or crawls only leaves out head and springs.
    /// </summary>
    Far,
}
