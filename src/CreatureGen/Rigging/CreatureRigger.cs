using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Fits a skeleton to a finished surface.</summary>
/// <remarks>
/// After the thesis, reconciled with animals: the tips of head and tail are found on the surface, the spine is laid between them through the centres of the sections, its number of bones
/// follows from the body's size, and the root lies at the centre of walkers and fliers and behind the head of swimmers. Every leaf of the skeleton is an end joint.
/// </remarks>
internal static class CreatureRigger
{
    /// <summary>How far below the spine's line the head turns, in depths of the section there: the skull sits on the neck from behind and below.</summary>
    private const float OcciputDrop = 0.25f;

    /// <summary>Builds the rig at the scale of the input (1); only the number of spine bones looks at the creature's own scale.</summary>
    public static Rig Build(RigInput input)
    {
        BodyShape shape = input.Skin.Shape;
        BodyEnds ends = BodyEnds.Find(input.Surface, shape);
        var line = new SpineLine(shape, input.Surface.Positions[ends.Head], input.Surface.Positions[ends.Tail]);
        SpineLayout layout = SpineLayout.Plan(input.Blueprint.Kind, input.Blueprint.Plan, input.Appendages, line, input.Blueprint.Scale);

        bool swims = input.Blueprint.Kind == LocomotionKind.Swimming;
        bool undulating = swims || input.Blueprint.Plan == BodyPlan.Legless;
        var skeleton = new SkeletonBuilder();
        int root = skeleton.Add(-1, Side.Median, new JointDefinition("Root", JointRole.Root, Vector3.Zero, Quaternion.Identity, 0f, JointLimits.Body(JointRole.Root)));
        int body = skeleton.Add(root, Side.Median, new JointDefinition("Body", JointRole.Body, line.At(layout.RootRing), Quaternion.Identity, 0f, JointLimits.Body(JointRole.Body)));
        int[] forward = AddSpine(skeleton, layout.Forward, body, line, shape, line.HeadTip, undulating);
        int head = forward[forward.Length - 1];
        skeleton.AddEnd(head, Side.Median, "HeadEnd", line.HeadTip);
        int jaw = HeadRigger.AddJaw(skeleton, input, head);
        if (input.Eye.HasValue)
        {
            HeadRigger.AddEyes(skeleton, input.Eye.Value, head);
        }

        int[] backward = AddSpine(skeleton, layout.Backward, swims ? body : forward[0], line, shape, line.TailTip, undulating);
        skeleton.AddEnd(backward[backward.Length - 1], Side.Median, "TailEnd", line.TailTip);

        SpineSegments spine = Segments(layout, forward, backward, line);
        var appendages = new List<AppendageJoints>(input.Appendages.Count);
        foreach (Appendage appendage in input.Appendages)
        {
            int parent = ParentOf(appendage, layout, forward, spine, line, head, swims);
            appendages.Add(LimbRigger.Add(skeleton, appendage, parent));
        }

        Skeleton finished = skeleton.Build();
        LimbChain[] limbs = LimbChains(finished, input.Appendages, appendages);
        AttachmentPoint[] points = SpineAttachments.Find(finished, spine, line, input.Skin);
        return new Rig(
            finished,
            spine,
            line,
            appendages,
            limbs,
            points,
            SocketSetter.Find(finished, input, spine, line, layout, limbs, points),
            BodyCapsule.Fit(input.Surface, layout, line.At(layout.ChestRing), line.At(layout.PelvisRing)),
            head,
            jaw);
    }

    private static int[] AddSpine(SkeletonBuilder skeleton, SpineNode[] nodes, int parent, SpineLine line, BodyShape shape, Vector3 tip, bool undulating)
    {
        int[] joints = new int[nodes.Length];
        for (int k = 0; k < nodes.Length; k++)
        {
            Vector3 position = PivotOf(nodes[k], line, shape);
            Vector3 direction = (k + 1 < nodes.Length ? PivotOf(nodes[k + 1], line, shape) : tip) - position;
            int inChain = CountOf(nodes, nodes[k].Role);
            bool chained = nodes[k].Role is JointRole.Neck or JointRole.Tail || (nodes[k].Role == JointRole.Spine && inChain > 5);
            bool undulates = undulating && nodes[k].Role is JointRole.Spine or JointRole.Chest or JointRole.Pelvis or JointRole.Tail;
            JointLimit limit = undulates ? JointLimits.Undulating(inChain) : chained ? JointLimits.Chain(inChain) : JointLimits.Body(nodes[k].Role);
            if (k > 0)
            {
                float behind = Vec.Distance(position, PivotOf(nodes[k - 1], line, shape));
                limit = JointLimits.WithinGirth(limit, Math.Min(behind, Vec.Length(direction)), shape, nodes[k].Ring);
            }

            joints[k] = skeleton.Add(k == 0 ? parent : joints[k - 1], Side.Median, new JointDefinition(nodes[k].Name, nodes[k].Role, position, JointFrame.Median(direction), Vec.Length(direction), limit));
        }

        return joints;
    }

