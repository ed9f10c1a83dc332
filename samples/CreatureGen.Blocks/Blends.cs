using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>Keys and blends: a puppet's walk and its cheer, each a few keys on a skeleton made by hand, mixed by 0, 20, 40 to 100 %; its left arm follows the cheer alone from the start.</summary>
internal static class Blends
{
    /// <summary>Six mixtures from ahead and to the side.</summary>
    public static Picture Strip()
    {
        Skeleton skeleton = Puppet.Rig();
        IClip walk = Keys("Walk", skeleton, ("Left Thigh", Vector3.UnitX, [-0.6, 0.6, -0.6]), ("Right Thigh", Vector3.UnitX, [0.6, -0.6, 0.6]), ("Left Arm", Vector3.UnitX, [0.5, -0.5, 0.5]), ("Right Arm", Vector3.UnitX, [-0.5, 0.5, -0.5]));
        IClip cheer = Keys("Cheer", skeleton, ("Left Arm", Vector3.UnitZ, [2.2, 2.7, 2.2]), ("Right Arm", Vector3.UnitZ, [-2.2, -2.7, -2.2]), ("Head", Vector3.UnitX, [-0.3, 0.0, -0.3]));
        float[] mask = new float[skeleton.Count];
        Subtree.FillMask(skeleton, skeleton.IndexOf("Left Arm"), 1f, mask);
        var figure = new BoneStrip(35, 8, new Vector3(-0.6f, 0f, -0.4f), new Vector3(0.6f, 2.1f, 0.4f), 0.06f);
        Pose walking = BoneStrip.Room(skeleton), cheering = BoneStrip.Room(skeleton), mixed = BoneStrip.Room(skeleton);
        for (int i = 0; i < 6; i++)
        {
            walk.Sample(0.2f * i, walking);
            cheer.Sample(0.2f * i, cheering);
            PoseBlend.Slerp(walking, cheering, i / 5f, mixed);
            PoseBlend.Mix(mixed, cheering, 1f, mask, mixed);
            ForwardKinematics.LocalToModel(skeleton, mixed, mixed);
            figure.Draw(i, figure.Bones(skeleton, mixed.Positions));
        }

        return figure.Picture;
    }

    /// <summary>A clip of a second: joints that turn about an axis to angles at even times; all others at rest.</summary>
    private static KeyedClip Keys(string name, Skeleton skeleton, params (string Joint, Vector3 Axis, double[] Angles)[] turns)
    {
        var rotations = new List<KeyTrack>();
        var positions = new List<KeyTrack>();
        foreach (Joint joint in skeleton.Joints)
        {
            (_, Vector3 axis, double[] angles) = turns.FirstOrDefault(turn => turn.Joint == joint.Name, (joint.Name, Vector3.UnitX, [0.0]));
            float[] times = [.. angles.Select((_, i) => angles.Length > 1 ? i / (angles.Length - 1f) : 0f)];
            rotations.Add(KeyTrack.OfRotations(times, Array.ConvertAll(angles, a => Rotation.FromAxisAngle(axis, a)), KeyInterpolation.Linear));
            positions.Add(KeyTrack.OfPositions([0f], [joint.LocalPosition], KeyInterpolation.Step));
        }

        return new KeyedClip(name, ClipEnd.Loops, 1f, 0f, rotations, positions, []);
    }
}
