using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>How a creature swims, worked out once from its build: its style, its wave, its fins and legs and the tempo of its size. Immutable, and safe to share between threads.</summary>
internal sealed class SwimProfile
{
    /// <summary>Share of a joint's range that the wave at its widest may take; the rest is for turns.</summary>
    private const double LimitFraction = 0.84;

    /// <summary>Bones behind the chest from which on a body undulates as a whole: the rig gives such bodies more.</summary>
    private const int WavingBones = 18;

    /// <summary>Heights of the tail's end below which it is an upright fin.</summary>
    private const double FinThinness = 0.45;

    /// <summary>Heights of the tail's end above which it is a fluke if it is so wide, and its least width in body lengths.</summary>
    private const double FlukeFlatness = 1.6;
    private const double FlukeWidth = 0.15;

    /// <summary>Cruises by which one beat at cruise makes it faster from rest, and by how much of that its fins brake.</summary>
    private const double PushOff = 1.2;
    private const double BrakingFraction = 0.45;

    /// <summary>How many times as quickly as it comes a push is let go of: in the middle of a stroke.</summary>
    private const double LettingGo = 4;

    /// <summary>Beats at cruise in which thrust comes up.</summary>
    private const double PushRise = 0.25;

    /// <summary>Friction of the water on the skin: some five times that of a stiff plate, for bodies that bend.</summary>
    private const double SkinFriction = 0.02;

    /// <summary>Volume over that of the box around the body's round section: a spindle's.</summary>
    private const double Spindle = 0.47;

    /// <summary>Fastest turn on the spot, radians for each beat at cruise, and on the way, radians for each body length.</summary>
    private const double StandingTurn = 1.5;
    private const double TurnPerLength = 2.5;

    private readonly SwimFin[] fins;
    private readonly SwimLeg[] legs;
    private readonly MedianFin[] medianFins;
    private readonly SwimDisc[] rows;

    private SwimProfile(MotionSubject subject, AxialChain chain, SwimStyle style)
    {
        Chain = chain;
        Skeleton = subject.Skeleton;
        Style = style;
        Kinematics = SwimKinematics.Of(style);
        BodyLength = (float)chain.Length;
        Wave = new SwimWave(chain, style, Kinematics);
        Wave.Scale(RoomForWave(subject.Skeleton, chain, Wave, style));
        Curl = RoomForCurl(subject.Skeleton, chain);
        Fitting(subject, out fins, out medianFins, out rows);
        legs = SwimLeg.Of(subject, chain);
        TailBeat = (float)(2 * Wave.TailReach);
        if (style == SwimStyle.Flippers)
        {
            // Flippers do the work of the tail.
            foreach (SwimFin fin in fins)
            {
                TailBeat = Math.Max(TailBeat, (float)fin.TipWay);
            }
        }

        foreach (SwimDisc row in rows)
        {
            TailBeat = Math.Max(TailBeat, (float)row.EdgeWay);
        }

        // A swimmer's speed is that which it was grown with, and its tempo that which brings it there; others swim as their size has it.
        double beat = TailBeat / Kinematics.Strouhal;
        CruiseSpeed = subject.Kind == LocomotionKind.Swimming ? subject.DefaultSpeed : (float)(Kinematics.Frequency(chain.Length) * beat);
        CruiseFrequency = (float)(CruiseSpeed / beat);
        Momentum = MomentumOf(subject.Mass.Volume);
    }

    /// <summary>What drives it.</summary>
    public SwimStyle Style { get; }

    /// <summary>From nose to tail, metres.</summary>
    public float BodyLength { get; }

    /// <summary>Beats per second at cruise.</summary>
    public float CruiseFrequency { get; }

    /// <summary>Metres per second at cruise.</summary>
    public float CruiseSpeed { get; }

    /// <summary>From side to side of the tail's tip (of a flipper's or a disc's edge, for swimmers that row) at cruise, metres.</summary>
    public float TailBeat { get; }

    /// <summary>What bounds how it gets faster and slower.</summary>
    internal MomentumLimits Momentum { get; }

    internal Skeleton Skeleton { get; }

    internal AxialChain Chain { get; }

    /// <summary>Bend of the whole body at the height of a C-start, radians.</summary>
    internal double Curl { get; }

