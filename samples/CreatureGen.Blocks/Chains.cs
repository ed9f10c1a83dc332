using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A chain of hinges reaches for a point that moves.</summary>
internal static class Chains
{
    /// <summary>Six frames from the side.</summary>
    public static Picture Strip()
    {
        var joints = new List<JointPlacement>();
        int[] chain = new int[9];
        for (int i = 0; i < chain.Length; i++)
        {
            joints.Add(new JointPlacement($"Link {i}", i - 1, Quaternion.Identity, new Vector3(0f, i == 0 ? 0f : 0.1f, 0f)) { Limit = new JointLimit(1.2f, 0f, 0f) });
            chain[i] = i;
        }

        Skeleton skeleton = Skeleton.Build(joints);
        var figure = new BoneStrip(-70, 8, new Vector3(-0.1f, 0f, -0.1f), new Vector3(0.1f, 0.75f, 0.7f), 0.03f);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        local.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, local, model);
        for (int frame = 0; frame < 6; frame++)
        {
            var target = new Vector3(0f, 0.55f - (0.08f * frame), 0.55f - (0.05f * frame));
            CcdIk.Apply(skeleton, chain, target, CcdSettings.Default, local, model);
            figure.Draw(frame, figure.Bones(skeleton, model.Positions, new BoneStrip.Thing(target, target, 0.05f, new Vector3(0.75f, 0.14f, 0.07f))));
        }

        return figure.Picture;
    }
}
