using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>Watches the joints of a pose: how far they are beyond their limits, how fast they turn and how that changes.</summary>
internal sealed class JointWatch
{
    /// <summary>Radians per second: nothing in an animal is faster, and hardly anything in a gait.</summary>
    private const float Fast = 60f;

    private readonly Skeleton skeleton;
    private readonly bool[] driven;
    private readonly float[] asked;
    private readonly Quaternion[] before;
    private readonly Vector3[] rates;
    private int frames;

    /// <summary>Watches a creature. What swings by itself does not count, nor do thin wings as long as they are no faster than they beat.</summary>
    public JointWatch(MotionProfile profile)
    {
        skeleton = profile.Subject.Skeleton;
        driven = new bool[skeleton.Count];
        asked = new float[skeleton.Count];
        float beat = profile.Flight is FlightProfile flight && flight.Buzzes ? (float)FlightControl.FastestBlade(flight) : 0f;
        for (int j = 0; j < driven.Length; j++)
        {
            JointRole role = skeleton.Joints[j].Role;
            driven[j] = IsLimited(role);
            asked[j] = role == JointRole.Wing ? beat : 0f;
        }

        foreach (SwingingChain chain in profile.Swinging)
        {
            foreach (int joint in chain.Rig.Joints)
            {
                driven[joint] = false;
            }
        }

        before = new Quaternion[skeleton.Count];
        rates = new Vector3[skeleton.Count];
    }

    public double Excess { get; private set; }

    public int ExcessJoint { get; private set; } = -1;

    public float Speed { get; private set; }

    public int SpeedJoint { get; private set; } = -1;

    public float Acceleration { get; private set; }

    public int FastJoints { get; private set; }

    /// <summary>Watches a pose.</summary>
    /// <param name="rotations">Local.</param>
    /// <param name="dt">Seconds since the last, above 0.</param>
    public void Record(ReadOnlySpan<Quaternion> rotations, float dt)
    {
        for (int j = 0; j < rotations.Length; j++)
        {
            Joint joint = skeleton.Joints[j];
            if (IsLimited(joint.Role))
            {
                double excess = JointExcess.Of(Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), rotations[j])), joint.Limit);
                ExcessJoint = excess > Excess ? j : ExcessJoint;
                Excess = Math.Max(Excess, excess);
            }

            if (frames > 0 && driven[j])
            {
                Turn(j, Rate(before[j], rotations[j], dt), dt);
            }

            before[j] = rotations[j];
        }

        frames++;
    }

    private static bool IsLimited(JointRole role) => role is not (JointRole.Root or JointRole.Body or JointRole.Eye or JointRole.Lid or JointRole.Ear or JointRole.End);

    /// <summary>Angular velocity from one rotation to the next, radians per second.</summary>
    private static Vector3 Rate(Quaternion from, Quaternion to, float dt)
    {
        Quaternion step = Rotation.Multiply(Rotation.Inverse(from), to);
        var axis = new Vector3(step.X, step.Y, step.Z) * (step.W < 0f ? -1f : 1f);
        float sine = Vec.Length(axis);
        return sine > 1e-9f ? axis * (float)(2 * PortableMath.Atan2(sine, Math.Abs(step.W)) / (sine * dt)) : Vector3.Zero;
    }

    private void Turn(int joint, Vector3 rate, float dt)
    {
        float speed = Vec.Length(rate);
        speed = speed > asked[joint] ? speed : 0f;
        SpeedJoint = speed > Speed ? joint : SpeedJoint;
        Speed = Math.Max(Speed, speed);
        FastJoints += speed > Fast ? 1 : 0;
        Acceleration = frames > 1 ? Math.Max(Acceleration, Vec.Length(rate - rates[joint]) / dt) : Acceleration;
        rates[joint] = rate;
    }
}
