using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>A row of joints in the halves of a disc: they beat like wings, the edge behind the root and the rear rows behind the front one, so that a wave runs back along the edge (rays).</summary>
internal sealed class SwimDisc
{
    private const double Tau = 2 * PortableMath.Pi;

    /// <summary>How far the root and the outer part of a row go up and down at cruise, radians, and how far above level their middle is.</summary>
    private const double Beat = 0.40;
    private const double OuterBeat = 0.42;
    private const double Dihedral = 0.06;

    /// <summary>Part of how far the edge is above its root at rest that is taken back: discs that curl up beat about level, too.</summary>
    private const double Levelled = 0.6;

    /// <summary>How much later each row is than the one before it, and how much the outer joint than the root, radians of the cycle: rays that fly under water have less than half a wave on their edge (Rosenberger 2001).</summary>
    private const double RowLag = 0.75;
    private const double OuterLag = 0.8;

    /// <summary>How much wider the half outside of the tightest turn beats, and how far the halves are cupped to brake, radians.</summary>
    private const double Steering = 0.3;
    private const double Cup = 0.25;

    /// <summary>How far both halves are raised to push off, radians.</summary>
    private const double PushRaise = 0.4;

    /// <summary>Least width of the beat, of that at cruise: standing in the water it keeps itself up.</summary>
    private const double MinWidth = 0.34;

    private readonly PairedChain chain;
    private readonly double lag;
    private readonly double level;

    /// <summary>Takes a row by its number from the front.</summary>
    public SwimDisc(PairedChain chain, int row)
    {
        this.chain = chain;
        lag = row * RowLag;
        Vector3 way = chain.Points[chain.Count] - chain.Points[0];
        level = Dihedral - (Levelled * PortableMath.Atan2(way.Y, way.X) / chain.Count);
    }

    /// <summary>From top to bottom of the edge's way at cruise, metres.</summary>
    public double EdgeWay => 2 * ((PortableMath.Sin(Beat) * chain.Limb.RestLengths[0]) + (PortableMath.Sin(Beat + (0.7 * OuterBeat)) * chain.Limb.RestLengths[1]));

    /// <summary>Writes the joints of both sides.</summary>
    public void Write(in Pose local, in SwimStroke stroke)
    {
        Write(local, Side.Left, stroke);
        Write(local, Side.Right, stroke);
    }

    private void Write(in Pose local, Side side, in SwimStroke stroke)
    {
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        double width = (MinWidth + ((1 - MinWidth) * stroke.Amplitude)) * (1 - (Steering * inside));
        double phase = (Tau * stroke.Phase) - lag;
        double raised = level + (Cup * stroke.Brake) + (PushRaise * stroke.Push);
        chain.Write(local, side, 0, chain.Stroke(0, raised + (Beat * width * PortableMath.Cos(phase)), 0, 0));
        for (int k = 1; k < chain.Count; k++)
        {
            chain.Write(local, side, k, chain.Stroke(k, raised + (OuterBeat * width * PortableMath.Cos(phase - (k * OuterLag))), 0, 0));
        }
    }
}
