using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>Keeps parts of a ragdoll out of one another: heads fold onto chests instead of into them, shins rest beside each other.</summary>
internal static class RagdollCollision
{
    /// <summary>Joints between two parts from which on they may meet: nearer ones are kept apart by their limits.</summary>
    private const int MinJoints = 3;

    /// <summary>Pairs that are looked at, at most: those that are nearest at rest for how thick they are.</summary>
    private const int MaxPairs = 192;

    /// <summary>Part of their radii by which two bones stay apart: flesh gives.</summary>
    private const float Firmness = 0.8f;

    /// <summary>Finds the pairs of a rig.</summary>
    /// <param name="parts">Its parts.</param>
    /// <param name="bones">What of them touches.</param>
    /// <param name="places">Where their centres of mass are at rest, model space.</param>
    /// <param name="turns">How they are turned there.</param>
    public static RagdollPair[] PairsOf(RagdollPart[] parts, RagdollBone[] bones, Vector3[] places, Quaternion[] turns)
    {
        var found = new List<(float Gap, RagdollPair Pair)>();
        for (int i = 0; i < parts.Length; i++)
        {
            for (int k = i + 1; k < parts.Length; k++)
            {
                float radii = bones[i].Radius + bones[k].Radius;
                if (bones[i].Radius <= 0f || bones[k].Radius <= 0f || Joints(parts, i, k) < MinJoints)
                {
                    continue;
                }

                float rest = Between(bones[i], places[i], turns[i], bones[k], places[k], turns[k], 1f, out _, out _, out _);
                float apart = Math.Min(Firmness * radii, rest);
                found.Add(((rest - radii) / radii, new RagdollPair(i, k, apart, apart + Extent(bones[i]) + Extent(bones[k]))));
            }
        }

        // Sorted by what they are where two are alike: the same pairs on every machine.
        found.Sort((a, b) => a.Gap != b.Gap ? a.Gap.CompareTo(b.Gap) : a.Pair.First != b.Pair.First ? a.Pair.First.CompareTo(b.Pair.First) : a.Pair.Second.CompareTo(b.Pair.Second));
        if (found.Count > MaxPairs)
        {
            found.RemoveRange(MaxPairs, found.Count - MaxPairs);
        }

        return found.ConvertAll(one => one.Pair).ToArray();
    }

    /// <summary>Remembers which pairs are nearer than they stay: those that the motion had in one another may go on so.</summary>
    public static void Start(RagdollState state)
    {
        ReadOnlySpan<RagdollPair> pairs = state.Rig.Pairs;
        ReadOnlySpan<RagdollBone> bones = state.Rig.Bones;
        for (int p = 0; p < pairs.Length; p++)
        {
            RagdollPair pair = pairs[p];
            float now = Between(bones[pair.First], state.Positions[pair.First], state.Rotations[pair.First], bones[pair.Second], state.Positions[pair.Second], state.Rotations[pair.Second], state.Scale, out _, out _, out _);
            state.Aparts[p] = Math.Min(pair.Apart, now / state.Scale);
        }
    }

    /// <summary>Pushes apart what has come too near, by no more than it came nearer in this substep and so many metres.</summary>
    public static void Separate(RagdollState state, float emergence)
    {
        ReadOnlySpan<RagdollPair> pairs = state.Rig.Pairs;
        ReadOnlySpan<RagdollBone> bones = state.Rig.Bones;
        ReadOnlySpan<RagdollPart> parts = state.Rig.Parts;
        for (int p = 0; p < pairs.Length; p++)
        {
            ref readonly RagdollPair pair = ref pairs[p];
            int i = pair.First;
            int k = pair.Second;
            float bound = pair.Bound * state.Scale;
            if (Vec.LengthSquared(state.Positions[i] - state.Positions[k]) > bound * bound)
            {
                continue;
            }

            float wanted = state.Aparts[p] * state.Scale;
            float distance = Between(bones[i], state.Positions[i], state.Rotations[i], bones[k], state.Positions[k], state.Rotations[k], state.Scale, out Vector3 first, out Vector3 second, out Vector3 between);
            float depth = wanted - distance;
            if (!(depth > 0f) || !(distance > 1e-3f * wanted))
            {
                continue;
            }

            Vector3 normal = between / distance;
            float came = Vec.Dot(Went(state, i, first) - Went(state, k, second), -normal);
            depth = Math.Min(depth, came + emergence);
            if (depth > 0f)
            {
                float weight = RagdollSolver.Weight(parts[i], state.Rotations[i], first, normal, state.Scale) + RagdollSolver.Weight(parts[k], state.Rotations[k], second, normal, state.Scale);
                Vector3 push = normal * (depth / weight);
                RagdollSolver.Move(state, parts[i], i, first, push);
                RagdollSolver.Move(state, parts[k], k, second, -push);
            }
        }
    }

    /// <summary>How far a point of a part has come in this substep.</summary>
    private static Vector3 Went(RagdollState state, int part, Vector3 arm)
    {
        Vector3 past = Rotation.Rotate(Rotation.Multiply(state.PastRotations[part], Rotation.Inverse(state.Rotations[part])), arm);
        return state.Positions[part] + arm - state.PastPositions[part] - past;
    }

    /// <summary>The distance between two bones, the nearest points from their parts' centres of mass, and the way from the second to the first.</summary>
    private static float Between(in RagdollBone one, Vector3 place, Quaternion turn, in RagdollBone other, Vector3 otherPlace, Quaternion otherTurn, float scale, out Vector3 first, out Vector3 second, out Vector3 between)
    {
        Vector3 a = Rotation.Rotate(turn, one.Start) * scale;
        Vector3 b = Rotation.Rotate(turn, one.End) * scale;
        Vector3 c = Rotation.Rotate(otherTurn, other.Start) * scale;
        Vector3 d = Rotation.Rotate(otherTurn, other.End) * scale;
        SegmentDistance.Squared(place + a, place + b, otherPlace + c, otherPlace + d, out float s, out float t);
        first = Vec.Lerp(a, b, s);
        second = Vec.Lerp(c, d, t);
        between = place + first - otherPlace - second;
        return Vec.Length(between);
    }

    private static float Extent(in RagdollBone bone) => (float)Math.Sqrt(Math.Max(Vec.LengthSquared(bone.Start), Vec.LengthSquared(bone.End)));

    /// <summary>Joints on the way from one part to another.</summary>
    private static int Joints(RagdollPart[] parts, int a, int b)
    {
        int count = 0;
        while (a != b)
        {
            // Parents come first: the later of two is not on the way from the root to the other.
            if (a > b)
            {
                a = parts[a].Parent;
            }
            else
            {
                b = parts[b].Parent;
            }

            count++;
        }

        return count;
    }
}
