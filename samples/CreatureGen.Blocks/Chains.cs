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
        var figure = new StickFigure(6, 240, p => new Vector2(0.5f + (0.5f * p.Z), 0.3f + (0.6f * p.Y)));
        Pose local = StickFigure.Room(skeleton), model = StickFigure.Room(skeleton);
        local.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, local, model);
        for (int frame = 0; frame < 6; frame++)
        {
            var target = new Vector3(0f, 0.45f - (0.1f * frame), 0.55f - (0.05f * frame));
            CcdIk.Apply(skeleton, chain, target, CcdSettings.Default, local, model);
            figure.Draw(frame, skeleton, model.Positions);
            figure.Dot(frame, target);
        }

        return figure.Picture;
    }
}
