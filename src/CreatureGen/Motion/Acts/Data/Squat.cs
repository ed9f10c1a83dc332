namespace CreatureGen.Motion.Acts.Data;

/// <summary>How an upright body comes down on its legs before it lies: acts go there, and where its legs fold is found there.</summary>
internal static class Squat
{
    /// <summary>How far hips come down, part of their height.</summary>
    public const float HindDown = 0.75f;
}
