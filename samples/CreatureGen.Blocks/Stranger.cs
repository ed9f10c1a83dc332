using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A four-legged skeleton of another program, whose joints only have names, is walked over a bump: its legs are found by what the names say.</summary>
internal static class Stranger
{
    /// <summary>Six frames from the left.</summary>
    public static Picture Strip()
    {
        Skeleton skeleton = Rig();
        var legs = SteppingLegs.Of(skeleton);
        var ground = new HeightFieldGround([.. Enumerable.Range(0, 11 * 41).Select(i => Bump((0.1f * (i / 11)) - 1f))], 11, 0.1f, new Vector3(-0.5f, 0f, -1f));
        (Vector3[] homes, float height, int turn) = (new Vector3[legs.Count], 0f, -1);
        legs.FillHomes(RootPlace.Identity, homes);
        SteppingFoot[] feet = Array.ConvertAll(homes, home => new SteppingFoot(home));
        var figure = new BoneStrip(-70, 8, new Vector3(-0.3f, 0f, -0.6f), new Vector3(0.3f, 1.1f, 1f), 0.045f);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        for (int i = 0; i < 240; i++)
        {
            height += 0.08f * (feet.Average(foot => foot.Position.Y) - 0.03f - height);
            var place = new RootPlace(new Vector3(0f, height, i / 180f), Quaternion.Identity);
            legs.FillHomes(new RootPlace(place.Position with { Y = 0f }, place.Rotation), homes);
            LegStepper.Update(feet, legs.Groups, homes, new LegStepSettings(0.14f, 0.16f), ground, Vector3.UnitY, 1f / 60f, ref turn);
            local.SetToRest(skeleton);
            ForwardKinematics.LocalToModel(skeleton, local, model);
            legs.Apply(feet, place, local, model);
            figure.DrawEvery(40, i, skeleton, Array.ConvertAll(model.Positions.ToArray(), p => p + new Vector3(0f, place.Position.Y - 0.05f, 0f)), [.. Enumerable.Range(5, 11).Select(i => 0.1f * i).Select(z => Log(Bump(z), z - place.Position.Z))]);
        }

        return figure.Picture;
    }

    private static float Bump(float z) => 0.12f * MathF.Max(0f, 1f - (2f * MathF.Abs(z - 1f)));

    /// <summary>A log across the way at a height, so far ahead.</summary>
    private static BoneStrip.Thing Log(float height, float ahead) => new(new Vector3(-0.3f, height - 0.06f, ahead), new Vector3(0.3f, height - 0.06f, ahead), 0.04f, new Vector3(0.3f, 0.22f, 0.14f));

    private static Skeleton Rig()
    {
        List<JointPlacement> joints = [Named("Bip01 Pelvis", -1, new(0f, 0.7f, -0.1f)), Named("Bip01 Spine", 0, new(0f, 0.05f, 0.55f)), Named("Bip01 Neck", 1, new(0f, 0.25f, 0.15f)), Named("Bip01 Head", 2, new(0f, 0.05f, 0.2f))];
        foreach ((string side, float x) in new[] { ("L", 0.12f), ("R", -0.12f) })
        {
            joints.AddRange([Named($"Bip01 {side} Thigh", 0, new(x, -0.05f, 0f)), Named($"Bip01 {side} Calf", joints.Count, new(0f, -0.3f, 0.05f)), Named($"Bip01 {side} Foot", joints.Count + 1, new(0f, -0.28f, -0.08f))]);
            joints.AddRange([Named($"Bip01 {side} UpperArm", 1, new(x, -0.1f, 0f)), Named($"Bip01 {side} Forearm", joints.Count, new(0f, -0.3f, -0.06f)), Named($"Bip01 {side} Hand", joints.Count + 1, new(0f, -0.28f, 0.05f))]);
        }

        return Skeleton.Build(joints);

        static JointPlacement Named(string name, int parent, Vector3 at) => new(name, parent, Quaternion.Identity, at);
    }
}
