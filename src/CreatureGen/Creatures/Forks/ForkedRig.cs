using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Creatures.Forks;

/// <summary>The skeleton of a body that forks into two necks. The joints of the left neck keep name and number of those of a body with one; their mirror images follow all others, with names that end in <see cref="Heads.Suffix"/>.</summary>
internal sealed class ForkedRig
{
    private readonly Rig one;
    private readonly ForkCourse course;
    private readonly SkeletonBuilder builder = new();
    private readonly Vector3[] places;
    private readonly Quaternion[] turns;
    private readonly double[] rings;

    private ForkedRig(Rig one, ForkCourse course)
    {
        this.one = one;
        this.course = course;
        int count = one.Skeleton.Count;
        places = one.Skeleton.ModelPositions.ToArray();
        turns = one.Skeleton.ModelRotations.ToArray();
        rings = new double[count];
        Second = new int[count];
    }

    /// <summary>The forked rig. Chains of appendages in front of the fork come again behind all others.</summary>
    public Rig Rig { get; private set; } = null!;

    /// <summary>For each joint of the unforked skeleton its mirror image in the second neck and head; −1 for those that are there once.</summary>
    public int[] Second { get; }

    /// <summary>For each appendage that is doubled the number of its mirror image; −1 for the others.</summary>
    public int[] SecondAppendage { get; private set; } = null!;

    /// <summary>Forks a rig.</summary>
    public static ForkedRig Fork(Rig one, ForkCourse course)
    {
        var forked = new ForkedRig(one, course);
        forked.FindNeck();
        forked.MoveNeck();
        forked.AddJoints();
        forked.Finish();
        return forked;
    }

    /// <summary>The ring at which a joint sits that is there twice.</summary>
    public double RingOf(int joint) => rings[joint];

    /// <summary>Marks the joints of neck and head in front of the fork, and all that hangs on them.</summary>
    private void FindNeck()
    {
        System.Array.Fill(Second, -1);
        IReadOnlyList<Joint> joints = one.Skeleton.Joints;
        for (int bone = 0; bone < one.Spine.Joints.Length; bone++)
        {
            int joint = one.Spine.Joints[bone];
            double ring = one.Line.RingAt(one.Spine.End(bone));
            if (!(joints[joint].Role is JointRole.Neck or JointRole.Head) || ring >= course.Ring)
            {
                break;
            }

            Second[joint] = 0;
            rings[joint] = ring;
        }

        int next = joints.Count;
        for (int j = 0; j < joints.Count; j++)
        {
            int parent = joints[j].Parent;
            if (Second[j] < 0 && parent >= 0 && Second[parent] >= 0 && !(joints[j].Role is JointRole.Neck or JointRole.Head))
            {
                Second[j] = 0;
                rings[j] = joints[parent].Role == JointRole.Head ? ForkCourse.Rigid : rings[parent];
            }

            Second[j] = Second[j] < 0 ? -1 : next++;
        }
    }

    private void MoveNeck()
    {
        IReadOnlyList<Joint> joints = one.Skeleton.Joints;
        for (int j = 0; j < joints.Count; j++)
        {
            if (Second[j] >= 0)
            {
                places[j] = course.Move(rings[j], places[j]);
                turns[j] = Rotation.Normalize(Rotation.Multiply(course.TurnAt(rings[j]), turns[j]));
            }
        }

        // Bones of the neck point at the next joint, which went a little aside of the way that they are turned; a head goes on as it did.
        for (int bone = 0; bone < one.Spine.Joints.Length && Second[one.Spine.Joints[bone]] >= 0; bone++)
        {
            int joint = one.Spine.Joints[bone];
            if (rings[joint] > ForkCourse.Rigid)
            {
                turns[joint] = JointFrame.Hinged(Onward(bone) - places[joint], Rotation.Rotate(turns[joint], Vector3.UnitX));
            }
        }
    }

    private void AddJoints()
    {
        IReadOnlyList<Joint> joints = one.Skeleton.Joints;
        for (int j = 0; j < joints.Count; j++)
        {
            builder.Add(joints[j].Parent, joints[j].Side, Moved(j));
        }

        for (int j = 0; j < joints.Count; j++)
        {
            if (Second[j] < 0)
            {
                continue;
            }

            JointDefinition first = builder[j];
            int parent = Second[joints[j].Parent] >= 0 ? Second[joints[j].Parent] : joints[j].Parent;
            string name = joints[one.Skeleton.Mirrors[j]].Name + Heads.Suffix;
            builder.Add(parent, Opposite(joints[j].Side), new JointDefinition(name, first.Role, Vec.Mirror(first.Position), Rotation.Mirror(first.Rotation), first.Length, first.Limit.Mirrored()));
        }
    }

    /// <summary>Where a bone of neck or head ends.</summary>
    private Vector3 Onward(int bone) => bone > 0 ? places[one.Spine.Joints[bone - 1]] : course.Move(ForkCourse.Rigid, one.Line.HeadTip);

