using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A joint with everything that hangs on it. Nothing is allocated.</summary>
public static class Subtree
{
    private const int BitsPerWord = 64;

    /// <summary>Chains a local pose from one joint outwards, leaving the places of all other joints as they are: after a solver turned a joint, this is all there is to do.</summary>
    /// <param name="skeleton">Gives the parents.</param>
    /// <param name="joint">The joint that was turned or moved in its parent's space.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">Pose in model space, up to date but for the joint and its descendants.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, or there is no such joint.</exception>
    public static void LocalToModel(Skeleton skeleton, int joint, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        Require(skeleton, joint);
        ReadOnlySpan<int> parents = skeleton.Parents;
        Span<ulong> inside = stackalloc ulong[(parents.Length + BitsPerWord - 1) / BitsPerWord];
        inside.Clear();
        int last = skeleton.LastBelow[joint];
        for (int i = joint; i <= last; i++)
        {
            int parent = parents[i];
            if (i != joint && (parent < joint || (inside[parent / BitsPerWord] & (1UL << (parent % BitsPerWord))) == 0))
            {
                continue;
            }

            inside[i / BitsPerWord] |= 1UL << (i % BitsPerWord);
            Place(parent, i, local, model);
        }
    }

    /// <summary>Fills a mask: a weight for a joint and all its descendants, 0 for all others.</summary>
    /// <param name="skeleton">Gives the parents.</param>
    /// <param name="joint">Where the tree begins.</param>
    /// <param name="weight">For the joint and what hangs on it.</param>
    /// <param name="mask">Receives one weight per joint.</param>
    /// <exception cref="ArgumentException">The mask is not as long as the skeleton, or there is no such joint.</exception>
    public static void FillMask(Skeleton skeleton, int joint, float weight, Span<float> mask)
    {
        Require(skeleton, joint);
        Finite.Require(weight, nameof(weight));
        PoseCheck.Mask(mask, skeleton.Count);
        ReadOnlySpan<int> parents = skeleton.Parents;
        for (int i = 0; i < mask.Length; i++)
        {
            mask[i] = i < joint ? 0f : i == joint ? weight : parents[i] < joint ? 0f : mask[parents[i]];
        }
    }

    /// <summary>Puts one joint in model space, its parent being there.</summary>
    internal static void Place(int parent, int joint, in Pose local, in Pose model)
    {
        if (parent < 0)
        {
            model.Rotations[joint] = local.Rotations[joint];
            model.Positions[joint] = local.Positions[joint];
            return;
        }

        Quaternion turn = model.Rotations[parent];
        model.Rotations[joint] = Rotation.Multiply(turn, local.Rotations[joint]);
        model.Positions[joint] = model.Positions[parent] + Rotation.Rotate(turn, local.Positions[joint]);
    }

    private static void Require(Skeleton skeleton, int joint)
    {
        if ((uint)joint >= (uint)skeleton.Count)
        {
            throw new ArgumentOutOfRangeException(nameof(joint), FormattableString.Invariant($"joint {joint}; expected 0 to {skeleton.Count - 1}"));
        }
    }
}
