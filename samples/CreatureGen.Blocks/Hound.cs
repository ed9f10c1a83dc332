using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>Verlet bones of a tail and two ears, each with its own settings: a hound that bounds ahead, stops, and shakes its head.</summary>
internal static class Hound
{
    /// <summary>Six frames from the left: two of the run, two after the stop, two of the shake.</summary>
    public static Picture Strip()
    {
        Skeleton skeleton = Rig();
        SpringRig tail = SpringRig.Along(skeleton, [4, 5, 6, 7, 8]), ears = new(skeleton, [9, 18]);
        (SpringState tailState, SpringState earState) = (new SpringState(tail), new SpringState(ears));
        var limber = new SpringSettings(ChainCurve.Through([0f, 0.5f, 1f], [4f, 2.6f, 1.8f]), new ChainCurve(0.45f), gravity: new Vector3(0f, -3f, 0f), maxSwing: 1f, drag: new ChainCurve(0.5f, 2f));
        var floppy = new SpringSettings(new ChainCurve(1.6f, 1.2f), new ChainCurve(0.25f), new ChainCurve(0.01f), new Vector3(0f, -6f, 0f), maxSwing: 1.6f, drag: new ChainCurve(1f));
        SpringCollider[] skull = [SpringCollider.Capsule(2, new Vector3(0f, -0.01f, 0f), new Vector3(0f, -0.03f, 0.16f), 0.07f)];
        var figure = new BoneStrip(-60, 10, new Vector3(-0.2f, 0f, -0.5f), new Vector3(0.2f, 1.12f, 0.75f), 0.035f);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        for (int i = 0; i < 150; i++)
        {
            (double bound, float ahead) = (i < 50 ? Math.Sin(i * 0.35) : 0, Math.Min(i, 50) / 15f);
            var place = new RootPlace(new Vector3(0f, 0.12f * (float)Math.Abs(bound), ahead), Rotation.FromAxisAngle(Vector3.UnitX, 0.15 * bound));
            Quaternion stride = Rotation.FromAxisAngle(Vector3.UnitX, 1.2 * bound * Math.Cos(i * 0.35));
            local.SetToRest(skeleton);
            local.Rotations[2] = Rotation.FromAxisAngle(Vector3.UnitZ, i >= 100 ? 0.5 * Math.Sin(i * 0.5) : 0);
            (local.Rotations[12], local.Rotations[21], local.Rotations[15], local.Rotations[24]) = (stride, stride, Rotation.Inverse(stride), Rotation.Inverse(stride));
            ForwardKinematics.LocalToModel(skeleton, local, model);
            SpringBones.Update(tail, tailState, limber, place, ReadOnlySpan<SpringCollider>.Empty, 1f / 60f, local, model);
            SpringBones.Update(ears, earState, floppy, place, skull, 1f / 60f, local, model);
            figure.DrawEvery(25, i, skeleton, Array.ConvertAll(model.Positions.ToArray(), p => place.ToWorld(p) - new Vector3(0f, 0f, ahead)));
        }

        return figure.Picture;
    }

    private static Skeleton Rig()
    {
        List<JointPlacement> joints = [];
        void Add(string name, int parent, params Vector3[] at) => joints.AddRange(at.Select((offset, i) => new JointPlacement($"{name} {i}", i == 0 ? parent : joints.Count + i - 1, Quaternion.Identity, offset)).ToArray());
        Add("Trunk", -1, new(0f, 0.55f, 0f), new(0f, 0.02f, 0.42f), new(0f, 0.22f, 0.14f), new(0f, -0.03f, 0.2f));
        Add("Tail", 0, new(0f, 0.02f, -0.05f), new(0f, 0.03f, -0.12f), new(0f, 0.03f, -0.12f), new(0f, 0.03f, -0.12f), new(0f, 0.03f, -0.12f));
        foreach ((string side, float x) in new[] { ("Left", 1f), ("Right", -1f) })
        {
            Add(side + " Ear", 2, new(0.06f * x, 0.06f, 0f), new(0.06f * x, -0.02f, -0.03f), new(0.04f * x, -0.06f, -0.01f));
            Add(side + " Hind Leg", 0, new(0.08f * x, -0.03f, 0f), new(0f, -0.24f, 0.06f), new(0f, -0.26f, -0.06f));
            Add(side + " Fore Leg", 1, new(0.08f * x, -0.05f, 0f), new(0f, -0.25f, -0.03f), new(0f, -0.25f, 0.03f));
        }

        return Skeleton.Build(joints);
    }
}