    internal SwimKinematics Kinematics { get; }

    internal SwimWave Wave { get; }

    internal ReadOnlySpan<SwimFin> Fins => fins;

    internal ReadOnlySpan<SwimLeg> Legs => legs;

    internal ReadOnlySpan<MedianFin> MedianFins => medianFins;

    /// <summary>The rows of a disc, from the front; none of other bodies.</summary>
    internal ReadOnlySpan<SwimDisc> Rows => rows;

    /// <summary>Whether the wave of its axis goes up and down.</summary>
    internal bool IsVertical => Style is SwimStyle.Cetacean or SwimStyle.Disc;

    /// <summary>Whether its fins do the work of its body, which beats little.</summary>
    internal bool IsStiff => Style is SwimStyle.Flippers or SwimStyle.Disc;

    /// <summary>Works out how a creature swims. Any creature can: those not built for it swim as their shape allows.</summary>
    /// <exception cref="ArgumentException">The skeleton lacks a body, a head or a tail.</exception>
    public static SwimProfile Of(MotionSubject subject)
    {
        if (subject == null)
        {
            throw new ArgumentNullException(nameof(subject));
        }

        AxialChain chain = AxialChain.Of(subject.Skeleton, subject.Bones);
        return new SwimProfile(subject, chain, StyleOf(subject, chain));
    }

    /// <summary>Fastest turn at a speed, rad/s: about its own middle by its fins, and the tighter the faster the arc that its body bends to.</summary>
    internal double FastestTurn(double speed) => (StandingTurn * CruiseFrequency) + (TurnPerLength * Math.Abs(speed) / BodyLength);

    /// <summary>A level fluke beats up and down; two and more pairs of flippers without a fin on back or tail row; a body of many bones, or one without limbs, undulates as a whole; all others beat their tails.</summary>
    private static SwimStyle StyleOf(MotionSubject subject, AxialChain chain)
    {
        int pairs = 0;
        int legs = 0;
        int upright = 0;
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind == LimbKind.Disc)
            {
                return SwimStyle.Disc;
            }

