using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A number that changes along a chain, from its root through its middle to its tip, smoothly.</summary>
public readonly struct ChainCurve
{
    private readonly float root;
    private readonly float middle;
    private readonly float tip;

    /// <summary>The same number all along.</summary>
    /// <exception cref="ArgumentException">The number is not finite.</exception>
    public ChainCurve(float all)
        : this(all, all, all)
    {
    }

    /// <summary>Evenly from root to tip.</summary>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public ChainCurve(float root, float tip)
        : this(root, 0.5f * (root + tip), tip)
    {
    }

    /// <summary>The parabola through three numbers.</summary>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public ChainCurve(float root, float middle, float tip)
    {
        Finite.Require(root, nameof(root));
        Finite.Require(middle, nameof(middle));
        Finite.Require(tip, nameof(tip));
        this.root = root;
        this.middle = middle;
        this.tip = tip;
    }

    /// <summary>The number at a place, 0 the root, 1 the tip.</summary>
    public float At(float along)
    {
        float bend = (2f * (root + tip)) - (4f * middle);
        float slope = tip - root - bend;
        return root + (along * (slope + (along * bend)));
    }

    /// <summary>Whether two curves are the same.</summary>
    internal bool Is(ChainCurve other) => root == other.root && middle == other.middle && tip == other.tip;
}
