namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How much of an act a body does.</summary>
/// <param name="Whole">Factor on all that the body does.</param>
/// <param name="Down">Factor on how far chest and hips come down, on top.</param>
/// <param name="Trunk">Factor on how else the trunk goes, on top.</param>
internal readonly record struct ActGain(float Whole, float Down, float Trunk = 1f)
{
    /// <summary>All of it.</summary>
    public static ActGain Full => new(1f, 1f);

    /// <summary>Factor on a channel. No body is too weak for its face.</summary>
    public float Of(ActChannel channel) => channel switch
    {
        ActChannel.Jaw or ActChannel.Lids or ActChannel.Ears or ActChannel.Reach or ActChannel.ForeFold or ActChannel.HindFold or ActChannel.OnFlank => 1f,
        ActChannel.ForeDown or ActChannel.HindDown => Whole * Down,
        <= ActChannel.BackTwist => Whole * Trunk,
        _ => Whole,
    };
}
