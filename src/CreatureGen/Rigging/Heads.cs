namespace CreatureGen.Rigging;

/// <summary>Which head a joint belongs to where there are several. The first head of a skeleton is the one that motion leads.</summary>
internal static class Heads
{
    /// <summary>The end of the names of what belongs to a second neck and head: <c>Head_2</c>, <c>Eye_L_2</c>.</summary>
    public const string Suffix = "_2";

    /// <summary>The head that a joint hangs on, itself for a head; −1 for none.</summary>
    public static int Above(Skeleton skeleton, int joint)
    {
        while (joint >= 0 && skeleton.Joints[joint].Role != JointRole.Head)
        {
            joint = skeleton.Parents[joint];
        }

        return joint;
    }

    /// <summary>Whether a joint hangs on a head other than a given one.</summary>
    public static bool IsOfAnother(Skeleton skeleton, int joint, int head) => Above(skeleton, joint) is >= 0 and int own && own != head;

    /// <summary>Whether a joint is neck or head of a further head: it leads to one, and not to the first.</summary>
    public static bool IsFurther(Skeleton skeleton, int joint)
    {
        int first = skeleton.FirstOf(JointRole.Head);
        bool leads = false;
        for (int head = first; head >= 0 && head < skeleton.Count; head++)
        {
            if (skeleton.Joints[head].Role != JointRole.Head)
            {
                continue;
            }

            int bearer = head;
            while (bearer >= 0 && bearer != joint)
            {
                bearer = skeleton.Parents[bearer];
            }

            if (bearer == joint && head == first)
            {
                return false;
            }

            leads |= bearer == joint;
        }

        return leads;
    }
}
