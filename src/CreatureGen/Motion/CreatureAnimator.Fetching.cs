using System;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Springs;
using CreatureGen.Motion.Walking.Footsteps;

namespace CreatureGen.Motion;

/// <content>Fetches from memory what an update needs.</content>
public sealed partial class CreatureAnimator
{
    /// <summary>Whole numbers in a line of memory, which processors fetch as one.</summary>
    private const int NumbersOfLine = 16;

    /// <summary>What was read, so that the compiler leaves it in; it means nothing.</summary>
    private int fetched;

    /// <summary>
    /// Asks for what the update will read and write of this creature, all at once. Of a crowd each finds its own in no near cache, and would wait for one line after the other where it comes to it: a twentieth of the update of
    /// a walker in a crowd of 512. One that is in the cache already loses nothing.
    /// </summary>
    private void Fetch()
    {
        int read = Touch<Quaternion>(localRotations) ^ Touch<Vector3>(localPositions) ^ Touch<Quaternion>(modelRotations) ^ Touch<Vector3>(modelPositions);
        if (settings.Detail == MotionDetail.Full)
        {
            if (StandsOnFeet)
            {
                read ^= Touch(Legs!.Feet);
            }

            foreach (SpringState state in secondary.States)
            {
                read ^= Touch<SpringBone>(state.Bones);
            }
        }

        fetched = read;
    }

    /// <summary>Reads a number of each line that a list lies in.</summary>
    private static int Touch<T>(ReadOnlySpan<T> list)
        where T : struct
    {
        ReadOnlySpan<int> numbers = MemoryMarshal.Cast<T, int>(list);
        int read = 0;
        for (int i = 0; i < numbers.Length; i += NumbersOfLine)
        {
            read ^= numbers[i];
        }

        return read;
    }
}
