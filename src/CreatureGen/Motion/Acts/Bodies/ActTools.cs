using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>Where a body's mouth, brow, feet, hands and tail end are: points of joints.</summary>
internal sealed class ActTools
{
    private static readonly Vector3 browDirection = Vec.Normalize(new Vector3(0f, 0.55f, 0.85f));

    /// <summary>How far the chin of a head without a jaw is below its mouth, parts of the head's length.</summary>
    private const float JawlessChin = 0.3f;

    private readonly MotionSubject subject;
    private readonly int head;
    private readonly TurnedChain tail;
    private readonly (int Left, int Right) foreBalls;
    private readonly (int Left, int Right) hindBalls;
    private readonly Vector3 mouth;
    private readonly Vector3 brow;
    private readonly int[] leftArm;
    private readonly int[] rightArm;

    /// <summary>Finds them.</summary>
    /// <param name="subject">Gives bones and skin.</param>
    /// <param name="head">The head's joint; −1 without.</param>
    /// <param name="jaw">The jaw's joint; −1 without.</param>
    /// <param name="arms">Its arms.</param>
    /// <param name="tail">Its tail.</param>
    /// <param name="foreBalls">Joints of the balls of the foremost pair of feet; −1 without.</param>
    /// <param name="hindBalls">The same of the rearmost pair.</param>
    public ActTools(MotionSubject subject, int head, int jaw, IReadOnlyList<LimbChain> arms, TurnedChain tail, (int Left, int Right) foreBalls, (int Left, int Right) hindBalls)
    {
        this.subject = subject;
        this.head = head;
        this.tail = tail;
        this.foreBalls = foreBalls;
        this.hindBalls = hindBalls;
        leftArm = ArmOn(arms, Side.Left);
        rightArm = ArmOn(arms, Side.Right);
        if (head >= 0)
        {
            Vector3 snout = Extreme(Vector3.UnitZ);
            Vector3 tip = jaw >= 0 ? (snout + EndOf(jaw)) * 0.5f : snout;
            mouth = ToJoint(head, tip);
            ChinBelowMouth = Vec.Distance(tip, jaw >= 0 ? EndOf(jaw) : Vec.Lerp(snout, subject.Skeleton.ModelPositions[head], JawlessChin));
            brow = ToJoint(head, Extreme(browDirection));
        }
    }

    /// <summary>How far the chin is below the mouth point, metres.</summary>
    public float ChinBelowMouth { get; }

    /// <summary>The joint that carries a tool; −1 where the body has none.</summary>
    /// <param name="tool">Which.</param>
    /// <param name="mirrored">Whether the act's side is the right.</param>
    public int JointOf(ActTool tool, bool mirrored) => tool switch
    {
        ActTool.Mouth or ActTool.Brow => head,
        ActTool.ForeFoot => FootOf(foreBalls, mirrored),
        ActTool.HindFoot => FootOf(hindBalls, mirrored),
        ActTool.Hand => HandOf(mirrored),
        ActTool.Tail => tail.Count > 0 ? tail.Joints[^1] : -1,
        _ => -1,
    };

    /// <summary>Where a tool is.</summary>
    /// <param name="tool">Which.</param>
    /// <param name="mirrored">Whether the act's side is the right.</param>
    /// <param name="model">Pose in model space.</param>
    public Vector3 PlaceOf(ActTool tool, bool mirrored, in Pose model)
    {
        int joint = JointOf(tool, mirrored);
        Vector3 point = tool switch
        {
            ActTool.Mouth => mouth,
            ActTool.Brow => brow,
            ActTool.Tail => new Vector3(0f, subject.Skeleton.AllJoints[joint].Length, 0f),
            _ => Vector3.Zero,
        };
        return model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], point);
    }

    /// <summary>Shoulder to hand of a side; empty without an arm.</summary>
    public int[] ArmOf(bool mirrored) => mirrored ? rightArm : leftArm;

    /// <summary>The foot of a pair on the act's side; −1 without.</summary>
    public static int FootOf((int Left, int Right) pair, bool mirrored) => mirrored ? pair.Right : pair.Left;

    private int HandOf(bool mirrored)
    {
        int[] arm = ArmOf(mirrored);
        return arm.Length == 0 ? -1 : arm[^1];
    }

    private static int[] ArmOn(IReadOnlyList<LimbChain> arms, Side side)
    {
        foreach (LimbChain arm in arms)
        {
            if (arm.Side == side)
            {
                return new[] { arm.Joints[1], arm.Joints[2], arm.Joints[3], arm.Joints[4] };
            }
        }

        return Array.Empty<int>();
    }

    private Vector3 EndOf(int joint) =>
        subject.Skeleton.ModelPositions[joint] + Rotation.Rotate(subject.Skeleton.ModelRotations[joint], new Vector3(0f, subject.Skeleton.Joints[joint].Length, 0f));

    private Vector3 ToJoint(int joint, Vector3 model) => Rotation.Rotate(Rotation.Inverse(subject.Skeleton.ModelRotations[joint]), model - subject.Skeleton.ModelPositions[joint]);

    /// <summary>The farthest point of the head's skin in a direction, on the midline.</summary>
    private Vector3 Extreme(Vector3 direction)
    {
        Vector3 farthest = subject.Skeleton.ModelPositions[head];
        ReadOnlySpan<Vector3> positions = subject.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            if (subject.Mesh.Weights[v].Joint0 == head && Vec.Dot(positions[v], direction) > Vec.Dot(farthest, direction))
            {
                farthest = positions[v];
            }
        }

        farthest.X = 0f;
        return farthest;
    }
}
