using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Flying;

/// <summary>How a creature flies, worked out once from its build: its wings, their tempo, its legs, neck and tail. Immutable, and safe to share between threads.</summary>
internal sealed class FlightProfile
{
    /// <summary>That which its tempo and speeds are given for.</summary>
    private const double Gravity = StandardGravity.Acceleration;
    private const double AirDensity = 1.225;

    /// <summary>Pairs of one kind that are held as a fan; all behind them trail like the last. More of them spread as a fan were upright in the middle, a row of pegs along the belly.</summary>
    private const int FannedPairs = 3;

    /// <summary>Mass of a flier over that of a solid body of the same shape: feathers, air sacs and thin bones.</summary>
    private const double Lightness = 0.3;

    /// <summary>Coefficient of f = k·√m/S for insects, after the fit of one law from insects to whales (Jensen, Dyre and Hecksher 2024).</summary>
    private const double BuzzCoefficient = 0.75;

    private const double SlowestBuzz = 6;
    private const double FastestBeat = 15;
    private const double SlowestBeat = 0.35;

    /// <summary>Beats per second above which birds beat steadily; below, they beat and glide by turns.</summary>
    private const double SteadyBeat = 6;

    /// <summary>Length of the cycle of hovering up and down, and of beating and gliding, in √(span/g).</summary>
    private const double SlowCycle = 5;

    /// <summary>Area of all wings over the square of the span: of dragonflies at most, and of butterflies and moths at least.</summary>
    private const double NarrowWings = 0.17;
    private const double BroadWings = 0.22;

    /// <summary>Thrust over weight for each beat in the time √(span/g), and its bounds; that of insects.</summary>
    private const double PowerPerBeat = 0.3;
    private const double MinThrust = 0.3;
    private const double MaxThrust = 0.7;
    private const double BuzzingThrust = 0.8;

    /// <summary>Braking by wings against the air, in parts of thrust.</summary>
    private const double BrakingFraction = 1.2;

    /// <summary>What lift is left over weight to climb faster or to end a fall, in parts of gravity.</summary>
    private const double Lift = 0.6;

    /// <summary>Lift over drag in a glide at cruise.</summary>
    private const double GlideRatio = 8;

    /// <summary>Beats in which thrust comes up.</summary>
    private const double ThrustRise = 0.5;

    private readonly WingPair[] wings;
    private readonly BuzzPair[] buzzers;
    private readonly FlightLegs[] legs;
    private readonly Vector3 pelvis;

    private FlightProfile(MotionSubject subject)
    {
        Skeleton = subject.Skeleton;
        Chain = AxialChain.Of(subject.Skeleton, subject.Bones);
        Axis = new FlightAxis(Skeleton, Chain);
        pelvis = Skeleton.FirstOf(JointRole.Pelvis) is int at and >= 0 ? Skeleton.ModelPositions[at] : Chain.BodyPivot;
        Posture = StandingPosture.Of(subject);
        double area = WingArea(subject);
        Fitting(subject, new FoldRoom(subject, Posture, Chain.Length), area, out wings, out buzzers, out legs, out double span);
        Buzzes = wings.Length == 0;
        Shoulder = ShoulderOf(subject);
        double mass = Math.Max(Lightness * subject.Mass.Mass, 1e-9);
        area = Math.Max(area, 0.02 * span * span);
        WingSpan = (float)span;
        WingSurface = (float)area;
        double frequency = Buzzes
            ? Math.Max(BuzzCoefficient * Math.Sqrt(mass) / area, SlowestBuzz)
            : PortableMath.Pow(mass, 3.0 / 8) * Math.Sqrt(Gravity) * PortableMath.Pow(span, -23.0 / 24) * PortableMath.Pow(area, -1.0 / 3) * PortableMath.Pow(AirDensity, -3.0 / 8);
        frequency = Scalar.Clamp(frequency, SlowestBeat, FastestBeat);
        BeatFrequency = (float)frequency;
        BeatsPerCycle = Math.Max(1, (int)Math.Floor((frequency * SlowCycle * Math.Sqrt(span / Gravity)) + 0.5));
        GlidesBetweenBeats = !Buzzes && frequency < SteadyBeat;
        CruiseSpeed = Math.Max(subject.DefaultSpeed, 1e-3f);
        double length = 0;
        SoleHeight = double.MaxValue;
        foreach (FlightLegs leg in legs)
        {
            if (leg.Stands)
            {
                length = Math.Max(length, leg.Length);
                SoleHeight = Math.Min(SoleHeight, leg.Sole);
            }
        }

        Stands = length > 0;
        SoleHeight = Stands ? SoleHeight : 0;
        LegLength = (float)(Stands ? length : 0.3 * Chain.Length);
        Response = 4 / Math.Sqrt(Math.Max(Chain.Length, 1e-3));
        double power = PowerPerBeat * frequency * Math.Sqrt(span / Gravity);
        Thrust = Buzzes ? BuzzingThrust : Scalar.Clamp(power, MinThrust, MaxThrust);
        Braking = BrakingFraction * Thrust;
    }

