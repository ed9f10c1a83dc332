using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>How deep the legs of a creature go into one another and into the trunk, by the capsules of their bones, beyond what these do at rest.</summary>
internal sealed class LegOverlap
{
    /// <summary>Stands for a leg of what is of the trunk.</summary>
    private const int Trunk = -1;

    private readonly CapsuleCollider[] capsules;
    private readonly int[] legs;
    private readonly int[] thighs;
    private readonly float[] rest;
    private readonly Vector3[] starts;
    private readonly Vector3[] ends;

    public LegOverlap(LeggedBody body)
    {
        var found = new List<CapsuleCollider>();
        var owners = new List<int>();
        for (int i = 0; i < body.Legs.Length; i++)
        {
            LegRig leg = body.Legs[i];
            foreach (CapsuleCollider capsule in body.Subject.Bones)
            {
                if (capsule.Joint == leg.Hip || capsule.Joint == leg.Knee || capsule.Joint == leg.Ankle || capsule.Joint == leg.Ball)
                {
                    found.Add(capsule);
                    owners.Add(i);
                }
            }
        }

        foreach (CapsuleCollider capsule in body.Subject.Bones)
        {
            if (Array.IndexOf(body.Trunk, capsule.Joint) >= 0)
            {
                found.Add(capsule);
                owners.Add(Trunk);
            }
        }

        thighs = Array.ConvertAll(body.Legs, leg => leg.Hip);
        capsules = found.ToArray();
        legs = owners.ToArray();
        starts = new Vector3[capsules.Length];
        ends = new Vector3[capsules.Length];
        rest = new float[capsules.Length * capsules.Length];
        Move(body.Skeleton.ModelPositions, body.Skeleton.ModelRotations);
        for (int i = 0; i < capsules.Length; i++)
        {
            for (int k = 0; k < i; k++)
            {
                rest[(i * capsules.Length) + k] = Math.Max(0f, Depth(i, k));
            }
        }
    }

    /// <summary>The pair of legs that went deepest into one another in any pose so far.</summary>
    public (int First, int Second) Worst { get; private set; } = (-1, -1);

    /// <summary>How deep they did, metres; 0 for not at all.</summary>
    public float Deepest { get; private set; }

    /// <summary>How deep a leg went into the trunk from its knee downwards, metres; 0 for not at all. Thighs and trunk have one skin.</summary>
    public float DeepestInTrunk { get; private set; }

    /// <summary>Measures a pose.</summary>
    /// <param name="model">In model space.</param>
    public void Measure(in Pose model)
    {
        Move(model.Positions, model.Rotations);
        for (int i = 0; i < capsules.Length; i++)
        {
            for (int k = 0; k < i && legs[k] != legs[i]; k++)
            {
                if (legs[i] == Trunk && capsules[k].Joint == thighs[legs[k]])
                {
                    continue;
                }

                float depth = Depth(i, k) - rest[(i * capsules.Length) + k];
                if (legs[i] == Trunk)
                {
                    DeepestInTrunk = Math.Max(DeepestInTrunk, depth);
                }
                else if (depth > Deepest)
                {
                    Deepest = depth;
                    Worst = (legs[k], legs[i]);
                }
            }
        }
    }

    private void Move(ReadOnlySpan<Vector3> positions, ReadOnlySpan<Quaternion> rotations)
    {
        for (int i = 0; i < capsules.Length; i++)
        {
            int joint = capsules[i].Joint;
            starts[i] = positions[joint] + Rotation.Rotate(rotations[joint], capsules[i].Start);
            ends[i] = positions[joint] + Rotation.Rotate(rotations[joint], capsules[i].End);
        }
    }

    private float Depth(int i, int k) => capsules[i].Radius + capsules[k].Radius - (float)Math.Sqrt(SegmentDistance.Squared(starts[i], ends[i], starts[k], ends[k]));
}
