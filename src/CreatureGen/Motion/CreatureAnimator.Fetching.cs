using CreatureGen.Maths;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion;

/// <content>Fetches from memory what an update needs.</content>
public sealed partial class CreatureAnimator
{
    /// <summary>How many there are: known here, it has not to be fetched first.</summary>
    private readonly int joints;

    /// <summary>What was read; it means nothing.</summary>
    private int fetched;

    /// <summary>
    /// Asks for what the update will read and write of this creature, all at once: first objects that lead on to others, then lists. Of a crowd each finds its own in no near cache, and would wait for one line after the other
    /// where it comes to it: a tenth of the update of a walker in a crowd of 512. One that is in the cache already loses nothing.
    /// </summary>
    private void Fetch()
    {
        if (!MemoryLines.Pay || settings.Detail == MotionDetail.Far)
        {
            // What is far goes through its lists from end to end and does little else.
            return;
        }

        int read = StandsOnFeet ? Mode!.Fetch() ^ Legs!.Fetch() : 0;
        read ^= MemoryLines.Touch(ref root) ^ (headGaze?.Fetch() ?? 0) ^ secondary.Fetch();
        fetched = read ^ MemoryLines.Touch(localRotations, joints) ^ MemoryLines.Touch(localPositions, joints) ^ MemoryLines.Touch(modelRotations, joints) ^ MemoryLines.Touch(modelPositions, joints);
    }
}
