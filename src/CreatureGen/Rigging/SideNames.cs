using System;

namespace CreatureGen.Rigging;

/// <summary>How names say left and right: <c>Leg_L1</c> and <c>Leg_R1</c>, <c>LeftArm</c> and <c>RightArm</c>, <c>arm.l</c> and <c>arm.r</c>.</summary>
internal static class SideNames
{
    private static readonly (string Left, string Right)[] words = { ("L", "R"), ("l", "r"), ("Left", "Right"), ("left", "right"), ("LEFT", "RIGHT") };

    /// <summary>Whether two names are the same but for one word for the side.</summary>
    public static bool AreCounterparts(string left, string right)
    {
        foreach ((string l, string r) in words)
        {
            if (left.Length - l.Length == right.Length - r.Length && DifferInWord(left, l, right, r))
            {
                return true;
            }
        }

        return false;
    }

    private static bool DifferInWord(string left, string l, string right, string r)
    {
        int same = 0;
        while (same < left.Length && same < right.Length && left[same] == right[same])
        {
            same++;
        }

        return string.CompareOrdinal(left, same, l, 0, l.Length) == 0
            && string.CompareOrdinal(right, same, r, 0, r.Length) == 0
            && left.AsSpan(Math.Min(same + l.Length, left.Length)).SequenceEqual(right.AsSpan(Math.Min(same + r.Length, right.Length)));
    }
}
