using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>A leg folded back along the flank: as straight back as its joints allow, and as far out as what lies there is thick.</summary>
internal sealed class LegFold
{
    /// <summary>Least and widest angle between the direction that a folded leg is turned to and straight back, and the steps in which it is sought, radians. The least leaves hips room to follow the flank both ways.</summary>
    private const double MinSplay = 0.34;
    private const double WidestSplay = 0.9;
    private const double SplayStep = 0.06;

    /// <summary>How far each joint from the hip down is turned about the leg, its outer edge down, radians: with the sole level the whole leg and its foot are seen on edge, a peg, from the side, the front and behind.</summary>
    private const double Turned = 0.3;

    /// <summary>First joint that is turned about the leg: that of the girdle is not.</summary>
    private const int Hip = 1;

    /// <summary>First joint whose bone has to keep clear: the thigh grows out of the body.</summary>
    private const int Knee = 2;

    /// <summary>Where a leg that is spread against the stream reaches: out and a little down.</summary>
    private static readonly Vector3 against = Vec.Normalize(new Vector3(0.9f, -0.35f, -0.25f), Vector3.UnitX);

    private readonly Quaternion[] turns;

    private LegFold(Quaternion[] turns, Vector3 tip, FoldedBone[] bones)
    {
        this.turns = turns;
        Tip = tip;
        Bones = bones;
    }

    /// <summary>The turn of each joint of the left leg away from rest, about the model's axes.</summary>
    public ReadOnlySpan<Quaternion> Turns => turns;

    /// <summary>Where the tip of the left foot is, model space.</summary>
    public Vector3 Tip { get; }

    /// <summary>Where the bones of the left leg are.</summary>
    public IReadOnlyList<FoldedBone> Bones { get; }

    /// <summary>Folds a leg.</summary>
    /// <param name="chain">The pair of legs.</param>
    /// <param name="subject">Whose they are.</param>
    /// <param name="beside">What the leg is to keep clear of, as far as it can.</param>
    /// <param name="droop">How much it is turned down on its way back, as a slope.</param>
    public static LegFold Of(PairedChain chain, MotionSubject subject, IReadOnlyList<FoldedBone> beside, double droop)
    {
        LegFold? best = null;
        float min = float.MaxValue;
        for (double splay = MinSplay; splay <= WidestSplay && min > 0f; splay += SplayStep)
        {
            PortableMath.SinCos(splay, out double sine, out double cosine);
            LegFold fold = Towards(chain, subject, new Vector3((float)sine, -(float)droop, -(float)cosine), Turned);
            float depth = fold.DepthIn(beside);
            if (depth < min)
            {
                min = depth;
                best = fold;
            }
        }

        return best!;
    }

    /// <summary>The turns of each joint that spread a leg against the stream, about the model's axes.</summary>
    public static Quaternion[] Spread(PairedChain chain, MotionSubject subject) => Towards(chain, subject, against, 0).turns;

    /// <summary>Turns every bone towards a direction and about it, from the hip down, as far as its joint allows.</summary>
    private static LegFold Towards(PairedChain chain, MotionSubject subject, Vector3 direction, double about)
    {
        var turns = new Quaternion[chain.Count];
        var bones = new List<FoldedBone>();
        Quaternion whole = Quaternion.Identity;
        Vector3 at = chain.Points[0];
        for (int k = 0; k < turns.Length; k++)
        {
            Vector3 there = Rotation.Rotate(Rotation.Inverse(whole), direction);
            turns[k] = chain.Limit(k, Rotation.Multiply(Rotation.FromAxisAngle(Vec.Normalize(there, direction), k < Hip ? 0 : about), Rotation.FromTo(chain.Axes[k], there)));

            // Limits slow a joint down towards their ends: of the turn that is kept, so much is written.
            whole = Rotation.Normalize(Rotation.Multiply(whole, chain.Limit(k, turns[k])));
            foreach (CapsuleCollider capsule in subject.Bones)
            {
                if (capsule.Joint == chain.Limb.Joints[k])
                {
                    bones.Add(new FoldedBone(k, capsule, at, Rotation.Multiply(whole, subject.Skeleton.ModelRotations[capsule.Joint])));
                }
            }

            at += Rotation.Rotate(whole, chain.Points[k + 1] - chain.Points[k]);
        }

        return new LegFold(turns, at, bones.ToArray());
    }

    /// <summary>How deep shank and foot go into other bones, metres; 0 when they keep clear.</summary>
    private float DepthIn(IReadOnlyList<FoldedBone> others)
    {
        float depth = 0f;
        foreach (FoldedBone own in Bones)
        {
            for (int i = 0; own.Number >= Knee && i < others.Count; i++)
            {
                depth = Math.Max(depth, own.DepthIn(others[i]));
            }
        }

        return depth;
    }
}