            pairs += limb.Kind == LimbKind.Pectoral && limb.Side == Side.Left ? 1 : 0;
            legs += limb.Kind is LimbKind.Leg or LimbKind.Arm ? 1 : 0;
            upright += limb.Kind == LimbKind.Dorsal ? 1 : 0;
        }

        int bones = 0;
        bool crawls = false;
        foreach (AxialBone bone in chain.Bones)
        {
            JointRole role = subject.Skeleton.Joints[bone.Turn.Joint].Role;
            bones += role is JointRole.Spine or JointRole.Tail ? 1 : 0;
            crawls |= role == JointRole.Pelvis && legs == 0;
        }

        TailEnd(subject, chain, out double width, out double height);
        return subject.Plan == BodyPlan.Whale || (width > FlukeFlatness * height && width > FlukeWidth * chain.Length) ? SwimStyle.Cetacean
            : pairs > 1 && upright == 0 && width > FinThinness * height ? SwimStyle.Flippers
            : crawls || bones >= WavingBones ? SwimStyle.Anguilliform
            : SwimStyle.Carangiform;
    }

    /// <summary>Width and height of the skin that the last two bones move.</summary>
    private static void TailEnd(MotionSubject subject, AxialChain chain, out double width, out double height)
    {
        int last = chain.Bones[chain.Count - 1].Turn.Joint;
        int before = subject.Skeleton.Parents[last];
        float side = 0f;
        float top = float.MinValue;
        float bottom = float.MaxValue;
        for (int v = 0; v < subject.Mesh.Positions.Length; v++)
        {
            int joint = subject.Mesh.Weights[v].Joint0;
            if (joint == last || joint == before)
            {
                Vector3 p = subject.Mesh.Positions[v];
                side = Math.Max(side, Math.Abs(p.X));
                top = Math.Max(top, p.Y);
                bottom = Math.Min(bottom, p.Y);
            }
        }

        width = 2 * side;
        height = Math.Max(top - bottom, 0f);
    }

    /// <summary>Factor by which the wave has to narrow for all joints to stay within their limits.</summary>
    private static double RoomForWave(Skeleton skeleton, AxialChain chain, SwimWave wave, SwimStyle style)
    {
        double factor = 1;
        for (int b = 0; b + 1 < chain.Count; b++)
        {
            // The joint between two bones is that of the one carried by the other.
            ReadOnlySpan<AxialBone> bones = chain.Bones;
            int child = bones[b + 1].Parent == b ? b + 1 : b;
            JointLimit limit = skeleton.Joints[bones[child].Turn.Joint].Limit;
            AngleRange range = style is SwimStyle.Cetacean or SwimStyle.Disc ? limit.SwingX : limit.SwingZ;
            double max = Math.Min(range.Max, -range.Min);

            // The bend grows faster than the width: a few steps of the rule of three settle it.
            for (int pass = 0; pass < 4; pass++)
            {
                double bend = wave.Bend(b, factor * SwimMotion.WidestBeat);
                factor *= Math.Min(1, LimitFraction * max / Math.Max(bend, 1e-9));
            }
        }

        for (int b = 0; b < chain.Count; b++)
        {
            factor = Math.Min(factor, SwimWave.Steepest / (SwimMotion.WidestBeat * wave.Steepness(b)));
        }

        return factor;
    }

    /// <summary>Deepest bend from nose to tail, spread evenly, that leaves all joints within their limits.</summary>
    private static double RoomForCurl(Skeleton skeleton, AxialChain chain)
    {
        double max = EscapeCurve.Curl;
        for (int b = 0; b + 1 < chain.Count; b++)
        {
            ReadOnlySpan<AxialBone> bones = chain.Bones;
            int child = bones[b + 1].Parent == b ? b + 1 : b;
            AngleRange range = skeleton.Joints[bones[child].Turn.Joint].Limit.SwingZ;
            double fraction = (bones[b].Middle.Z - bones[b + 1].Middle.Z) / chain.Length;
            max = Math.Min(max, LimitFraction * Math.Min(range.Max, -range.Min) / Math.Max(fraction, 1e-6));
        }

        return max;
    }

    /// <summary>
    /// Thrust is what a beat gives a body of that tempo and cruise. Drag is that of a spindle of its length and volume: ½·C·S/V with C = 0.02·(1 + 1.5 r^1.5 + 7 r³), r its thickness over its length
    /// (Hoerner 1965), S = ¾πdL its skin and V = 0.47 d²L: thick bodies glide far.
    /// </summary>
    private MomentumLimits MomentumOf(double volume)
    {
        double thickness = Math.Sqrt(Math.Max(volume, 1e-12) / (Spindle * BodyLength));
        double ratio = Math.Min(thickness / BodyLength, 1);
        double friction = SkinFriction * (1 + (1.5 * ratio * Math.Sqrt(ratio)) + (7 * ratio * ratio * ratio));
        double thrust = PushOff * CruiseSpeed * CruiseFrequency;
        return new MomentumLimits(thrust, BrakingFraction * thrust, 0.5 * friction * 0.75 * PortableMath.Pi / (Spindle * thickness), thrust * CruiseFrequency / PushRise) { LettingGo = LettingGo };
    }

    private void Fitting(MotionSubject subject, out SwimFin[] paired, out MedianFin[] median, out SwimDisc[] discs)
    {
        var pairs = new List<SwimFin>();
        var singles = new List<MedianFin>();
        var halves = new List<SwimDisc>();
        foreach (LimbChain limb in subject.Limbs)
        {
            float at = (Chain.Nose.Z - subject.Skeleton.ModelPositions[limb.Joints[0]].Z) / BodyLength;
            if (limb.Kind == LimbKind.Pectoral && PairedChain.Of(subject.Skeleton, limb) is { } chain)
            {
                pairs.Add(new SwimFin(chain, at));
            }
            else if (limb.Kind == LimbKind.Disc && PairedChain.Of(subject.Skeleton, limb) is { } row)
            {
                halves.Add(new SwimDisc(row, halves.Count));
            }
            else if (limb.Kind is LimbKind.Dorsal or LimbKind.Ventral)
            {
                singles.Add(new MedianFin(subject.Skeleton, limb, at));
            }
        }

        paired = pairs.ToArray();
        median = singles.ToArray();
        discs = halves.ToArray();
    }
}
