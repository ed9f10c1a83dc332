using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Events;

/// <summary>How fast a joint turns over a clip, and how fast that changes; or how fast a limb sweeps. Immutable.</summary>
public sealed class AngularCurve
{
    private readonly float[] speeds;
    private readonly float[] accelerations;
    private readonly bool isSweep;

    internal AngularCurve(string joint, float rate, float[] speeds, float[] accelerations)
    {
        Joint = joint;
        Rate = rate;
        this.speeds = speeds;
        this.accelerations = accelerations;
    }

    private AngularCurve(string joint, float rate, float[] sweep)
        : this(joint, rate, sweep, new float[sweep.Length])
    {
        isSweep = true;
        for (int i = 0; i < sweep.Length; i++)
        {
            accelerations[i] = (sweep[i] - sweep[i > 0 ? i - 1 : 0]) * rate;
        }
    }

    /// <summary>Name of the joint.</summary>
    public string Joint { get; }

    /// <summary>Samples per second.</summary>
    public float Rate { get; }

    /// <summary>Radians per second from each sample to the next; of a sweep below 0 where it goes the other way.</summary>
    public ReadOnlySpan<float> Speeds => speeds;

    /// <summary>Radians/s² at each sample, by which the turning before it differs from that after it; negative where the rule does not count the change.</summary>
    public ReadOnlySpan<float> Accelerations => accelerations;

    /// <summary>What the rule looks at: the accelerations, or the speeds of a sweep.</summary>
    public ReadOnlySpan<float> Signal => isSweep ? speeds : accelerations;

    /// <summary>Where in a sample its signal is, parts: speeds are of the middle between two.</summary>
    internal float Place => isSweep ? 0.5f : 0f;

    /// <summary>Measures the sweep of a line.</summary>
    /// <param name="joint">Name of the joint that it ends at.</param>
    /// <param name="ends">Where it ends at even steps; of a loop without the last, which is the first again.</param>
    /// <param name="rate">Samples per second.</param>
    /// <param name="edge">Whether the last is followed by the first.</param>
    /// <param name="sweep">Says towards what.</param>
    internal static AngularCurve Of(string joint, ReadOnlySpan<SweepEnd> ends, float rate, ClipEdge edge, AngularSweep sweep)
    {
        int count = ends.Length;
        float[] speeds = new float[edge == ClipEdge.Joined ? count : count - 1];
        for (int i = 0; i < speeds.Length; i++)
        {
            speeds[i] = sweep.Speed(ends[i], ends[(i + 1) % count], rate);
        }

        return new AngularCurve(joint, rate, speeds);
    }

    /// <summary>Measures a series of rotations.</summary>
    /// <param name="joint">Name of the joint.</param>
    /// <param name="rotations">At even steps; of a loop without the last, which is the first again.</param>
    /// <param name="rest">Of the joint, in the same space.</param>
    /// <param name="rate">Samples per second.</param>
    /// <param name="loops">Whether the last is followed by the first.</param>
    /// <param name="rule">Says how to measure.</param>
    internal static AngularCurve Of(string joint, ReadOnlySpan<Quaternion> rotations, Quaternion rest, float rate, ClipEdge loops, AngularRule rule)
    {
        int count = rotations.Length;
        var turns = new Vector3[count];
        float[] speeds = new float[count];
        float[] accelerations = new float[count];
        for (int i = 0; i < count; i++)
        {
            bool last = i == count - 1;
            turns[i] = last && loops == ClipEdge.Open ? (i > 0 ? turns[i - 1] : Vector3.Zero) : Turn(rotations[i], rotations[last ? 0 : i + 1], rule.Measure) * rate;
            speeds[i] = Vec.Length(turns[i]);
        }

        for (int i = 0; i < count; i++)
        {
            int before = i > 0 ? i - 1 : loops == ClipEdge.Open ? 0 : count - 1;
            accelerations[i] = Change(turns[before], turns[i], rule) * rate;
        }

        if (rule.NearRest < 1f)
        {
            float farthest = 0f;
            foreach (Quaternion rotation in rotations)
            {
                farthest = Math.Max(farthest, FromRest(rotation, rest));
            }

            for (int i = 0; i < count; i++)
            {
                accelerations[i] = FromRest(rotations[i], rest) > rule.NearRest * farthest ? -Math.Abs(accelerations[i]) : accelerations[i];
            }
        }

        return new AngularCurve(joint, rate, speeds, accelerations);
    }

    /// <summary>How far a joint is turned from its rest: the sine of half of the angle.</summary>
    internal static float FromRest(Quaternion rotation, Quaternion rest)
    {
        Quaternion d = Rotation.Multiply(rotation, Rotation.Inverse(rest));
        return Vec.Length(new Vector3(d.X, d.Y, d.Z));
    }

    /// <summary>Rotation from one pose to the next: its vector, or the differences of its Euler angles; radians.</summary>
    internal static Vector3 Turn(Quaternion from, Quaternion to, AngularMeasure measure)
    {
        if (measure == AngularMeasure.Euler)
        {
            return Shortest(EulerAngles.Of(to) - EulerAngles.Of(from));
        }

        // The difference in the outer space, the shorter way: 2 log(q₁ q₀⁻¹).
        Quaternion d = Rotation.Multiply(to, Rotation.Inverse(from));
        float sign = d.W < 0f ? -1f : 1f;
        var axis = new Vector3(d.X * sign, d.Y * sign, d.Z * sign);
        float sine = Vec.Length(axis);
        return sine < 1e-9f ? axis * 2f : axis * (2f * FastTrigonometry.Of(sine, d.W * sign) / sine);
    }

    /// <summary>Change between two velocities; negative where the rule does not count it.</summary>
    internal static float Change(Vector3 before, Vector3 after, AngularRule rule)
    {
        float slower = Vec.Length(before) - Vec.Length(after);
        float change = rule.Measure == AngularMeasure.Euler ? Math.Abs(slower) : Vec.Distance(before, after);
        bool counts = rule.Change switch { AngularChange.Slowing => slower > 0f, AngularChange.Quickening => slower < 0f, _ => true };
        return counts ? change : -change;
    }

    private static Vector3 Shortest(Vector3 angles)
    {
        const float Half = (float)PortableMath.Pi;
        const float Full = (float)PortableMath.Tau;
        return new Vector3(Wrap(angles.X), Wrap(angles.Y), Wrap(angles.Z));

        static float Wrap(float a) => a > Half ? a - Full : a < -Half ? a + Full : a;
    }
}
