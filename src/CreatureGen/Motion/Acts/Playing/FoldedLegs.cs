using System.Numerics;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Where the feet of a body are that lies on its belly: its legs folded as its joints let them. One entry for each leg, in the order of its legs.</summary>
internal sealed class FoldedLegs
{
    /// <summary>How high a foot goes on its way, metres over the length of that way.</summary>
    private const float Arch = 0.35f;

    public FoldedLegs(int legs)
    {
        Ways = new Vector3[legs];
        Pitches = new float[legs];
    }

    /// <summary>From where each foot stands, metres.</summary>
    public Vector3[] Ways { get; }

    /// <summary>Toes down, radians.</summary>
    public float[] Pitches { get; }

    /// <summary>Adds a share of it to what is asked of a foot.</summary>
    public void AddTo(ref FootLayer foot, int leg, float share)
    {
        Vector3 way = Ways[leg];
        float level = (float)System.Math.Sqrt((way.X * way.X) + (way.Z * way.Z));
        way.Y += Arch * level * 4f * (1f - share);
        foot.Way += way * share;
        foot.Pitch += Pitches[leg] * share;
        foot.Loose = System.Math.Max(foot.Loose, share);
    }
}