    private static Vector3 PivotOf(SpineNode node, SpineLine line, BodyShape shape)
    {
        Vector3 pivot = line.At(node.Ring);
        if (node.Role == JointRole.Head && node.Ring < StationRing.Nape + 1)
        {
            int ring = (int)node.Ring;
            pivot -= shape.Up(ring) * (float)(shape.Bottom[ring] * OcciputDrop);
        }

        return pivot;
    }

    private static int CountOf(SpineNode[] nodes, JointRole role)
    {
        int count = 0;
        foreach (SpineNode node in nodes)
        {
            count += node.Role == role ? 1 : 0;
        }

        return count;
    }

    /// <summary>The bones from nose to tail. In front of the root a bone begins at its own pivot and reaches to the next one's; behind it likewise, the other way round.</summary>
    private static SpineSegments Segments(SpineLayout layout, int[] forward, int[] backward, SpineLine line)
    {
        int[] joints = new int[forward.Length + backward.Length];
        double[] pivots = new double[joints.Length - 1];
        for (int k = 0; k < forward.Length; k++)
        {
            int node = forward.Length - 1 - k;
            joints[k] = forward[node];
            if (node > 0)
            {
                pivots[k] = line.ArcAt(layout.Forward[node].Ring);
            }
        }

        for (int k = 0; k < backward.Length; k++)
        {
            joints[forward.Length + k] = backward[k];
            pivots[forward.Length - 1 + k] = line.ArcAt(layout.Backward[k].Ring);
        }

        return new SpineSegments(joints, pivots, line.Length);
    }

    /// <summary>Ears and antennae grow on the head, those of the rear half on the bone that moves the skin there, the first arms and wings on the chest, legs on the joint of the trunk nearest to their socket, all else on the bone that moves the skin there.</summary>
    private static int ParentOf(Appendage appendage, SpineLayout layout, int[] forward, SpineSegments spine, SpineLine line, int head, bool swims)
    {
        double arc = line.ArcAt(appendage.RootRing);
        if (appendage.Kind == LimbKind.Ear || (appendage.Kind == LimbKind.Antenna && 2 * arc < line.Length))
        {
            return head;
        }

        if (swims || appendage.Kind is LimbKind.Antenna or LimbKind.Dorsal or LimbKind.Ventral or LimbKind.Pectoral or LimbKind.Tail or LimbKind.Disc)
        {
            return spine.At(arc).Dominant;
        }

        bool shoulder = appendage.Pair == 1 && appendage.Kind is LimbKind.Arm or LimbKind.Wing;
        int nearest = forward[0];
        double min = double.MaxValue;
        for (int k = 0; k < forward.Length; k++)
        {
            JointRole role = layout.Forward[k].Role;
            if (shoulder ? role != JointRole.Chest : !(role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest))
            {
                continue;
            }

            double distance = Math.Abs(line.ArcAt(layout.Forward[k].Ring) - arc);
            if (distance < min)
            {
                min = distance;
                nearest = forward[k];
            }
        }

        return nearest;
    }

    /// <summary>The limbs of a finished skeleton as chains: of each appendage the left one, then the right one.</summary>
    internal static LimbChain[] LimbChains(Skeleton skeleton, IReadOnlyList<Appendage> appendages, List<AppendageJoints> joints)
    {
        var chains = new List<LimbChain>(2 * appendages.Count);
        for (int i = 0; i < appendages.Count; i++)
        {
            Appendage a = appendages[i];
            chains.Add(Chain(skeleton, a, a.Paired ? Side.Left : Side.Median, joints[i].Left, a.Pole, a.Contact));
            if (a.Paired)
            {
                chains.Add(Chain(skeleton, a, Side.Right, joints[i].Right, Vec.Mirror(a.Pole), Vec.Mirror(a.Contact)));
            }
        }

        return chains.ToArray();
    }

    private static LimbChain Chain(Skeleton skeleton, Appendage appendage, Side side, int[] joints, Vector3 pole, Vector3 contact)
    {
        float[] lengths = new float[joints.Length - 1];
        for (int k = 0; k < lengths.Length; k++)
        {
            lengths[k] = Vec.Distance(skeleton.ModelPositions[joints[k]], skeleton.ModelPositions[joints[k + 1]]);
        }

        return new LimbChain(appendage.Kind, side, appendage.Pair, appendage.Archetype, joints, lengths, pole, contact, appendage.Stands);
    }
}
