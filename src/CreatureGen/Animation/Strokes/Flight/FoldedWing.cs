using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Strokes.Flight;

/// <summary>How wings lie against the body at rest: for each bone the direction and the side that its upper face looks to, for the left wing, model space.</summary>
internal static class FoldedWing
{
    /// <summary>Upper arm back and down, all else straight back along the flank: the leading edge lies low, the trailing edge covers the side up to the back. A wing that is one skin cannot lay its
    /// forearm forward again as birds do: its surface would turn over at the elbow.</summary>
    public static (Vector3 Direction, Vector3 Face)[] Stitched { get; } =
    {
        (new Vector3(0.32f, -0.50f, -0.80f), new Vector3(1f, 0.10f, 0f)),
        (new Vector3(0.06f, 0.12f, -0.99f), new Vector3(1f, 0.10f, 0f)),
        (new Vector3(-0.06f, 0.16f, -0.98f), new Vector3(1f, 0.10f, 0f)),
        (new Vector3(-0.10f, 0.10f, -0.99f), new Vector3(1f, 0.10f, 0f)),
    };

    /// <summary>Flat over the abdomen.</summary>
    public static (Vector3 Direction, Vector3 Face)[] Insect { get; } =
    {
        (new Vector3(0.28f, 0.10f, -0.95f), new Vector3(0.30f, 0.95f, 0f)),
        (new Vector3(0.24f, 0.02f, -0.97f), new Vector3(0.30f, 0.95f, 0f)),
    };

    /// <summary>The turns that fold a left wing as far as its joints allow.</summary>
    public static Quaternion[] Of(PairedChain chain, (Vector3 Direction, Vector3 Face)[] shape)
    {
        var turns = new Quaternion[chain.Count];
        Quaternion carried = Quaternion.Identity;
        for (int k = 0; k < turns.Length; k++)
        {
            (Vector3 direction, Vector3 face) = shape[Math.Min(k, shape.Length - 1)];
            Quaternion rest = JointFrame.Raised(chain.Axes[k], Vector3.UnitY);
            Quaternion target = JointFrame.Raised(direction, face);
            Quaternion wanted = Rotation.Multiply(target, Rotation.Inverse(rest));
            turns[k] = chain.Limit(k, Rotation.Multiply(Rotation.Inverse(carried), wanted));
            carried = Rotation.Normalize(Rotation.Multiply(carried, turns[k]));
        }

        return turns;
    }
}
