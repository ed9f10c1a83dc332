using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A ragdoll of a skeleton made by hand: a puppet is pushed, trips and comes to rest on the ground.</summary>
internal static class Puppet
{
    /// <summary>Six frames from the side.</summary>
    public static Picture Strip()
    {
        Skeleton skeleton = Rig();
        var rig = new RagdollRig(skeleton, [.. Enumerable.Range(0, skeleton.Count).Where(i => skeleton.Joints[i].Length > 0f).Select(i => new CapsuleCollider(i, Vector3.Zero, skeleton.Joints[i].Along * skeleton.Joints[i].Length, 0.06f))]);
        var state = new RagdollState(rig);
        Pose local = BoneStrip.Room(skeleton), model = BoneStrip.Room(skeleton);
        model.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, model, model);
        Ragdoll.Start(rig, state, RootPlace.Identity, model, RootPlace.Identity, model, 1f / 60f, FlatGround.Level);
        state.Push(skeleton.IndexOf("Chest"), new Vector3(1.5f, 0f, 7f), model.Positions[skeleton.IndexOf("Chest")] + new Vector3(0.05f, 0.2f, 0f));
        var figure = new BoneStrip(-70, 10, new Vector3(-0.4f, 0f, -0.3f), new Vector3(0.4f, 1.75f, 1.5f), 0.06f);
        for (int i = 0; i < 6 * 14; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, 1f / 60f);
            Ragdoll.Show(rig, state, RootPlace.Identity, local, model);
            figure.DrawEvery(14, i, skeleton, model.Positions);
        }

        return figure.Picture;
    }

    /// <summary>A figure of fifteen bones, 1.75 m tall, with its arms hanging; joints have no rotation.</summary>
    internal static Skeleton Rig()
    {
        var joints = new List<JointPlacement>();
        void Add(string name, string? parent, Vector3 at, JointLimit limit) => joints.Add(new JointPlacement(name, joints.FindIndex(j => j.Name == parent), Quaternion.Identity, at) { Limit = limit });
        JointLimit loose = new(0.5f, 0.4f, 0.4f);
        Add("Hips", null, new Vector3(0f, 0.92f, 0f), JointLimit.Free);
        Add("Chest", "Hips", new Vector3(0f, 0.2f, 0f), loose);
        Add("Head", "Chest", new Vector3(0f, 0.4f, 0f), loose);
        Add("Crown", "Head", new Vector3(0f, 0.23f, 0f), loose);
        foreach ((string side, float x) in new[] { ("Left", 1f), ("Right", -1f) })
        {
            Add($"{side} Arm", "Chest", new Vector3(0.2f * x, 0.33f, 0f), new JointLimit(1.4f, 1.4f, 0.5f));
            Add($"{side} Elbow", $"{side} Arm", new Vector3(0.04f * x, -0.28f, 0f), new JointLimit(0.9f, 0.1f, 0.1f));
            Add($"{side} Hand", $"{side} Elbow", new Vector3(0.02f * x, -0.26f, 0.02f), loose);
            Add($"{side} Thigh", "Hips", new Vector3(0.1f * x, -0.04f, 0f), new JointLimit(1.2f, 0.5f, 0.3f));
            Add($"{side} Knee", $"{side} Thigh", new Vector3(0f, -0.42f, 0.01f), new JointLimit(0.9f, 0.05f, 0.05f));
            Add($"{side} Foot", $"{side} Knee", new Vector3(0f, -0.42f, -0.01f), loose);
            Add($"{side} Toe", $"{side} Foot", new Vector3(0f, -0.04f, 0.15f), loose);
        }

        return Skeleton.Build(joints);
    }
}
