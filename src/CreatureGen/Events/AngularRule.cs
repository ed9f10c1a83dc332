using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>
/// How to find moments in a motion from the turning of single bones: where a bone's angular acceleration is above a threshold, the moment of its maximum. Data; presets are in <see cref="AngularRules"/>.
/// </summary>
/// <remarks>Based on: "Single Bone Angular Rule", a notify modifier for animation sequences, with the threshold as a power of ten, one moment for each stretch above it, moments of all bones merged, and at most one in an interval.</remarks>
public sealed record AngularRule
{
    /// <summary>A rule with a name of what it finds.</summary>
    /// <param name="name">What happens at these moments, as <c>footstep</c>; not empty.</param>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public AngularRule(string name)
    {
        Name = string.IsNullOrEmpty(name) ? throw new ArgumentException("a rule without a name; expected one, as footstep", nameof(name)) : name;
    }

    /// <summary>What happens at these moments.</summary>
    public string Name { get; }

    /// <summary>Where editors show them: a track of notifies.</summary>
    public string Track { get; init; } = "Events";

    /// <summary>Joints by what they are.</summary>
    public IReadOnlyList<JointRole> Roles { get; init; } = Array.Empty<JointRole>();

    /// <summary>Joints by name; a <c>*</c> stands for any characters. A name that fits no joint is an error.</summary>
    public IReadOnlyList<string> Joints { get; init; } = Array.Empty<string>();

    /// <summary>Names of joints that are left out, with <c>*</c> as above.</summary>
    public IReadOnlyList<string> Excluded { get; init; } = Array.Empty<string>();

    /// <summary>The least angular acceleration, as a power of ten: 3.5 means 10^3.5 ≈ 3162 degrees/s².</summary>
    public double ThresholdPower { get; init; }

    /// <summary>The least angular acceleration, as a part of the greatest that the joint has in the clip, or has had lately; 0 for none. Holds together with <see cref="ThresholdPower"/>, and for creatures of any size.</summary>
    public float ThresholdFraction { get; init; }

    /// <summary>Whose greatest that is a part of: each joint's own, or that of all joints together, so that of many tails and fins only those that beat most are heard. Rules for sweeps towards a direction do without.</summary>
    public IntervalScope FractionScope { get; init; } = IntervalScope.EachJoint;

    /// <summary>How turning is measured.</summary>
    public AngularMeasure Measure { get; init; }

    /// <summary>In what space turning is measured.</summary>
    public AngularSpace Space { get; init; }

    /// <summary>Which changes of turning count.</summary>
    public AngularChange Change { get; init; }

    /// <summary>Looks at how limbs sweep instead of for peaks of acceleration; the threshold is then the least speed of a sweep, degrees per second. For the beginnings of sweeps only joints, interval and offset count besides. None by default.</summary>
    public AngularSweep? Sweep { get; init; }

    /// <summary>Counts only where the joint is turned from its rest by at most this part of its greatest turn in the clip, or lately; 1 counts anywhere. A jaw that stops there is shut.</summary>
    public float NearRest { get; init; } = 1f;

    /// <summary>Seconds below the threshold that do not end a stretch: twin peaks are one moment.</summary>
    public float ChunkGap { get; init; }

    /// <summary>Seconds of quiet, without acceleration above the threshold, that have to follow a stretch; 0 for none. A foot on the ground is quiet, one in the air is not.</summary>
    public float Quiet { get; init; }

    /// <summary>How long that quiet has to be, as a part of the joint's longest in the clip, or lately; 0 for any. Holds together with <see cref="Quiet"/>, and for creatures of any size.</summary>
    public float QuietFraction { get; init; }

    /// <summary>Which peak of a stretch is the moment.</summary>
    public AngularPeak Peak { get; init; }

    /// <summary>Seconds in which there is at most one moment; 0 for any number.</summary>
    public float Interval { get; init; }

    /// <summary>Which moment of an interval stays.</summary>
    public IntervalWinner Winner { get; init; }

    /// <summary>Whether intervals count for each joint alone or for all together.</summary>
    public IntervalScope Scope { get; init; }

    /// <summary>Seconds by which all moments are moved; in a clip that loops around its ends, in others not beyond them.</summary>
    public float Offset { get; init; }

    /// <summary>The rule with threshold, gap, interval and offset as they are for a creature whose motion takes so many times as long: angular accelerations fall with the square of the time, speeds with the time.</summary>
    /// <param name="times">Above 0; about √(leg length) for walkers of one build.</param>
    /// <exception cref="ArgumentOutOfRangeException">It is not above 0.</exception>
    public AngularRule Slowed(float times)
    {
        Finite.RequireWithin(times, 1e-3f, 1e3f, nameof(times));
        double power = (Sweep == null ? 2 : 1) * PortableMath.Log(times) / 2.3025850929940457;
        return this with { ThresholdPower = ThresholdPower - power, ChunkGap = ChunkGap * times, Quiet = Quiet * times, Interval = Interval * times, Offset = Offset * times };
    }

    /// <summary>The least angular acceleration, radians/s², or speed of a sweep, radians/s.</summary>
    internal double Threshold => Scalar.Radians(PortableMath.Exp(ThresholdPower * 2.3025850929940457));

    /// <summary>The rest of a joint in the rule's space.</summary>
    internal Quaternion RestOf(Skeleton skeleton, int joint) => Space == AngularSpace.Model ? skeleton.Joints[joint].ModelRotation : skeleton.Joints[joint].LocalRotation;

    /// <summary>Throws unless all numbers are within their ranges.</summary>
    internal void Require()
    {
        if (!(ThresholdPower >= -12 && ThresholdPower <= 12))
        {
            throw new ArgumentException(FormattableString.Invariant($"rule {Name}: the threshold is 10^{ThresholdPower} degrees/s²; expected a power of -12 to 12"));
        }

        if (!(ThresholdFraction >= 0f && ThresholdFraction <= 1f) || !(QuietFraction >= 0f && QuietFraction <= 1f))
        {
            throw new ArgumentException(FormattableString.Invariant($"rule {Name}: {ThresholdFraction} of the greatest acceleration and {QuietFraction} of the longest quiet; expected fractions of 0 to 1"));
        }

        if (!(NearRest >= 0f && NearRest <= 1f))
        {
            throw new ArgumentException(FormattableString.Invariant($"rule {Name}: near rest is {NearRest}; expected a fraction of 0 to 1"));
        }

        if (!(Interval >= 0f && Interval <= float.MaxValue) || !(ChunkGap >= 0f && ChunkGap <= float.MaxValue) || !(Quiet >= 0f && Quiet <= float.MaxValue))
        {
            throw new ArgumentException(FormattableString.Invariant($"rule {Name}: an interval of {Interval} s, a gap of {ChunkGap} s and a quiet of {Quiet} s; expected finite times not below 0"));
        }

        Finite.Require(Offset, nameof(Offset));
        Sweep?.Require(Name);
        if (Roles.Count + Joints.Count == 0)
        {
            throw new ArgumentException($"rule {Name} names no joint; expected roles or names of joints");
        }
    }
}
