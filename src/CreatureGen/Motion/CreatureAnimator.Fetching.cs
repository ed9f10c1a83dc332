using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Springs;

namespace CreatureGen.Motion;

/// <content>Fetches from memory what an update needs.</content>
public sealed partial class CreatureAnimator
{
    /// <summary>What was read; it means nothing.</summary>
    private int fetched;

    /// <summary>
    /// Asks for what the update will read and write of this creature, all at once. Of a crowd each finds its own in no near cache, and would wait for one line after the other where it comes to it: a twentieth of the update of
    /// a walker in a crowd of 512. One that is in the cache already loses nothing.
    /// </summary>
    private void Fetch()
    {
        if (settings.Detail == MotionDetail.Far)
        {
            // It goes through its lists from end to end and does little else.
            return;
        }

        int read = MemoryLines.Touch<Quaternion>(localRotations) ^ MemoryLines.Touch<Vector3>(localPositions) ^ MemoryLines.Touch<Quaternion>(modelRotations) ^ MemoryLines.Touch<Vector3>(modelPositions);
        if (StandsOnFeet)
        {
            read ^= Legs!.Fetch();
        }

        foreach (SpringState state in secondary.States)
        {
            read ^= MemoryLines.Touch<SpringBone>(state.Bones);
        }

        fetched = read;
    }
}