    /// <summary>From tip to tip of the spread wings, metres.</summary>
    public float WingSpan { get; }

    /// <summary>Area of all wings, square metres.</summary>
    public float WingSurface { get; }

    /// <summary>Beats per second at cruise in standard gravity.</summary>
    public float BeatFrequency { get; }

    /// <summary>Beats after which the motion repeats exactly under steady input: a flier that hovers rises and sinks once in them, and one that glides between beats glides once.</summary>
    public int BeatsPerCycle { get; }

    /// <summary>Metres per second at cruise in standard gravity.</summary>
    public float CruiseSpeed { get; }

    internal Skeleton Skeleton { get; }

    internal AxialChain Chain { get; }

    internal FlightAxis Axis { get; }

    internal WingForce Force { get; } = new();

    internal bool Buzzes { get; }

    internal bool GlidesBetweenBeats { get; }

    internal bool Stands { get; }

    internal float LegLength { get; }

    /// <summary>How it holds its trunk where it stands.</summary>
    internal StandingPosture Posture { get; }

    /// <summary>How far the body goes down before it leaps, metres.</summary>
    internal double CrouchDepth => 0.30 * LegLength;

    /// <summary>Joint of the left wing's root.</summary>
    internal int Shoulder { get; }

    /// <summary>Height of the lowest sole at rest, metres: 0 but for legs that hang free; to stand on these the body comes down by so much.</summary>
    internal double SoleHeight { get; }

    /// <summary>Sharpness with which the motion follows its input in standard gravity, 1/s.</summary>
    internal double Response { get; }

    /// <summary>Greatest acceleration ahead, in parts of gravity: more the more often its wings beat while it would fall its span.</summary>
    internal double Thrust { get; }

    /// <summary>Greatest deceleration by flared wings, in parts of gravity.</summary>
    internal double Braking { get; }

    /// <summary>How much faster all goes than in standard gravity: tempo and speed alike.</summary>
    internal static double Tempo(double gravity) => Math.Sqrt(gravity / Gravity);

    /// <summary>Beats per second at cruise in a gravity.</summary>
    internal double BeatsIn(double gravity) => Math.Min(BeatFrequency * Tempo(gravity), FastestBeat);

    /// <summary>Metres per second at cruise in a gravity.</summary>
    internal double CruiseIn(double gravity) => CruiseSpeed * Tempo(gravity);

    /// <summary>What bounds how it gets faster and slower ahead in a gravity.</summary>
    internal MomentumLimits MomentumIn(double gravity)
    {
        double cruise = CruiseIn(gravity);
        double thrust = Thrust * gravity;
        return new MomentumLimits(thrust, Braking * gravity, gravity / (GlideRatio * cruise * cruise), thrust * BeatsIn(gravity) / ThrustRise);
    }

    /// <summary>What bounds how it comes to climb and to sink in a gravity.</summary>
    internal MomentumLimits LiftIn(double gravity) => new(Lift * gravity, Lift * gravity, 0, Lift * gravity * BeatsIn(gravity) / ThrustRise);

    internal ReadOnlySpan<WingPair> Wings => wings;

    internal ReadOnlySpan<BuzzPair> Buzzers => buzzers;

    internal ReadOnlySpan<FlightLegs> Legs => legs;

    /// <summary>How far the body's joint goes as the trunk is raised about the pelvis by an angle in radians.</summary>
    internal Vector3 Raise(double angle)
    {
        Vector3 arm = Chain.BodyPivot - pelvis;
        return Rotation.Rotate(AxisRotation.Pitch(-angle), arm) - arm;
    }

