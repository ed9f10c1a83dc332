using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Slithering;

/// <summary>How a creature crawls without legs, worked out once from its build. Immutable, and safe to share between threads.</summary>
/// <remarks>
/// The track is a serpenoid curve: its heading swings as α·cos 2πσ/λ with the way σ along it (Hirose 1993). A body holds one and a half waves; α is 0.85, less where joints do not bend
/// so far. Along its middle line it gets on by J₀(α) of the way along its body, with J₀ the Bessel function.
/// </remarks>
internal sealed class SlitherProfile
{
    private const double Winding = 0.85;
    private const double SidewindWinding = 1.1;

    /// <summary>How much more than a serpenoid curve the track of sidewinding bends at most, see <see cref="TrackSteering.Swing"/>.</summary>
    private const double SidewindBend = 1.46;

    private const double MinWinding = 0.25;
    private const double WavesPerBody = 1.5;
    private const double LimitFraction = 0.84;

    /// <summary>Of the widest winding that the joints allow, how much undulation takes: bones bent less follow the track more closely.</summary>
    private const double WindingFraction = 0.88;

    private const double TurnPerBody = 2.2;

    private readonly double[] lengths;
    private readonly double[] heights;
    private readonly double[] neckFractions;

    private SlitherProfile(MotionSubject subject)
    {
        Skeleton = subject.Skeleton;
        Chain = AxialChain.Of(subject.Skeleton, subject.Bones);
        int count = Chain.Count;
        lengths = new double[count];
        heights = new double[count];
        for (int b = 0; b < count; b++)
        {
            ref readonly AxialBone bone = ref Chain.Bones[b];
            lengths[b] = Math.Max(bone.Front.Z - bone.Rear.Z, 1e-3 * Chain.Length);
            heights[b] = bone.Middle.Y;
        }

        while (NeckBones + 1 < count && subject.Skeleton.Joints[Chain.Bones[NeckBones].Turn.Joint].Role is JointRole.Head or JointRole.Neck)
        {
            NeckBones++;
        }

        neckFractions = new double[NeckBones];
        for (int b = NeckBones - 1; b >= 0; b--)
        {
            JointLimit limit = Skeleton.Joints[Chain.Bones[b].Turn.Joint].Limit;
            NeckReach += Math.Min(limit.SwingZ.Max, -limit.SwingZ.Min);
            neckFractions[b] = NeckReach;
        }

        for (int b = 0; b < NeckBones; b++)
        {
            neckFractions[b] = NeckReach > 0 ? neckFractions[b] / NeckReach : (double)(NeckBones - b) / NeckBones;
        }

        BodyLength = (float)Chain.Length;
        Wavelength = (float)(Chain.Length / WavesPerBody);
        double room = Room();
        Alpha = Math.Min(Winding, WindingFraction * room);
        SidewindAlpha = Math.Min(SidewindWinding, room / SidewindBend);
        TightestTurn = TurnPerBody / Chain.Length;
        CruiseSpeed = subject.DefaultSpeed;
    }

    /// <summary>From nose to tail, metres.</summary>
    public float BodyLength { get; }

    /// <summary>Way along the track from one bend to the next to the same side, metres.</summary>
    public float Wavelength { get; }

    /// <summary>Metres per second at a comfortable crawl.</summary>
    public float CruiseSpeed { get; }

    internal Skeleton Skeleton { get; }

    internal AxialChain Chain { get; }

    /// <summary>Number of the bones of head and neck, which lead the chain.</summary>
    internal int NeckBones { get; }

    /// <summary>Share of a bend of the whole neck that is made behind each bone of it: by what their joints can turn aside.</summary>
    internal ReadOnlySpan<double> NeckFractions => neckFractions;

    /// <summary>How far the joints of head and neck turn aside together, radians.</summary>
    internal double NeckReach { get; }

    /// <summary>Greatest angle between the track and its middle line, radians.</summary>
    internal double Alpha { get; }

    /// <summary>The same for sidewinding.</summary>
    internal double SidewindAlpha { get; }

    /// <summary>Curvature of the tightest turn, 1/m.</summary>
    internal double TightestTurn { get; }

    /// <summary>Length of each bone along the body.</summary>
    internal ReadOnlySpan<double> Lengths => lengths;

    /// <summary>Height of the middle of each bone over the ground at rest, metres.</summary>
    internal ReadOnlySpan<double> Heights => heights;

    /// <summary>Works out how a creature crawls. Any creature can; those with legs drag them.</summary>
    /// <exception cref="ArgumentException">The skeleton lacks a body, a head or a tail.</exception>
    public static SlitherProfile Of(MotionSubject subject)
    {
        if (subject == null)
        {
            throw new ArgumentNullException(nameof(subject));
        }

        return new SlitherProfile(subject);
    }

    /// <summary>Share of the way along the body that it gets on along the middle line: J₀(α), by its series.</summary>
    internal static double Progress(double alpha)
    {
        double q = alpha * alpha / 4;
        return 1 - (q * (1 - (q / 4 * (1 - (q / 9 * (1 - (q / 16)))))));
    }

    /// <summary>The widest winding in which all joints behind the head stay within their limits: two bones in a bend of curvature α·2π/λ.</summary>
    private double Room()
    {
        double alpha = SidewindWinding;
        for (int b = 1; b + 1 < Chain.Count; b++)
        {
            ReadOnlySpan<AxialBone> bones = Chain.Bones;
            int child = bones[b + 1].Parent == b ? b + 1 : b;
            JointLimit limit = Skeleton.Joints[bones[child].Turn.Joint].Limit;
            double max = LimitFraction * Math.Min(limit.SwingZ.Max, -limit.SwingZ.Min);
            double turn = PortableMath.Pi * (lengths[b] + lengths[b + 1]) / Wavelength;
            alpha = Math.Min(alpha, max / turn);
        }

        return Math.Max(alpha, MinWinding);
    }
}
