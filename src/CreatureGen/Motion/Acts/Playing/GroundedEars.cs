using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Folds ears out of the ground on which a head lies: they give way there, as gristle does, and the head need not.</summary>
internal static class GroundedEars
{
    /// <summary>How often each joint is turned, and by how much at most at a time, radians.</summary>
    private const int Rounds = 4;
    private const float MaxTurn = 0.5f;

    /// <summary>Folds all of them, each from its root outwards.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="ground">That they may be in.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public static void Keep(ActBody body, in ActGround ground, in Pose local, in Pose model)
    {
        foreach ((int joint, BonePoints skin) in body.EarSkins)
        {
            for (int round = 0; round < Rounds; round++)
            {
                float depth = -skin.Lowest(ground, model, out Vector3 lowest);
                if (!(depth > 0f))
                {
                    break;
                }

                Lift(body.Skeleton, joint, lowest - model.Positions[joint], depth, local, model);
            }
        }
    }

    /// <summary>Turns a joint so that a point that hangs on it comes up, straight towards the sky.</summary>
    private static void Lift(Skeleton skeleton, int joint, Vector3 lever, float by, in Pose local, in Pose model)
    {
        float length = Vec.Length(lever);
        float height = Math.Min(lever.Y + by, length);
        float angle = Elevation(height, length) - Elevation(lever.Y, length);
        Vector3 axis = Vec.Normalize(Vec.Cross(lever, Vector3.UnitY), Vector3.UnitX);
        Quaternion turn = Rotation.FromAxisAngle(axis, Math.Min(angle, MaxTurn));
        Quaternion parent = model.Rotations[skeleton.Parents[joint]];
        Quaternion turned = Rotation.Multiply(Rotation.Inverse(parent), Rotation.Multiply(turn, model.Rotations[joint]));
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(turned), skeleton.AllJoints[joint]);
        Subtree.LocalToModel(skeleton, joint, local, model);
    }

    private static float Elevation(float height, float length) => FastTrigonometry.Of(height, (float)Math.Sqrt(Math.Max((length * length) - (height * height), 0f)));
}
