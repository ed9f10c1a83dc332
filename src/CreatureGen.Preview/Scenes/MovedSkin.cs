using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Preview.Scenes;

/// <summary>A creature in a pose at a place, as a camera sees it that is somewhere else.</summary>
internal static class MovedSkin
{
    /// <summary>Skin and normals, in the camera's axes, metres.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="place">Where its root is.</param>
    /// <param name="local">Its pose in the parents' space.</param>
    /// <param name="camera">Where the camera is, and which way its +Z goes.</param>
    public static (Vector3[] Positions, Vector3[] Normals) Of(Creature creature, in RootPlace place, in Pose local, in RootPlace camera)
    {
        Skeleton skeleton = creature.Skeleton;
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, Model(skeleton, local), matrices);
        CreatureMesh mesh = creature.Mesh;
        var positions = new Vector3[mesh.Positions.Length];
        var normals = new Vector3[mesh.Positions.Length];
        CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, normals);
        Quaternion seen = Rotation.Multiply(Rotation.Inverse(camera.Rotation), place.Rotation);
        for (int i = 0; i < positions.Length; i++)
        {
            positions[i] = camera.ToModel(place.ToWorld(positions[i]));
            normals[i] = Rotation.Rotate(seen, normals[i]);
        }

        return (positions, normals);
    }

    /// <summary>Where the joints are, world space, metres.</summary>
    public static Vector3[] Joints(Skeleton skeleton, RootPlace place, in Pose local) => Array.ConvertAll(Model(skeleton, local).Positions.ToArray(), place.ToWorld);

    private static Pose Model(Skeleton skeleton, in Pose local)
    {
        var model = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        ForwardKinematics.LocalToModel(skeleton, local, model);
        return model;
    }
}
