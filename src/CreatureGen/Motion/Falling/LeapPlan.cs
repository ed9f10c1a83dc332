namespace CreatureGen.Motion.Falling;

/// <summary>How a jump is done.</summary>
/// <param name="Upward">Speed upwards at the take-off, world m/s.</param>
/// <param name="Pace">Speed ahead that is asked of its legs while it crouches and pushes, world m/s.</param>
/// <param name="Crouch">How much of a crouch it takes, 1 from where it stands.</param>
internal readonly record struct LeapPlan(float Upward, float Pace, float Crouch)
{
    /// <summary>One between two.</summary>
    public static LeapPlan Lerp(in LeapPlan from, in LeapPlan to, float u) => new(
        from.Upward + ((to.Upward - from.Upward) * u),
        from.Pace + ((to.Pace - from.Pace) * u),
        from.Crouch + ((to.Crouch - from.Crouch) * u));
}
