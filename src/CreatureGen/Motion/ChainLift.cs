using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>Raises chains out of the ground whose outer joints turn no farther: all joints from the root of the chain to the bone that is in it share the turn.</summary>
internal static class ChainLift
{
    private const int Rounds = 3;

    /// <summary>Radians that a joint turns in a round at the most.</summary>
    private const float MaxTurn = 0.2f;

    /// <summary>Raises every bone whose tip is too low, those next to the root first.</summary>
    /// <param name="rig">The chains.</param>
    /// <param name="ground">Height of the ground at the root of the body, model space.</param>
    /// <param name="rise">How it goes on along the body, metres up for each metre ahead.</param>
    /// <param name="radius">Metres that bones keep from it, along the chain.</param>
    /// <param name="local">Receives the rotations, within the joints' limits.</param>
    /// <param name="model">Receives what follows from them.</param>
    public static void Raise(SpringRig rig, float ground, float rise, ChainCurve radius, in Pose local, in Pose model)
    {
        for (int round = 0; round < Rounds; round++)
        {
            bool raised = false;
            for (int i = 0; i < rig.Joints.Length; i++)
            {
                raised |= Raise(rig, i, ground + Math.Max(radius.At(rig.Places[i]), 0f), rise, local, model);
            }

            if (!raised)
            {
                return;
            }
        }
    }

    private static bool Raise(SpringRig rig, int bone, float min, float rise, in Pose local, in Pose model)
    {
        int joint = rig.Joints[bone];
        Vector3 tip = model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], rig.Bones[bone].Direction * rig.Bones[bone].Length);
        float deep = min + (rise * tip.Z) - tip.Y;
        if (!(deep > 0f))
        {
            return false;
        }

        int root = bone;
        while (rig.Bones[root].Parent >= 0)
        {
            root = rig.Bones[root].Parent;
        }

        Vector3 way = tip - model.Positions[rig.Joints[root]];
        way.Y = 0f;
        way = Vec.Normalize(way, -Vector3.UnitZ);
        float lever = 0f;
        for (int k = bone; k >= 0; k = rig.Bones[k].Parent)
        {
            lever += Math.Max(Vec.Dot(tip - model.Positions[rig.Joints[k]], way), 0f);
        }

        float angle = Math.Min(deep / Math.Max(lever, 1e-6f), MaxTurn);
        Quaternion turn = AxisRotation.About(Vec.Cross(way, Vector3.UnitY), angle);
        for (int k = bone; k >= 0; k = rig.Bones[k].Parent)
        {
            Turn(rig.Skeleton, rig.Joints[k], turn, local, model);
        }

        Subtree.LocalToModel(rig.Skeleton, rig.Joints[root], local, model);
        return true;
    }

    private static void Turn(Skeleton skeleton, int joint, Quaternion turn, in Pose local, in Pose model)
    {
        Quaternion inModel = Rotation.Multiply(turn, model.Rotations[joint]);
        int parent = skeleton.Parents[joint];
        Quaternion turned = parent < 0 ? inModel : Rotation.Multiply(Rotation.Inverse(model.Rotations[parent]), inModel);
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(turned), skeleton.AllJoints[joint]);
    }
}
