using System;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>A share of two joints that sums to one.</summary>
internal readonly struct SpineBlend
{
    public SpineBlend(int first, int second, float secondWeight)
    {
        First = first;
        Second = second;
        SecondWeight = secondWeight;
    }

    /// <summary>The joint nearer to the nose.</summary>
    public int First { get; }

    /// <summary>The joint nearer to the tail; the same as <see cref="First"/> where one bone moves the skin alone.</summary>
    public int Second { get; }

    /// <summary>0..1.</summary>
    public float SecondWeight { get; }

    /// <summary>The joint with the larger share.</summary>
    public int Dominant => SecondWeight > 0.5f ? Second : First;
}

/// <summary>
/// The bones that move the body's skin, from the nose to the tip of the tail, and the arc lengths at which one gives way to the next (the pivots between them).
/// </summary>
/// <remarks>
/// Around a pivot the skin is shared by smoothstep over ±0.48 of the shorter of the two bones that meet there, in arc length along the spine. Below a half no two
/// such stretches overlap, so never more than two bones share a section.
/// </remarks>
internal sealed class SpineSegments
{
    /// <summary>Half width of the shared stretch, in lengths of the shorter bone.</summary>
    private const double Reach = 0.48;

    private readonly int[] joints;
    private readonly double[] pivots;
    private readonly double length;

    /// <summary>Takes the bones from nose to tail, the arc lengths of the pivots between them (one fewer, ascending), and the arc length of the whole spine.</summary>
    public SpineSegments(int[] joints, double[] pivots, double length)
    {
        this.joints = joints;
        this.pivots = pivots;
        this.length = length;
    }

    /// <summary>Joints of the bones, nose to tail.</summary>
    public ReadOnlySpan<int> Joints => joints;

    /// <summary>Arc length at which a bone begins (nearer the nose).</summary>
    public double Start(int bone) => bone == 0 ? 0 : pivots[bone - 1];

    /// <summary>Arc length at which a bone ends (nearer the tail).</summary>
    public double End(int bone) => bone == pivots.Length ? length : pivots[bone];

    /// <summary>Place of a joint in <see cref="Joints"/>, or −1.</summary>
    public int BoneOf(int joint) => Array.IndexOf(joints, joint);

    /// <summary>Who moves the skin at an arc length from ring 0.</summary>
    public SpineBlend At(double arc)
    {
        int bone = 0;
        while (bone < pivots.Length && pivots[bone] < arc)
        {
            bone++;
        }

        if (bone > 0 && arc - pivots[bone - 1] < HalfWidth(bone - 1))
        {
            return Around(bone - 1, arc);
        }

        if (bone < pivots.Length && pivots[bone] - arc < HalfWidth(bone))
        {
            return Around(bone, arc);
        }

        return new SpineBlend(joints[bone], joints[bone], 0f);
    }

    private SpineBlend Around(int pivot, double arc)
    {
        double half = HalfWidth(pivot);
        return new SpineBlend(joints[pivot], joints[pivot + 1], (float)Scalar.Smooth((arc - pivots[pivot] + half) / (2 * half)));
    }

    private double HalfWidth(int pivot) => Reach * Math.Min(End(pivot) - Start(pivot), End(pivot + 1) - Start(pivot + 1));
}