    /// <summary>Works out how a creature flies.</summary>
    /// <exception cref="ArgumentException">It has no wings, or its skeleton lacks a body, a head or a tail.</exception>
    public static FlightProfile Of(MotionSubject subject)
    {
        if (subject == null)
        {
            throw new ArgumentNullException(nameof(subject));
        }

        return new FlightProfile(subject);
    }

    private static void Fitting(MotionSubject subject, FoldRoom room, double area, out WingPair[] wings, out BuzzPair[] buzzers, out FlightLegs[] legs, out double span)
    {
        var stitched = new List<PairedChain>();
        var thin = new List<PairedChain>();
        var limbs = new List<PairedChain>();
        span = 0;
        foreach (LimbChain limb in subject.Limbs)
        {
            PairedChain? pair = PairedChain.Of(subject.Skeleton, limb);
            if (pair == null)
            {
                continue;
            }

            switch (limb.Kind)
            {
                case LimbKind.Wing:
                    stitched.Add(pair);
                    span = Math.Max(span, Spread(pair));
                    break;
                case LimbKind.InsectWing:
                    thin.Add(pair);
                    span = Math.Max(span, Spread(pair));
                    break;
                case LimbKind.Leg:
                case LimbKind.Arm:
                    limbs.Add(pair);
                    break;
            }
        }

        if (span <= 0)
        {
            throw new ArgumentException("the creature has no wings; expected at least one pair to fly with", nameof(subject));
        }

        thin.Sort((a, b) => b.Points[0].Z.CompareTo(a.Points[0].Z));
        wings = WingPair.Folded(subject, stitched, subject.HasMembranes ? FoldRange.Hung : FoldRange.Stitched, room);
        buzzers = new BuzzPair[thin.Count];
        double breadth = Scalar.Smooth(((area / (span * span)) - NarrowWings) / (BroadWings - NarrowWings));
        for (int k = 0; k < buzzers.Length; k++)
        {
            buzzers[k] = new BuzzPair(thin[k], FoldedWing.Of(subject, thin[k], ThinWingBlade.RestIncidence(thin[k].Axes[0]), 0, k == 0 ? FoldRange.Thin : FoldRange.ThinHind, room), k, breadth);
        }

        legs = new FlightLegs[limbs.Count];
        for (int k = 0; k < legs.Length; k++)
        {
            legs[k] = new FlightLegs(limbs[k], PlaceOf(limbs[k], limbs));
        }
    }

    /// <summary>Where a pair is among those of its kind, from 0 for the first to 1 for the last and all that trail like it; null for the only one.</summary>
    private static double? PlaceOf(PairedChain pair, List<PairedChain> all)
    {
        int ahead = 0;
        int others = 0;
        foreach (PairedChain other in all)
        {
            if (!ReferenceEquals(other, pair) && other.Limb.Archetype == pair.Limb.Archetype)
            {
                others++;
                ahead += other.Points[0].Z > pair.Points[0].Z ? 1 : 0;
            }
        }

        return others == 0 ? null : Math.Min(1.0, (double)ahead / Math.Min(others, FannedPairs - 1));
    }

    private static int ShoulderOf(MotionSubject subject)
    {
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind is LimbKind.Wing or LimbKind.InsectWing && limb.Side == Side.Left)
            {
                return limb.Joints[0];
            }
        }

        return 0;
    }

    private static double Spread(PairedChain wing) => 2 * (wing.Points[0].X + wing.Reach);

    /// <summary>Half the area of the skin that the joints of the wings move most: wings have two faces.</summary>
    private static double WingArea(MotionSubject subject)
    {
        double area = 0;
        CreatureMesh mesh = subject.Mesh;
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            int a = mesh.Triangles[t];
            int b = mesh.Triangles[t + 1];
            int c = mesh.Triangles[t + 2];
            if (OnWing(subject, mesh.Weights[a]) && OnWing(subject, mesh.Weights[b]) && OnWing(subject, mesh.Weights[c]))
            {
                Vector3 p = mesh.Positions[a];
                area += 0.25 * Vec.Length(Vec.Cross(mesh.Positions[b] - p, mesh.Positions[c] - p));
            }
        }

        return area;
    }

    private static bool OnWing(MotionSubject subject, in SkinWeights weights) => subject.Skeleton.Joints[weights.Joint0].Role == JointRole.Wing;
}
