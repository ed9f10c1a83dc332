using System.Numerics;

namespace CreatureGen.Skinning;

/// <summary>Four joints and their weights. Weights are in descending order and sum to one; unused slots are joint 0 with weight 0.</summary>
public readonly struct SkinWeights
{
    /// <summary>Takes the four influences as they are.</summary>
    public SkinWeights(int joint0, int joint1, int joint2, int joint3, Vector4 weights)
    {
        Joint0 = joint0;
        Joint1 = joint1;
        Joint2 = joint2;
        Joint3 = joint3;
        Weights = weights;
    }

    /// <summary>Joint of the largest weight.</summary>
    public int Joint0 { get; }

    /// <summary>Joint of the second weight.</summary>
    public int Joint1 { get; }

    /// <summary>Joint of the third weight.</summary>
    public int Joint2 { get; }

    /// <summary>Joint of the fourth weight.</summary>
    public int Joint3 { get; }

    /// <summary>The four weights.</summary>
    public Vector4 Weights { get; }
}
