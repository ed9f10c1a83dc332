using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>What is brought where.</summary>
/// <param name="Tool">What.</param>
/// <param name="Mirrored">Whether the act's side is the right.</param>
/// <param name="Target">World space.</param>
/// <param name="SnoutDown">How far below level the snout points there, radians.</param>
/// <param name="Plan">How the trunk helps.</param>
internal readonly record struct ActAim(ActTool Tool, bool Mirrored, Vector3 Target, float SnoutDown, ReachPlan Plan)
{
    /// <summary>The target as seen from the root, where nobody named one: it goes along with the body, which comes to a stand before it acts, or acts as it goes; null for one that stays where it is in the world.</summary>
    public Vector3? Own { get; init; }

    /// <summary>Where it is now.</summary>
    /// <param name="root">Where the creature is.</param>
    public ActAim At(in RootPlace root) => Own is Vector3 own ? this with { Target = root.ToWorld(own) } : this;

    /// <summary>One aim for two that are under way: between both where they bring the same, else that which is farther on its way.</summary>
    /// <param name="a">One.</param>
    /// <param name="fractionOfA">How far it is on its way.</param>
    /// <param name="b">The other.</param>
    /// <param name="fractionOfB">How far that is.</param>
    public static ActAim Between(in ActAim a, float fractionOfA, in ActAim b, float fractionOfB)
    {
        if (a.Tool != b.Tool || a.Mirrored != b.Mirrored || !(fractionOfA > 0f) || !(fractionOfB > 0f))
        {
            return fractionOfA > fractionOfB ? a : b;
        }

        float part = fractionOfB / (fractionOfA + fractionOfB);
        Vector3? own = a.Own is Vector3 ownOfA && b.Own is Vector3 ownOfB ? Vec.Lerp(ownOfA, ownOfB, part) : null;
        return b with { Target = Vec.Lerp(a.Target, b.Target, part), SnoutDown = Scalar.Lerp(a.SnoutDown, b.SnoutDown, part), Own = own };
    }
}
