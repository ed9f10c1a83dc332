using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Skinning;

/// <summary>Four joints and their weights. Weights are in descending order and sum to one; unused slots are joint 0 with weight 0.</summary>
/// <remarks>Joints are kept in two bytes each: with four the weights of a surface are an array that the collector treats as a large one, and clears up everything for (of what a creature asks for as large arrays a fifth).</remarks>
public readonly struct SkinWeights
{
    private readonly short joint0;
    private readonly short joint1;
    private readonly short joint2;
    private readonly short joint3;

    /// <summary>Takes the four influences as they are.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A joint has a number outside -32768..32767.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SkinWeights(int joint0, int joint1, int joint2, int joint3, Vector4 weights)
    {
        this.joint0 = (short)joint0;
        this.joint1 = (short)joint1;
        this.joint2 = (short)joint2;
        this.joint3 = (short)joint3;
        Weights = weights;
        if (Joint0 != joint0 || Joint1 != joint1 || Joint2 != joint2 || Joint3 != joint3)
        {
            Refuse(joint0, joint1, joint2, joint3);
        }
    }

    /// <summary>Joint of the largest weight.</summary>
    public int Joint0 => joint0;

    /// <summary>Joint of the second weight.</summary>
    public int Joint1 => joint1;

    /// <summary>Joint of the third weight.</summary>
    public int Joint2 => joint2;

    /// <summary>Joint of the fourth weight.</summary>
    public int Joint3 => joint3;

    /// <summary>The four weights.</summary>
    public Vector4 Weights { get; }

    private static void Refuse(int joint0, int joint1, int joint2, int joint3) => throw new ArgumentOutOfRangeException(
        nameof(joint0), FormattableString.Invariant($"joints {joint0}, {joint1}, {joint2} and {joint3}; expected none outside {short.MinValue}..{short.MaxValue}"));
}
