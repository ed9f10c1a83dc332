using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>A chain of joints that shares a turn: each takes of it what its limits are part of the chain's, so that all come to their ends together.</summary>
internal sealed class TurnedChain
{
    private readonly Skeleton skeleton;
    private readonly float[] pitches;
    private readonly float[] yaws;
    private readonly float[] twists;

    public TurnedChain(Skeleton skeleton, int[] joints)
    {
        this.skeleton = skeleton;
        Joints = joints;
        pitches = new float[joints.Length];
        yaws = new float[joints.Length];
        twists = new float[joints.Length];
        for (int i = 0; i < joints.Length; i++)
        {
            Joint joint = skeleton.Joints[joints[i]];
            Length += joint.Length;
            pitches[i] = Narrower(joint.Limit.SwingX);
            yaws[i] = Narrower(joint.Limit.SwingZ);
            twists[i] = Narrower(joint.Limit.Twist);
        }

        Normalise(pitches);
        Normalise(yaws);
        Normalise(twists);
    }

    /// <summary>Lowest first.</summary>
    public int[] Joints { get; }

    public int Count => Joints.Length;

    /// <summary>Of its bones together, metres.</summary>
    public float Length { get; }

    /// <summary>Turns the chain on top of its pose, within the limits of its joints.</summary>
    /// <param name="turns">Writes turns about the model's axes.</param>
    /// <param name="yaw">Of the chain as a whole, radians about up.</param>
    /// <param name="pitch">About left.</param>
    /// <param name="roll">About ahead.</param>
    /// <param name="from">The first joint that turns; those before it stay.</param>
    /// <param name="local">The pose.</param>
    public void Turn(RestRotations turns, float yaw, float pitch, float roll, int from, in Pose local)
    {
        if (yaw == 0f && pitch == 0f && roll == 0f)
        {
            return;
        }

        float scale = from == 0 ? 1f : Count / (float)Math.Max(Count - from, 1);
        for (int i = from; i < Count; i++)
        {
            TurnJoint(turns, Joints[i], AxisRotation.YawPitchRoll(yaw * yaws[i] * scale, pitch * pitches[i] * scale, roll * twists[i] * scale), local);
        }
    }

    /// <summary>Turns one joint on top of its pose, within its limits.</summary>
    public void TurnJoint(RestRotations turns, int joint, Quaternion turn, in Pose local)
    {
        turns.Set(local, joint, Rotation.Multiply(turn, turns.Of(local, joint)));
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(local.Rotations[joint]), skeleton.AllJoints[joint]);
    }

    private static float Narrower(AngleRange range) => Math.Max(Math.Min(-range.Min, range.Max), 1e-4f);

    private static void Normalise(float[] parts)
    {
        float sum = 0f;
        foreach (float part in parts)
        {
            sum += part;
        }

        for (int i = 0; i < parts.Length; i++)
        {
            parts[i] /= sum;
        }
    }
}
