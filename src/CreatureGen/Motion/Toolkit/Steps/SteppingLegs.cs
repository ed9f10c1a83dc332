using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The legs of any skeleton, found by what its joints are, for a <see cref="LegStepper"/>: where the feet belong, which step together, and how the legs follow them. Immutable.</summary>
/// <remarks>A leg is a hip with a knee and an ankle below it (<see cref="JointRole"/>; of skeletons from elsewhere as <see cref="Skeleton.Build"/> tells them) whose ankle is low down at rest: arms of a standing figure are none, forelegs are legs whatever they are called.</remarks>
public sealed class SteppingLegs
{
    /// <summary>Part of the skeleton's height below which ankles stand.</summary>
    private const float Low = 0.3f;

    private readonly Leg[] legs;
    private readonly int[] groups;

    private SteppingLegs(Skeleton skeleton, Leg[] legs)
    {
        Skeleton = skeleton;
        this.legs = legs;
        groups = new int[legs.Length];
        int pair = -1;
        for (int i = 0; i < legs.Length; i++)
        {
            bool opens = i == 0 || legs[i].Side == legs[i - 1].Side || (i > 1 && legs[i - 2].Pair == pair);
            pair += opens ? 1 : 0;
            legs[i] = legs[i] with { Pair = pair };
            groups[i] = (pair + (legs[i].Side == Side.Right ? 1 : 0)) % 2;
        }
    }

    /// <summary>In rest pose.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>Number of legs, from the front.</summary>
    public int Count => legs.Length;

    /// <summary>The group of each foot: diagonal pairs take turns, as in a trot.</summary>
    public ReadOnlySpan<int> Groups => groups;

    /// <summary>Length of the longest leg, hip to ankle, model metres.</summary>
    public float Length { get; private set; }

    /// <summary>Finds the legs.</summary>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    /// <exception cref="ArgumentException">It has no leg.</exception>
    public static SteppingLegs Of(Skeleton skeleton)
    {
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        float lowest = float.MaxValue;
        float highest = float.MinValue;
        foreach (Joint joint in skeleton.Joints)
        {
            lowest = Math.Min(lowest, joint.ModelPosition.Y);
            highest = Math.Max(highest, joint.ModelPosition.Y);
        }

        var legs = new List<Leg>();
        float length = 0f;
        for (int hip = 0; hip < skeleton.Count; hip++)
        {
            if (skeleton.Joints[hip].Role == JointRole.Hip
                && Below(skeleton, hip, JointRole.Knee) is >= 0 and int knee
                && Below(skeleton, knee, JointRole.Ankle) is >= 0 and int ankle
                && skeleton.Parents[knee] == hip
                && skeleton.Parents[ankle] == knee
                && skeleton.Joints[ankle].ModelPosition.Y <= lowest + (Low * (highest - lowest)))
            {
                Vector3 a = skeleton.Joints[hip].ModelPosition;
                Vector3 b = skeleton.Joints[knee].ModelPosition;
                Vector3 c = skeleton.Joints[ankle].ModelPosition;
                Vector3 bend = Vec.Reject(b - a, Vec.Normalize(c - a, -Vector3.UnitY));
                length = Math.Max(length, Vec.Distance(a, b) + Vec.Distance(b, c));

                // A leg that is straight at rest bends its knee ahead.
                legs.Add(new Leg(hip, knee, ankle, skeleton.Joints[hip].Side, Vec.Length(bend) > 1e-3f * Vec.Distance(a, c) ? Vec.Normalize(bend, Vector3.UnitZ) : Vector3.UnitZ, 0));
            }
        }

        if (legs.Count == 0)
        {
            throw new ArgumentException("no joint is a hip with a knee and an ankle that stands; expected joints with roles, or names that tell them", nameof(skeleton));
        }

        legs.Sort((x, y) => Order(skeleton, x, y));
        return new SteppingLegs(skeleton, legs.ToArray()) { Length = length };
    }

    /// <summary>Where the feet belong under the body as it is now: the ankles' places at rest, on the ground plane of the creature.</summary>
    /// <param name="place">Where the body is.</param>
    /// <param name="homes">Receives one place for each leg, world space.</param>
    /// <exception cref="ArgumentException">There is not one for each leg.</exception>
    public void FillHomes(in RootPlace place, Span<Vector3> homes)
    {
        RequireOneEach(homes.Length, nameof(homes));
        for (int i = 0; i < legs.Length; i++)
        {
            Vector3 ankle = Skeleton.Joints[legs[i].Ankle].ModelPosition;
            homes[i] = place.ToWorld(new Vector3(ankle.X, 0f, ankle.Z));
        }
    }

    /// <summary>Poses the legs: ankles above their feet as at rest, feet level with the creature.</summary>
    /// <param name="feet">One for each leg.</param>
    /// <param name="place">Where the body is.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">The same in model space.</param>
    /// <exception cref="ArgumentException">There is not one foot for each leg, or a pose is not as long as the skeleton.</exception>
    public void Apply(ReadOnlySpan<SteppingFoot> feet, in RootPlace place, in Pose local, in Pose model)
    {
        RequireOneEach(feet.Length, nameof(feet));
        for (int i = 0; i < legs.Length; i++)
        {
            Leg leg = legs[i];
            Vector3 target = place.ToModel(feet[i].Position) + new Vector3(0f, Skeleton.Joints[leg.Ankle].ModelPosition.Y, 0f);
            TwoBoneIk.Apply(Skeleton, leg.Hip, leg.Knee, leg.Ankle, target, leg.Pole, Reach.Default, 1f, local, model);
            local.Rotations[leg.Ankle] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(model.Rotations[leg.Knee]), Skeleton.Joints[leg.Ankle].ModelRotation));
            Subtree.LocalToModel(Skeleton, leg.Ankle, local, model);
        }
    }

    private static int Below(Skeleton skeleton, int joint, JointRole role)
    {
        for (int i = joint + 1; i < skeleton.Count; i++)
        {
            if (skeleton.Parents[i] == joint && skeleton.Joints[i].Role == role)
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>From the front; of a pair the left first.</summary>
    private static int Order(Skeleton skeleton, Leg x, Leg y)
    {
        float apart = skeleton.Joints[y.Hip].ModelPosition.Z - skeleton.Joints[x.Hip].ModelPosition.Z;
        return Math.Abs(apart) > 1e-3f ? Math.Sign(apart) : x.Side != y.Side ? x.Side.CompareTo(y.Side) : x.Hip.CompareTo(y.Hip);
    }

    private void RequireOneEach(int count, string name)
    {
        if (count != legs.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{count} of {legs.Length}; expected one for each leg"), name);
        }
    }

    private readonly record struct Leg(int Hip, int Knee, int Ankle, Side Side, Vector3 Pole, int Pair);
}
