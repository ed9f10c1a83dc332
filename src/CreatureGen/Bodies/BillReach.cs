using System;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Blueprints;

namespace CreatureGen.Bodies;

/// <summary>How far the bills of a beak reach ahead of the first ring of a face, metres: at the least somewhat farther than its nose bulges.</summary>
internal readonly struct BillReach
{
    // Least reach of either bill, in bulges of the nose: the upper one has to close to a tip beyond it, the lower one to cover the chin, which bulges less.
    private const float Least = 1.9f;
    private const float LeastBelow = 1.2f;

    private BillReach(float upper, float lower)
    {
        Upper = upper;
        Lower = lower;
    }

    /// <summary>That of the upper bill.</summary>
    public float Upper { get; }

    /// <summary>That of the lower bill.</summary>
    public float Lower { get; }

    /// <summary>The reach of a beak on a face.</summary>
    public static BillReach Of(BeakBlueprint beak, BodyShape shape)
    {
        float nose = MouthSlit.NoseBulge(shape);
        float upper = Math.Max((float)beak.Length, Least * nose);
        return new BillReach(upper, Math.Max(upper * BeakForm.Of(beak.Style).LowerLength, LeastBelow * nose));
    }
}
