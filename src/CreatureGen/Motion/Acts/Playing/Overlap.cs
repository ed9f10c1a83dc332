namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How late what hangs on a body follows it: a head its neck, the tail the hips, its end its root, a forearm the arm, ears the head.</summary>
/// <remarks>Based on: J. Lasseter, "Principles of traditional animation applied to 3D computer animation" (1987), for overlapping action.</remarks>
internal static class Overlap
{
    /// <summary>How late a channel is, times √(leg length / gravity). Who is startled moves all at once.</summary>
    public static float Of(ActChannel channel, ActKind kind) => kind == ActKind.Reflex ? 0f : channel switch
    {
        ActChannel.HeadPitch or ActChannel.HeadSide or ActChannel.HeadRoll => 0.15f,
        ActChannel.Ears => 0.25f,
        ActChannel.TailPitch or ActChannel.TailSide => 0.25f,
        ActChannel.TailCurl => 0.5f,
        ActChannel.ArmsBend or ActChannel.ArmBend => 0.15f,
        _ => 0f,
    };
}
