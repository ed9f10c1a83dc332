using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>The gecko of Making Bonehead on a skeleton made by hand: the body goes around a curve, the head looks at a point, four feet step after the body in diagonal pairs.</summary>
internal static class Gecko
{
    private static readonly Vector3[] hips = [new(0.1f, 0f, 0.25f), new(-0.1f, 0f, 0.25f), new(0.1f, 0f, -0.25f), new(-0.1f, 0f, -0.25f)];
    private static readonly int[] diagonals = [0, 1, 1, 0];

    /// <summary>Six frames of a walk around a curve, from above.</summary>
    public static Picture Strip()
    {
        Skeleton skeleton = Rig();
        var figure = new BoneStrip(-150, 42, new Vector3(-0.4f, 0f, -0.5f), new Vector3(0.4f, 0.2f, 0.6f), 0.035f);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        RootPlace place = RootPlace.Identity;
        (SteppingFoot[] feet, BodyVelocity velocity, int turn) = (Array.ConvertAll(hips, hip => new SteppingFoot(Home(hip))), default, -1);
        for (int i = 0; i < 180; i++)
        {
            place = VelocityDamping.Advance(ref velocity, new BodyVelocity(new Vector3(0f, 0f, 0.25f), 0.4f), 5f, 5f, 1f / 60f).From(place);
            LegStepper.Update(feet, diagonals, Array.ConvertAll(hips, hip => place.ToWorld(Home(hip))), new LegStepSettings(0.12f, 0.16f), FlatGround.Level, Vector3.UnitY, 1f / 60f, ref turn);
            local.SetToRest(skeleton);
            ForwardKinematics.LocalToModel(skeleton, local, model);
            local.Rotations[1] = AimAt.Turn(local.Rotations[1], Vector3.UnitZ, Vector3.UnitY, place.ToModel(new Vector3(1f, 0.3f, 1f)) - model.Positions[1], Vector3.UnitY);
            ForwardKinematics.LocalToModel(skeleton, local, model);
            for (int leg = 0; leg < 4; leg++)
            {
                TwoBoneIk.Apply(skeleton, 3 + (3 * leg), 4 + (3 * leg), 5 + (3 * leg), place.ToModel(feet[leg].Position), new Vector3(hips[leg].X, 0.3f, 0f), Reach.Default, 1f, local, model);
            }

            figure.DrawEvery(30, i, skeleton, model.Positions);
        }

        return figure.Picture;
    }

    private static Vector3 Home(Vector3 hip) => new(2.6f * hip.X, 0f, hip.Z);

    private static Skeleton Rig()
    {
        var joints = new List<JointPlacement> { new("Body", -1, Quaternion.Identity, new Vector3(0f, 0.15f, 0f)), new("Head", 0, Quaternion.Identity, new Vector3(0f, 0.02f, 0.4f)), new("Nose", 1, Quaternion.Identity, new Vector3(0f, 0f, 0.15f)) };
        for (int leg = 0; leg < 4; leg++)
        {
            (string side, float aside) = (hips[leg].X > 0f ? "Left" : "Right", 1.4f * hips[leg].X);
            joints.Add(new JointPlacement($"{side} Hip {leg}", 0, Quaternion.Identity, hips[leg]));
            joints.Add(new JointPlacement($"{side} Knee {leg}", 3 + (3 * leg), Quaternion.Identity, new Vector3(aside, 0.06f, 0f)));
            joints.Add(new JointPlacement($"{side} Foot {leg}", 4 + (3 * leg), Quaternion.Identity, new Vector3(aside, -0.12f, 0f)));
        }

        return Skeleton.Build(joints);
    }
}
