using System;
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
        SpringRig tail = SpringRig.Along(skeleton, [4, 5, 6, 7, 8]), ears = new(skeleton, [9, 12]);
        (SpringState tailState, SpringState earState) = (new SpringState(tail), new SpringState(ears));
        var limber = new SpringSettings(ChainCurve.Through([0f, 0.5f, 1f], [4f, 2.6f, 1.8f]), new ChainCurve(0.45f), gravity: new Vector3(0f, -3f, 0f), maxSwing: 1f, drag: new ChainCurve(0.5f, 2f));
        var floppy = new SpringSettings(new ChainCurve(1.6f, 1.2f), new ChainCurve(0.25f), new ChainCurve(0.01f), new Vector3(0f, -6f, 0f), maxSwing: 1.6f, drag: new ChainCurve(1f));
        SpringCollider[] skull = [SpringCollider.Capsule(2, new Vector3(0f, -0.01f, 0f), new Vector3(0f, -0.03f, 0.16f), 0.07f)];
        var figure = new StickFigure(6, 240, p => new Vector2(0.47f + (0.66f * p.Z) - (0.3f * p.X), 0.3f + (0.66f * p.Y)));
        Pose local = StickFigure.Room(skeleton), model = StickFigure.Room(skeleton);
        float ahead = 0f;
        for (int i = 0; i < 150; i++)
        {
            double bound = Math.Sin(i * 0.35);
            ahead += i < 50 ? 4f / 60f : 0f;
            var place = new RootPlace(new Vector3(0f, i < 50 ? 0.12f * (float)Math.Abs(bound) : 0f, ahead), Rotation.FromAxisAngle(Vector3.UnitX, i < 50 ? 0.15 * bound : 0));
            local.SetToRest(skeleton);
            local.Rotations[2] = Rotation.FromAxisAngle(Vector3.UnitZ, i >= 100 ? 0.5 * Math.Sin(i * 0.5) : 0);
            ForwardKinematics.LocalToModel(skeleton, local, model);
            SpringBones.Update(tail, tailState, limber, place, ReadOnlySpan<SpringCollider>.Empty, 1f / 60f, local, model);
            SpringBones.Update(ears, earState, floppy, place, skull, 1f / 60f, local, model);
            figure.DrawEvery(25, i, skeleton, model.Positions);
        }

        return figure.Picture;
    }

    private static Skeleton Rig()
    {
        var ear = new Vector3(0.06f, -0.02f, -0.03f);
        (int Parent, Vector3 At)[] bones =
        [
            (-1, Vector3.Zero), (0, new(0f, 0.02f, 0.42f)), (1, new(0f, 0.22f, 0.14f)), (2, new(0f, -0.03f, 0.2f)),
            (0, new(0f, 0.02f, -0.05f)), (4, new(0f, 0.03f, -0.12f)), (5, new(0f, 0.03f, -0.12f)), (6, new(0f, 0.03f, -0.12f)), (7, new(0f, 0.03f, -0.12f)),
            (2, new(0.06f, 0.06f, 0f)), (9, ear), (10, new(0.04f, -0.06f, -0.01f)),
            (2, new(-0.06f, 0.06f, 0f)), (12, new(-ear.X, ear.Y, ear.Z)), (13, new(-0.04f, -0.06f, -0.01f)),
        ];
        return Skeleton.Build([.. bones.Select((bone, i) => new JointPlacement($"Bone {i}", bone.Parent, Quaternion.Identity, bone.At))]);
    }
}
