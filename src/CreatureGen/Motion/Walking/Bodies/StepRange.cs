using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>How far a standing foot can go from where it belongs before its leg is stretched or folded too far, to either side and ahead or back, metres: turns take feet aside that are far from the pivot.</summary>
internal readonly record struct StepRange(float Aside, float Ahead)
{
    /// <summary>Part of its reach that a leg takes up at most, unless it stands stretched farther.</summary>
    private const float Stretch = 0.97f;

    /// <summary>How far a body comes down over legs below it that step as wide as they can, leg lengths: legs that stand nearly straight hardly step otherwise.</summary>
    public const float Drop = 0.08f;

    /// <summary>Length to which it is folded at most, of its folded reach and of its length at rest; unless it stands folded farther.</summary>
    private const float FoldedFraction = 1.05f;
    private const float ShortestFraction = 0.55f;

    /// <summary>Part of its level distance from the hip to which a foot out to the side comes at most.</summary>
    private const float NearestFraction = 0.5f;

    /// <summary>Cosine of how far a leg out to the side is swept about the vertical at most (41°).</summary>
    private const float SweepCosine = 0.75f;

    /// <summary>How far a leg under the body leans aside at most, radians (17°), and part of what its hip turns: the rest is for the roll of the body.</summary>
    private const float Lean = 0.29f;
    private const float LeanFraction = 0.8f;

    /// <summary>What it keeps of that for ground that slants aside, radians.</summary>
    private const float SlantRoom = 0.06f;

    /// <summary>Part of what its ankle bends to a side by which a leg leans at most whose ankle carries the foot by itself: the sole stays on the ground.</summary>
    private const float AnkleFraction = 0.65f;

    /// <summary>Least range, and the step in which it is measured, leg lengths.</summary>
    private const float Min = 0.06f;
    private const float Step = 0.02f;

    /// <summary>Measures a leg.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="home">Where its foot belongs under a body that goes, model space.</param>
    /// <param name="drop">How far the body comes down over a leg below it that steps aside, leg lengths.</param>
    public static StepRange Of(LegRig leg, Vector3 home, float drop)
    {
        Vector3 chord = leg.Thigh + leg.Shank + (leg.Traits.Linkage == LegLinkage.Pantograph ? leg.Metatarsus : Vector3.Zero) + (home - leg.Home);
        float lower = leg.Lateral ? 0f : drop * leg.Length;
        float aside = Math.Min(Way(leg, chord, Vector3.UnitX, lower), Way(leg, chord, -Vector3.UnitX, lower));
        float ahead = Math.Min(Way(leg, chord, Vector3.UnitZ, 0f), Way(leg, chord, -Vector3.UnitZ, 0f));
        return new StepRange(leg.Lateral ? aside : Math.Min(aside, Math.Max(Leaning(leg), Min * leg.Length)), ahead);
    }

    /// <summary>How far aside a leg under the body goes from where it stands before its hip ends.</summary>
    private static float Leaning(LegRig leg)
    {
        float inward = Math.Abs(leg.HipRest.X) - Math.Abs(leg.Home.X);
        float lean = leg.Traits.Linkage == LegLinkage.Foot ? Math.Min(Lean, AnkleFraction * leg.Limits.AnkleAside) : Lean;
        float inner = leg.AsideRange(Math.Min(lean, (LeanFraction * leg.Limits.DrawsIn) - SlantRoom)) - inward;
        float outer = leg.AsideRange(Math.Min(lean, (LeanFraction * leg.Limits.DrawsOut) - SlantRoom)) + inward;
        return Math.Min(inner, outer);
    }

    private static float Way(LegRig leg, Vector3 rest, Vector3 direction, float drop)
    {
        float length = Vec.Length(rest);
        float max = Math.Max(Stretch * leg.Reach, length);
        float min = Math.Min(length, Math.Max(FoldedFraction * leg.FoldedReach, ShortestFraction * length));
        var level = new Vector3(rest.X, 0f, rest.Z);
        float outside = Vec.Length(level);
        float step = Step * leg.Length;
        float way = 0f;
        while (way < leg.Length)
        {
            Vector3 chord = rest + (direction * (way + step));
            float taken = Vec.Length(chord with { Y = chord.Y + drop });
            chord.Y = 0f;
            float away = Vec.Length(chord);
            bool swept = Vec.Dot(chord, level) < SweepCosine * away * outside;
            if (taken > max || taken < min || (leg.Lateral && (swept || away < NearestFraction * outside)))
            {
                break;
            }

            way += step;
        }

        return Math.Max(way, Min * leg.Length);
    }
}
