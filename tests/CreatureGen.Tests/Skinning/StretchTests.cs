using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Skinning;

/// <summary>What clips do to the skin. The creatures are those of thick legs, and of wings with long feathers, whose skin fared worst among some hundreds.</summary>
public sealed class StretchTests
{
    private const int Times = 16;

    [Theory]
    [InlineData(RequestedKind.Walking, 619)]
    [InlineData(RequestedKind.Walking, 5002, Explicit = true)]
    [InlineData(RequestedKind.Walking, 5003, Explicit = true)]
    [InlineData(RequestedKind.Walking, 5029, Explicit = true)]
    [InlineData(RequestedKind.Walking, 5045, Explicit = true)]
    [InlineData(RequestedKind.Walking, 5053, Explicit = true)]
    [InlineData(RequestedKind.Flying, 509, Explicit = true)]
    [InlineData(RequestedKind.Flying, 5043, Explicit = true)]
    [InlineData(RequestedKind.Flying, 5053, Explicit = true)]
    [InlineData(RequestedKind.Flying, 5084, Explicit = true)]
    [InlineData(RequestedKind.Flying, 5115, Explicit = true)]
    [InlineData(RequestedKind.Flying, 8103, Explicit = true)]
    [InlineData(RequestedKind.Flying, 8109, Explicit = true)]
    [InlineData(RequestedKind.Flying, 9202, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 5004)]
    [InlineData(RequestedKind.Swimming, 8204, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 9041, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 9084, Explicit = true)]
    public void In_no_clip_do_more_than_one_in_a_hundred_triangles_change_their_area_fourfold(RequestedKind kind, int seed)
    {
        Creature creature = CreatureGenerator.Generate((ulong)seed, new CreatureOptions { Kind = kind, Strangeness = 0 });
        CreatureMesh mesh = creature.Mesh;
        ReadOnlySpan<int> triangles = mesh.Triangles;
        var moved = new Vector3[mesh.Positions.Length];
        var normals = new Vector3[mesh.Positions.Length];
        float[] rest = Areas(mesh.Positions, triangles);
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        var model = new Pose(new Quaternion[creature.Skeleton.Count], new Vector3[creature.Skeleton.Count]);
        foreach (Clip clip in ClipBaker.Bake(creature))
        {
            var stretched = new bool[rest.Length];
            for (int k = 0; k < Times; k++)
            {
                int frame = (int)((k + 0.5) / Times * (clip.Frames - 1));
                clip.RotationsAt(frame).CopyTo(model.Rotations);
                clip.PositionsAt(frame).CopyTo(model.Positions);
                ForwardKinematics.LocalToModel(creature.Skeleton, model, model);
                SkinMatrices.Fill(creature.Skeleton, model, matrices);
                CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, moved, normals);
                float[] areas = Areas(moved, triangles);
                for (int t = 0; t < rest.Length; t++)
                {
                    stretched[t] |= areas[t] > 4f * rest[t] || areas[t] * 4f < rest[t];
                }
            }

            double share = Array.FindAll(stretched, s => s).Length / (double)stretched.Length;
            Assert.True(share <= 0.0103, $"{clip.Name}: {share:P2}");
        }
    }

    private static float[] Areas(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        float[] areas = new float[triangles.Length / 3];
        for (int t = 0; t < areas.Length; t++)
        {
            Vector3 a = positions[triangles[3 * t]];
            areas[t] = Vec.Length(Vec.Cross(positions[triangles[(3 * t) + 1]] - a, positions[triangles[(3 * t) + 2]] - a)) / 2f;
        }

        return areas;
    }
}
