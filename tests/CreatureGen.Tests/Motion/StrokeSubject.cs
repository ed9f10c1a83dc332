using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Creatures;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Creatures of a body plan, and a pose of one that remembers how fast its joints turn.</summary>
internal sealed class StrokeSubject
{
    private static readonly ConcurrentDictionary<(BodyPlan, int), Lazy<Creature[]>> found = new();

    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;
    private readonly Quaternion[] before;
    private readonly Vector3[] rates;
    private int steps;

    public StrokeSubject(Creature creature)
    {
        Creature = creature;
        int count = creature.Skeleton.Count;
        rotations = new Quaternion[count];
        positions = new Vector3[count];
        before = new Quaternion[count];
        rates = new Vector3[count];
        ModelRotations = new Quaternion[count];
        ModelPositions = new Vector3[count];
        Local.SetToRest(creature.Skeleton);
    }

    public Creature Creature { get; }

    public Skeleton Skeleton => Creature.Skeleton;

    public Pose Local => new(rotations, positions);

    public Quaternion[] Rotations => rotations;

    public Vector3[] Positions => positions;

    public Quaternion[] ModelRotations { get; }

    public Vector3[] ModelPositions { get; }

    /// <summary>Largest change of a joint's angular velocity from one step to the next, rad/s.</summary>
    public float Jerk { get; private set; }

    /// <summary>Largest angular velocity, rad/s.</summary>
    public float Fastest { get; private set; }

    /// <summary>The first animals that seeds give for a plan.</summary>
    public static Creature[] Of(BodyPlan plan, int count = 4) => found.GetOrAdd((plan, count), key => new Lazy<Creature[]>(() => Find(key.Item1, key.Item2, 0.5, 2))).Value;

    /// <summary>Animals of a plan within a range of sizes.</summary>
    public static Creature[] Find(BodyPlan plan, int count, double min, double max)
    {
        RequestedKind kind = plan is BodyPlan.Flapping or BodyPlan.Buzzing ? RequestedKind.Flying : plan >= BodyPlan.Fish ? RequestedKind.Swimming : RequestedKind.Walking;
        CreatureOptions options = CreatureOptions.Default with { Kind = kind, BodyPlans = BodyPlanWeight.Only(plan), MinScale = min, MaxScale = max, Strangeness = 0 };
        return Enumerable.Range(1, count).Select(seed => GrownCreatures.Of((ulong)seed, options)).ToArray();
    }

    /// <summary>Fills in the model pose.</summary>
    public void ToModel() => ForwardKinematics.LocalToModel(Skeleton, Local, new Pose(ModelRotations, ModelPositions));

    /// <summary>Takes note of how the joints turned since the last call.</summary>
    public void Track(float dt)
    {
        for (int j = 0; j < rotations.Length; j++)
        {
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(before[j]), rotations[j]);
            turn = turn.W < 0 ? new Quaternion(-turn.X, -turn.Y, -turn.Z, -turn.W) : turn;
            Vector3 rate = steps > 0 ? new Vector3(turn.X, turn.Y, turn.Z) * (2f / dt) : Vector3.Zero;
            if (steps > 0)
            {
                Fastest = Math.Max(Fastest, Vec.Length(rate));
            }

            if (steps > 1)
            {
                Jerk = Math.Max(Jerk, Vec.Distance(rate, rates[j]));
            }

            rates[j] = rate;
            before[j] = rotations[j];
        }

        steps++;
    }

    /// <summary>Asserts that every joint is finite, unit and within its limits.</summary>
    public void AssertWithinLimits(string what)
    {
        const float Slack = 0.002f;
        for (int j = 0; j < rotations.Length; j++)
        {
            Quaternion q = rotations[j];
            float length = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
            Assert.True(Math.Abs(length - 1f) < 1e-4f, $"{what}: {Skeleton.Joints[j].Name} has length {length}");
            Joint joint = Skeleton.Joints[j];
            if (joint.Role is JointRole.Root or JointRole.Body)
            {
                continue;
            }

            Quaternion own = Rotation.Multiply(Rotation.Inverse(Skeleton.LocalRotations[j]), q);
            SoftLimit.Angles(own, out double x, out double twist, out double z);
            JointLimit limit = joint.Limit;
            Assert.True(x >= limit.SwingX.Min - Slack && x <= limit.SwingX.Max + Slack, FormattableString.Invariant($"{what}: {joint.Name} X {x} of {limit}"));
            Assert.True(z >= limit.SwingZ.Min - Slack && z <= limit.SwingZ.Max + Slack, FormattableString.Invariant($"{what}: {joint.Name} Z {z} of {limit}"));
            Assert.True(twist >= limit.Twist.Min - Slack && twist <= limit.Twist.Max + Slack, FormattableString.Invariant($"{what}: {joint.Name} twist {twist} of {limit}"));
        }
    }

    /// <summary>Largest angle between this pose and another of the same skeleton, radians.</summary>
    public double Apart(ReadOnlySpan<Quaternion> other)
    {
        double max = 0;
        for (int j = 0; j < rotations.Length; j++)
        {
            max = Math.Max(max, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(rotations[j]), other[j])));
        }

        return max;
    }

    /// <summary>Largest angle between this pose and the mirror image of another, radians.</summary>
    public double ApartFromMirror(ReadOnlySpan<Quaternion> other)
    {
        double max = 0;
        for (int j = 0; j < rotations.Length; j++)
        {
            Quaternion mirrored = Rotation.Mirror(other[Skeleton.Mirrors[j]]);
            max = Math.Max(max, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(rotations[j]), mirrored)));
        }

        return max;
    }
}
