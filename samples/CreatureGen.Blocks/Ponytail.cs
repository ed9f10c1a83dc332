using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A ponytail of joints without rotation, as other programs make them, swings as the head turns, and stays out of it.</summary>
internal static class Ponytail
{
    /// <summary>Six frames from behind.</summary>
    public static Picture Strip()
    {
        var joints = new List<JointPlacement> { new("Neck", -1, Quaternion.Identity, Vector3.Zero), new("Head", 0, Quaternion.Identity, new Vector3(0f, 0.15f, 0f)) };
        for (int i = 0; i < 7; i++)
        {
            joints.Add(new JointPlacement($"Hair {i}", i + 1, Quaternion.Identity, i == 0 ? new Vector3(0f, 0.1f, -0.12f) : new Vector3(0f, -0.06f, -0.02f)));
        }

        Skeleton skeleton = Skeleton.Build(joints);
        var rig = new SpringRig(skeleton, [2]);
        var state = new SpringState(rig);
        var settings = new SpringSettings(new ChainCurve(2.5f, 1.2f), new ChainCurve(0.5f), radius: new ChainCurve(0.02f), drag: new ChainCurve(1f));
        SpringCollider[] head = [SpringCollider.Capsule(1, Vector3.Zero, new Vector3(0f, 0.08f, 0f), 0.1f)];
        var figure = new BoneStrip(160, 6, new Vector3(-0.3f, -0.1f, -0.3f), new Vector3(0.3f, 0.38f, 0.1f), 0.025f, GroundKind.None);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        for (int i = 0; i < 6 * 12; i++)
        {
            local.SetToRest(skeleton);
            local.Rotations[1] = Rotation.FromAxisAngle(Vector3.UnitY, 0.7 * Sway(i / 72f));
            ForwardKinematics.LocalToModel(skeleton, local, model);
            SpringBones.Update(rig, state, settings, RootPlace.Identity, head, 1f / 60f, local, model);
            figure.DrawEvery(12, i, skeleton, model.Positions, new BoneStrip.Thing(model.Positions[1], model.Positions[1] + new Vector3(0f, 0.08f, 0f), 0.1f, new Vector3(0.5f, 0.2f, 0.11f)));
        }

        return figure.Picture;
    }

    /// <summary>To one side and to the other in a turn, as parabolas.</summary>
    private static float Sway(float turns) => turns < 0.5f ? 16f * turns * (0.5f - turns) : 16f * (turns - 0.5f) * (turns - 1f);
}
