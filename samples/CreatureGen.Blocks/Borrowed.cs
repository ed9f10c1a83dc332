using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;

namespace CreatureGen.Blocks;

/// <summary>A person's walk on a grown biped: joints are matched by what their names and roles say, and feet go where the person's go, in the scale of the legs.</summary>
internal static class Borrowed
{
    /// <summary>Six frames of a cycle: the person, as tall in its legs as the creature, and the creature that follows it.</summary>
    public static Picture Strip()
    {
        (Skeleton person, KeyedClip walk) = (Walker.Rig(), Walker.Walk());
        Creature biped = CreatureGenerator.Generate(2, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0, BaseBodies = new(BaseBodyNames.All.Select(name => new BaseBodyWeight(name, name == "ostrich" ? 1 : 0))) });
        var map = new RetargetMap(person, biped.Skeleton);
        Clip borrowed = ClipRetargeting.Apply(walk, map, "PersonWalk");
        var (low, high) = (biped.Mesh.Positions.ToArray().Aggregate(Vector3.Min), biped.Mesh.Positions.ToArray().Aggregate(Vector3.Max));
        Vector3 ahead = new(0f, 0f, high.Z + (0.5f * map.Scale));
        var strip = new BoneStrip(70, 8, low, high + ahead, 0.05f * map.Scale);
        for (int frame = 0; frame < 6; frame++)
        {
            Pose first = At(person, walk, walk.Duration * frame / 6f), second = At(biped.Skeleton, borrowed, borrowed.Duration * frame / 6f);
            (Matrix4x4[] matrices, Vector3[] skin, Vector3[] normals) = (new Matrix4x4[biped.Skeleton.Count], new Vector3[biped.Mesh.Positions.Length], new Vector3[biped.Mesh.Positions.Length]);
            SkinMatrices.Fill(biped.Skeleton, second, matrices);
            CpuSkinning.Skin(matrices, biped.Mesh.Weights, biped.Mesh.Positions, biped.Mesh.Normals, skin, normals);
            strip.Draw(frame, RenderMesh.From(biped, skin, normals).With(strip.Bones(person, Array.ConvertAll(first.Positions.ToArray(), p => (map.Scale * p) + ahead))));
        }

        return strip.Picture;
    }

    private static Pose At(Skeleton skeleton, IClip clip, float time)
    {
        Pose pose = BoneStrip.Room(skeleton);
        clip.Sample(time, pose);
        ForwardKinematics.LocalToModel(skeleton, pose, pose);
        return pose;
    }
}
