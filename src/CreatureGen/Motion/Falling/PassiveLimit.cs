using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How far joints go without muscles: necks and backs bend up and down less than they do in motion, as their ligaments and the flesh below them hold them, and to the side as far.</summary>
internal static class PassiveLimit
{
    /// <summary>How far they bend up and down, parts of how far they do with muscles.</summary>
    private const float Neck = 0.45f;
    private const float Back = 0.6f;

    /// <summary>The limit of a joint.</summary>
    public static JointLimit Of(Joint joint)
    {
        float part = joint.Role is JointRole.Neck or JointRole.Head ? Neck : joint.Role == JointRole.Spine ? Back : 1f;
        return part < 1f ? joint.Limit with { SwingX = new AngleRange(part * joint.Limit.SwingX.Min, part * joint.Limit.SwingX.Max) } : joint.Limit;
    }
}
