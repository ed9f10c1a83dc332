using System;
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

    private readonly ActBody body;
    private readonly Vector3 mouth;
    private readonly Vector3 brow;
    private readonly int[] leftArm;
    private readonly int[] rightArm;

    public ActTools(ActBody body)
    {
        this.body = body;
        leftArm = ArmOn(Side.Left);
        rightArm = ArmOn(Side.Right);
        if (body.Head >= 0)
        {
            Vector3 snout = Extreme(Vector3.UnitZ);
            Vector3 tip = body.Jaw >= 0 ? (snout + EndOf(body.Jaw)) * 0.5f : snout;
            mouth = ToJoint(body.Head, tip);
            ChinBelowMouth = Vec.Distance(tip, body.Jaw >= 0 ? EndOf(body.Jaw) : Vec.Lerp(snout, body.Skeleton.ModelPositions[body.Head], JawlessChin));
            brow = ToJoint(body.Head, Extreme(browDirection));
        }
    }

    /// <summary>How far the chin is below the mouth point, metres.</summary>
    public float ChinBelowMouth { get; }

    /// <summary>The joint that carries a tool; −1 where the body has none.</summary>
    /// <param name="tool">Which.</param>
    /// <param name="mirrored">Whether the act's side is the right.</param>
    public int JointOf(ActTool tool, bool mirrored) => tool switch
    {
        ActTool.Mouth or ActTool.Brow => body.Head,
        ActTool.ForeFoot => BallOf(body.ForeFeet, mirrored),
        ActTool.HindFoot => BallOf(body.HindFeet, mirrored),
        ActTool.Hand => HandOf(mirrored),
        ActTool.Tail => body.Tail.Count > 0 ? body.Tail.Joints[^1] : -1,
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
            ActTool.Tail => new Vector3(0f, body.Skeleton.AllJoints[joint].Length, 0f),
            _ => Vector3.Zero,
        };
        return model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], point);
    }

    /// <summary>Shoulder to hand of a side; empty without an arm.</summary>
    public int[] ArmOf(bool mirrored) => mirrored ? rightArm : leftArm;

    /// <summary>The foot of a pair on the act's side, as an index of legs; −1 without.</summary>
    public static int FootOf((int Left, int Right) pair, bool mirrored) => mirrored ? pair.Right : pair.Left;

    private int BallOf((int Left, int Right) pair, bool mirrored)
    {
        int foot = FootOf(pair, mirrored);
        return foot < 0 ? -1 : body.Legs!.Legs[foot].Ball;
    }

    private int HandOf(bool mirrored)
    {
        int[] arm = ArmOf(mirrored);
        return arm.Length == 0 ? -1 : arm[^1];
    }

    private int[] ArmOn(Side side)
    {
        foreach (LimbChain arm in body.Arms)
        {
            if (arm.Side == side)
            {
                return new[] { arm.Joints[1], arm.Joints[2], arm.Joints[3], arm.Joints[4] };
            }
        }

        return Array.Empty<int>();
    }

    private Vector3 EndOf(int joint) =>
        body.Skeleton.ModelPositions[joint] + Rotation.Rotate(body.Skeleton.ModelRotations[joint], new Vector3(0f, body.Skeleton.Joints[joint].Length, 0f));

    private Vector3 ToJoint(int joint, Vector3 model) => Rotation.Rotate(Rotation.Inverse(body.Skeleton.ModelRotations[joint]), model - body.Skeleton.ModelPositions[joint]);

    /// <summary>The farthest point of the head's skin in a direction, on the midline.</summary>
    private Vector3 Extreme(Vector3 direction)
    {
        Vector3 farthest = body.Skeleton.ModelPositions[body.Head];
        ReadOnlySpan<Vector3> positions = body.Subject.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            if (body.Subject.Mesh.Weights[v].Joint0 == body.Head && Vec.Dot(positions[v], direction) > Vec.Dot(farthest, direction))
            {
                farthest = positions[v];
            }
        }

        farthest.X = 0f;
        return farthest;
    }
}
