using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Motion;

/// <summary>A skeleton with a local and a model pose of its own, at rest to begin with.</summary>
internal sealed class MovingPose
{
    public MovingPose(Skeleton skeleton)
    {
        Skeleton = skeleton;
        LocalRotations = skeleton.LocalRotations.ToArray();
        LocalPositions = skeleton.LocalPositions.ToArray();
        ModelRotations = skeleton.ModelRotations.ToArray();
        ModelPositions = skeleton.ModelPositions.ToArray();
    }

    public Skeleton Skeleton { get; }

    public Quaternion[] LocalRotations { get; }

    public Vector3[] LocalPositions { get; }

    public Quaternion[] ModelRotations { get; }

    public Vector3[] ModelPositions { get; }

    public Pose Local => new(LocalRotations, LocalPositions);

    public Pose Model => new(ModelRotations, ModelPositions);

    /// <summary>Joints in a row along +Y, the first at the origin, each bone as long as given, all with one limit.</summary>
    public static Skeleton Chain(int bones, float length, JointLimit limit)
    {
        var joints = new List<Joint>();
        for (int i = 0; i <= bones; i++)
        {
            var local = new Vector3(0f, i == 0 ? 0f : length, 0f);
            joints.Add(new Joint(FormattableString.Invariant($"J{i}"), JointRole.Tail, Side.Median, i - 1, local, Quaternion.Identity, new Vector3(0f, i * length, 0f), Quaternion.Identity, i == bones ? 0f : length, limit));
        }

        return new Skeleton(joints);
    }

    /// <summary>Turns every joint somehow, the same for the same number.</summary>
    public MovingPose Shaken(ulong seed, double max = 0.7)
    {
        RandomStream random = new Seed(seed).Stream();
        for (int i = 0; i < LocalRotations.Length; i++)
        {
            LocalRotations[i] = Rotation.Normalize(Rotation.Multiply(LocalRotations[i], Rotation.FromAxisAngle(Direction(random), random.Uniform(-max, max))));
        }

        Chained();
        return this;
    }

    public MovingPose Chained()
    {
        ForwardKinematics.LocalToModel(Skeleton, Local, Model);
        return this;
    }

    public static Vector3 Direction(RandomStream random)
    {
        while (true)
        {
            var v = new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1));
            float length = Vec.Length(v);
            if (length is > 0.1f and < 1f)
            {
                return v / length;
            }
        }
    }

    public static Quaternion AnyRotation(RandomStream random) => Rotation.FromAxisAngle(Direction(random), random.Uniform(-3.1, 3.1));

    /// <summary>Angle between two rotations, radians.</summary>
    public static double Between(Quaternion a, Quaternion b) => Rotation.Angle(Rotation.Multiply(Rotation.Inverse(a), b));

    /// <summary>Bytes that so many calls of an action allocate on this thread, the first two left out.</summary>
    /// <remarks>The least of several rounds: what the action allocates shows in every one; what the runtime does once (compiling a method anew, a collection that takes the thread's buffer) does not.</remarks>
    public static long Allocated(Action action, int calls = 20)
    {
        action();
        action();
        long min = long.MaxValue;
        for (int round = 0; round < 5 && min > 0; round++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < calls; i++)
            {
                action();
            }

            min = Math.Min(min, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        return min;
    }
}
