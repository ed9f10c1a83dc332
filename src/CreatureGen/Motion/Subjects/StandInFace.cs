using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Subjects;

/// <summary>Jaw, eyes and ears of a stand-in, where the skeleton from elsewhere has joints for them.</summary>
internal sealed class StandInFace
{
    /// <summary>Length of a jaw, of an eye and of an ear of which no joint and no skin tells, parts of the head's.</summary>
    private const float JawLength = 0.5f;
    private const float EyeLength = 0.1f;
    private const float EarLength = 0.4f;

    private readonly SkeletonBuilder builder;
    private readonly Skeleton source;
    private readonly int theirs;
    private readonly int head;
    private readonly Func<int, Vector3> placeOf;
    private readonly Func<int, Vector3, float?> reachOf;

    /// <summary>Prepares it.</summary>
    /// <param name="builder">Gets the joints.</param>
    /// <param name="source">From elsewhere.</param>
    /// <param name="theirs">Its head.</param>
    /// <param name="head">The head that stands in for it.</param>
    /// <param name="placeOf">Says where a joint of the source is, as it stands in.</param>
    /// <param name="reachOf">Says how far the skin of a joint reaches in a direction; null where none is known.</param>
    public StandInFace(SkeletonBuilder builder, Skeleton source, int theirs, int head, Func<int, Vector3> placeOf, Func<int, Vector3, float?> reachOf)
    {
        this.builder = builder;
        this.source = source;
        this.theirs = theirs;
        this.head = head;
        this.placeOf = placeOf;
        this.reachOf = reachOf;
    }

    private float HeadLength => builder[head].Length;

    /// <summary>Adds what there is.</summary>
    /// <param name="follows">Gets for each joint of the source the one here that it follows.</param>
    public void Add(int[] follows)
    {
        AddJaw(follows);
        AddEyes(follows);
        AddEars(follows);
    }

    private void AddJaw(int[] follows)
    {
        int jaw = Roots(JointRole.Jaw, Side.Median) is { Count: > 0 } found ? found[0] : -1;
        if (jaw < 0)
        {
            return;
        }

        Vector3 hinge = Median(placeOf(jaw));
        Vector3 chin = ChildOf(jaw, JointRole.End) is >= 0 and int end ? Median(placeOf(end)) - hinge : Vector3.UnitZ * (reachOf(jaw, Vector3.UnitZ) ?? 0f);
        chin = Vec.Length(chin) > EyeLength * HeadLength ? chin : Vector3.UnitZ * (JawLength * HeadLength);
        follows[jaw] = builder.Add(head, Side.Median, new JointDefinition("Jaw", JointRole.Jaw, hinge, JointFrame.Median(chin), Vec.Length(chin), JointLimits.Body(JointRole.Jaw)));
        builder.AddEnd(follows[jaw], Side.Median, "JawEnd", hinge + chin);
    }

    private void AddEyes(int[] follows)
    {
        if (Roots(JointRole.Eye, Side.Left) is { Count: > 0 } left && Roots(JointRole.Eye, Side.Right) is { Count: > 0 } right)
        {
            Quaternion frame = JointFrame.Raised(Vector3.UnitZ, -Vector3.UnitY);
            var eye = new JointDefinition("Eye_L", JointRole.Eye, placeOf(left[0]), frame, EyeLength * HeadLength, JointLimits.Body(JointRole.Eye));
            int[] pair = builder.AddPair(head, new[] { eye }, new[] { "Eye_R" });
            (follows[left[0]], follows[right[0]]) = (pair[0], pair[1]);
        }
    }

    /// <summary>Ears of as many joints on the left as on the right.</summary>
    private void AddEars(int[] follows)
    {
        List<int> left = ChainOf(Roots(JointRole.Ear, Side.Left));
        List<int> right = ChainOf(Roots(JointRole.Ear, Side.Right));
        if (left.Count == 0 || left.Count != right.Count)
        {
            return;
        }

        var definitions = new List<JointDefinition>();
        var names = new List<string>();
        Vector3 onward = Vector3.UnitY * (EarLength * HeadLength);
        for (int k = 0; k < left.Count; k++)
        {
            Vector3 place = placeOf(left[k]);
            int next = k + 1 < left.Count ? left[k + 1] : ChildOf(left[k], JointRole.End);
            Vector3 along = next >= 0 ? placeOf(next) - place : onward;
            onward = Vec.Length(along) > 0f ? along : onward;
            definitions.Add(new JointDefinition(FormattableString.Invariant($"Ear_L_{k + 1}"), JointRole.Ear, place, JointFrame.Raised(onward, Vector3.UnitZ), Vec.Length(onward), JointLimits.Soft(JointRole.Ear, k)));
            names.Add(FormattableString.Invariant($"Ear_R_{k + 1}"));
        }

        JointDefinition last = definitions[^1];
        definitions.Add(new JointDefinition("Ear_L_End", JointRole.End, last.Position + onward, last.Rotation, 0f, JointLimit.Fixed));
        names.Add("Ear_R_End");
        int[] pair = builder.AddPair(head, definitions, names);
        for (int k = 0; k < left.Count; k++)
        {
            (follows[left[k]], follows[right[k]]) = (pair[k], pair[definitions.Count + k]);
        }
    }

    /// <summary>Joints of a role and a side that hang on the head and on none of their own role.</summary>
    private List<int> Roots(JointRole role, Side side)
    {
        var found = new List<int>();
        for (int joint = theirs + 1; joint < source.Count; joint++)
        {
            if (source.Joints[joint].Role == role && source.Joints[joint].Side == side && OnHead(joint, role))
            {
                found.Add(joint);
            }
        }

        return found;
    }

    private bool OnHead(int joint, JointRole role)
    {
        for (int above = source.Parents[joint]; above >= theirs; above = source.Parents[above])
        {
            if (above == theirs || source.Joints[above].Role == role)
            {
                return above == theirs;
            }
        }

        return false;
    }

    private List<int> ChainOf(List<int> roots)
    {
        var chain = new List<int>();
        for (int joint = roots.Count > 0 ? roots[0] : -1; joint >= 0; joint = ChildOf(joint, JointRole.Ear))
        {
            chain.Add(joint);
        }

        return chain;
    }

    private int ChildOf(int joint, JointRole role)
    {
        for (int child = joint + 1; child < source.Count; child++)
        {
            if (source.Parents[child] == joint && source.Joints[child].Role == role)
            {
                return child;
            }
        }

        return -1;
    }

    private static Vector3 Median(Vector3 place) => new(0f, place.Y, place.Z);
}