    private JointDefinition Moved(int j)
    {
        Joint joint = one.Skeleton.Joints[j];
        int bone = one.Spine.BoneOf(j);
        bool forked = bone >= 0 && (Second[j] >= 0 || (bone > 0 && Second[one.Spine.Joints[bone - 1]] >= 0));
        float length = forked ? Vec.Distance(places[j], Onward(bone)) : Second[j] >= 0 ? joint.Length * course.SizeAt(rings[j]) : joint.Length;
        return new JointDefinition(joint.Name, joint.Role, places[j], turns[j], length, joint.Limit);
    }

    private void Finish()
    {
        Skeleton skeleton = builder.Build();
        var appendages = new List<AppendageJoints>(one.Appendages);
        SecondAppendage = new int[appendages.Count];
        for (int a = 0; a < SecondAppendage.Length; a++)
        {
            AppendageJoints joints = one.Appendages[a];
            SecondAppendage[a] = -1;
            if (joints.Left.Length > 0 && Second[joints.Left[0]] >= 0)
            {
                SecondAppendage[a] = appendages.Count;
                appendages.Add(new AppendageJoints(Twins(joints.Right), Twins(joints.Left)));
            }
        }

        Rig = new Rig(skeleton, one.Spine, one.Line, appendages, Limbs(skeleton), Points(), Sockets(skeleton), one.Body, one.Head, one.Jaw);
    }

    private LimbChain[] Limbs(Skeleton skeleton)
    {
        var limbs = new List<LimbChain>(one.Limbs);
        var pairs = new Dictionary<LimbKind, int>();
        foreach (LimbChain limb in one.Limbs)
        {
            pairs[limb.Kind] = pairs.TryGetValue(limb.Kind, out int most) ? System.Math.Max(most, limb.Pair) : limb.Pair;
        }

        for (int i = 0; i < one.Limbs.Count; i++)
        {
            LimbChain limb = one.Limbs[i];
            if (Second[limb.Joints[0]] < 0)
            {
                continue;
            }

            double ring = rings[limb.Joints[0]];
            float[] lengths = new float[limb.RestLengths.Count];
            for (int k = 0; k < lengths.Length; k++)
            {
                lengths[k] = Vec.Distance(skeleton.ModelPositions[limb.Joints[k]], skeleton.ModelPositions[limb.Joints[k + 1]]);
            }

            LimbChain moved = limb with { RestLengths = lengths, Pole = Rotation.Rotate(course.TurnAt(ring), limb.Pole), Contact = course.Move(ring, limb.Contact) };
            limbs[i] = moved;
            limbs.Add(moved with
            {
                Side = Opposite(limb.Side),
                Pair = limb.Pair + pairs[limb.Kind],
                Joints = Twins(new List<int>(limb.Joints).ToArray()),
                Pole = Vec.Mirror(moved.Pole),
                Contact = Vec.Mirror(moved.Contact),
            });
        }

        return limbs.ToArray();
    }

    private AttachmentPoint[] Points()
    {
        var points = new List<AttachmentPoint>(one.AttachmentPoints);
        for (int i = 0; i < one.AttachmentPoints.Count; i++)
        {
            AttachmentPoint point = one.AttachmentPoints[i];
            if (Second[point.Joint] >= 0)
            {
                double ring = rings[point.Joint];
                AttachmentPoint moved = point with
                {
                    Position = course.Move(ring, point.Position),
                    Normal = Rotation.Rotate(course.TurnAt(ring), point.Normal),
                    Width = point.Width * course.SizeAt(ring),
                };
                points[i] = moved;
                points.Add(moved with { Name = Mirrored(point.Name) + Heads.Suffix, Joint = Second[point.Joint], Position = Vec.Mirror(moved.Position), Normal = Vec.Mirror(moved.Normal) });
            }
        }

        return points.ToArray();
    }

    private CreatureSocket[] Sockets(Skeleton skeleton)
    {
        var sockets = new List<CreatureSocket>(one.Sockets);
        for (int i = 0; i < one.Sockets.Count; i++)
        {
            CreatureSocket socket = one.Sockets[i];
            if (Second[socket.Joint] >= 0)
            {
                CreatureSocket moved = socket with { Position = socket.Position * course.SizeAt(rings[socket.Joint]) };
                sockets[i] = moved;
                sockets.Add(moved with
                {
                    Name = Mirrored(socket.Name) + Heads.Suffix,
                    Side = Opposite(socket.Side),
                    Joint = Second[socket.Joint],
                    Position = Vec.Mirror(moved.Position),
                    Rotation = Rotation.Mirror(moved.Rotation),
                });
            }
        }

        return sockets.ToArray();
    }

    private int[] Twins(int[] joints) => System.Array.ConvertAll(joints, joint => Second[joint]);

    private static string Mirrored(string name) => name.EndsWith("_Left", System.StringComparison.Ordinal) ? name.Substring(0, name.Length - 4) + "Right"
        : name.EndsWith("_Right", System.StringComparison.Ordinal) ? name.Substring(0, name.Length - 5) + "Left"
        : name;

    private static Side Opposite(Side side) => side == Side.Left ? Side.Right : side == Side.Right ? Side.Left : side;
}
