using System.Numerics;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>What is summed side by side over the legs of a body, by the names of the four numbers.</summary>
internal static class LegSums
{
    /// <summary>Weights of one leg.</summary>
    /// <param name="hind">1 of the hindmost pair, else 0.</param>
    /// <param name="fore">1 of the foremost pair, else 0.</param>
    /// <param name="aside">Place of its foot to the left, metres.</param>
    public static Vector4 WeightsOf(float hind, float fore, float aside) => new(hind, fore, aside, 1f);

    /// <summary>That over the hindmost pair.</summary>
    public static float Hind(this Vector4 sums) => sums.X;

    /// <summary>That over the foremost pair.</summary>
    public static float Fore(this Vector4 sums) => sums.Y;

    /// <summary>That over all legs by their places to the left.</summary>
    public static float Aside(this Vector4 sums) => sums.Z;

    /// <summary>That over all legs.</summary>
    public static float All(this Vector4 sums) => sums.W;
}
