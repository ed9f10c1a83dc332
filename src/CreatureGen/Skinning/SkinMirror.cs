using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>Gives the right side of a surface the mirror image of the left side's weights.</summary>
internal static class SkinMirror
{
    /// <summary>Fills in the weights of all vertices with a negative sign.</summary>
    public static void Complete(Surface surface, Skeleton skeleton, SkinWeights[] weights)
    {
        ReadOnlySpan<int> mirrors = skeleton.Mirrors;
        for (int v = 0; v < weights.Length; v++)
        {
            if (surface.Addresses[v].Sign < 0)
            {
                SkinWeights w = weights[surface.Mirror[v]];
                weights[v] = new SkinWeights(mirrors[w.Joint0], mirrors[w.Joint1], mirrors[w.Joint2], mirrors[w.Joint3], w.Weights);
            }
        }
    }
}
