using System;
using System.Numerics;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Where the feet of a body are that lies on its belly: its legs folded as its joints let them, and those of an upright one stretched out behind. One entry for each leg, in the order of its legs.</summary>
internal sealed class FoldedLegs
{
    /// <summary>How high a foot goes on its way, metres over the length of that way: one that is drawn back slides along the ground, below its hip.</summary>
    private const float FoldedArch = 0.12f;
    private const float StretchedArch = 0.04f;

    public FoldedLegs(int legs)
    {
        Folded = new FootWays(legs, FoldedArch);
        Stretched = new FootWays(legs, StretchedArch);
        DrawnIn = new FootWays(legs, 0f);
    }

    /// <summary>Folded under the body.</summary>
    public FootWays Folded { get; }

    /// <summary>Stretched out behind a body that stands upright otherwise, and lies on its chest.</summary>
    public FootWays Stretched { get; }

    /// <summary>Drawn in to the trunk of a body that rolls over onto its back, which would climb over them.</summary>
    public FootWays DrawnIn { get; }

    /// <summary>How far a trunk rolls over from its belly until it rests on its flank, radians; 0 where it would not stay there.</summary>
    public float Flank { get; set; }

    /// <summary>How far a trunk tips over ahead until it is level, radians: an upright one onto its chest, another as it rolls over onto its back.</summary>
    public float Tip { get; set; }

    /// <summary>Whether they have been found: a body without feet that stand is brought to the ground from then on.</summary>
    public bool IsFound { get; private set; }

    /// <summary>Takes what was found for the same legs; what others took before stays.</summary>
    public void Take(FoldedLegs found)
    {
        lock (Folded)
        {
            if (!IsFound)
            {
                Folded.Take(found.Folded);
                Stretched.Take(found.Stretched);
                DrawnIn.Take(found.DrawnIn);
                Tip = found.Tip;
                Flank = found.Flank;
                IsFound = true;
            }
        }
    }

    /// <summary>Adds a share of them to what is asked of a foot.</summary>
    /// <param name="foot">What is asked of it.</param>
    /// <param name="leg">Its leg.</param>
    /// <param name="folded">How far it is folded, 0..1.</param>
    /// <param name="stretched">How far it is stretched out behind, 0..1.</param>
    /// <param name="drawnIn">How far it is drawn in to the trunk, 0..1.</param>
    /// <param name="over">How far the body is over on its flank, 0..1: there is no ground there that a foot would have to be lifted from, and lifted it would pass its hip.</param>
    public void AddTo(ref FootLayer foot, int leg, float folded, float stretched, float drawnIn, float over)
    {
        Add(Folded, ref foot, leg, folded, 1f - over);
        Add(Stretched, ref foot, leg, stretched, 1f);
        Add(DrawnIn, ref foot, leg, drawnIn, 0f);
    }

    private static void Add(FootWays ways, ref FootLayer foot, int leg, float fraction, float lifted)
    {
        Vector3 way = ways.Ways[leg];
        float level = (float)Math.Sqrt((way.X * way.X) + (way.Z * way.Z));
        way.Y += ways.Arch * level * 4f * (1f - fraction) * lifted;
        foot.Way += way * fraction;
        foot.Pitch += ways.Pitches[leg] * fraction;
        foot.Lean += ways.Leans[leg] * fraction;
        foot.Loose = Math.Max(foot.Loose, fraction);
    }
}

/// <summary>Where feet are, away from where they stand.</summary>
internal sealed class FootWays
{
    public FootWays(int legs, float arch)
    {
        Arch = arch;
        Ways = new Vector3[legs];
        Pitches = new float[legs];
        Leans = new float[legs];
    }

    /// <summary>How high feet go on their ways, metres over the length of a way.</summary>
    public float Arch { get; }

    /// <summary>From where each foot stands, metres.</summary>
    public Vector3[] Ways { get; }

    /// <summary>Toes down, radians.</summary>
    public float[] Pitches { get; }

    /// <summary>How far legs out to the side lie over about the line from hip to foot, the knees ahead, radians.</summary>
    public float[] Leans { get; }

    /// <summary>Takes those of others.</summary>
    public void Take(FootWays others)
    {
        others.Ways.CopyTo(Ways, 0);
        others.Pitches.CopyTo(Pitches, 0);
        others.Leans.CopyTo(Leans, 0);
    }
}
