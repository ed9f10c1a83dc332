using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Metrics;

/// <summary>How often a creature's surface cuts through itself wherever users see it.</summary>
/// <param name="Rest">At rest.</param>
/// <param name="Levels">On the coarser levels of detail together.</param>
/// <param name="Worst">In the worst pose of all clips.</param>
/// <param name="WorstClip">The clip of that pose; empty without crossings in clips.</param>
/// <param name="Poses">Poses that were looked at.</param>
/// <param name="CrossingPoses">How many of them had crossings.</param>
public sealed record CrossingReport(SurfaceCrossings Rest, SurfaceCrossings Levels, SurfaceCrossings Worst, string WorstClip, int Poses, int CrossingPoses);

/// <summary>Looks for crossings at rest, on all levels of detail, and in poses of everything that can be baked. Takes some seconds.</summary>
public static class CrossingTrial
{
    /// <summary>Poses of a clip at most.</summary>
    public const int MaxPoses = 256;

    /// <summary>Looks at a creature.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="poses">Poses of each clip, evenly spread over its time, 0..<see cref="MaxPoses"/>.</param>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The number of poses is out of its range.</exception>
    public static CrossingReport Run(Creature creature, int poses)
    {
        _ = creature ?? throw new ArgumentNullException(nameof(creature));
        if (poses < 0 || poses > MaxPoses)
        {
            throw new ArgumentOutOfRangeException(nameof(poses), poses, FormattableString.Invariant($"expected 0..{MaxPoses}"));
        }

        CreatureMesh mesh = creature.Mesh;
        var counter = new CrossingCounter(mesh, mesh.Triangles);
        SurfaceCrossings rest = counter.Count();
        var report = new CrossingReport(rest, OnLevels(mesh), default, string.Empty, 0, 0);
        if (poses == 0)
        {
            return report;
        }

        Skeleton skeleton = creature.Skeleton;
        var local = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        var model = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        var matrices = new Matrix4x4[skeleton.Count];
        var positions = new Vector3[mesh.Positions.Length];
        var normals = new Vector3[positions.Length];
        foreach (ClipRecipe recipe in ClipBaker.RecipesOf(new MotionProfile(creature)))
        {
            Clip clip = recipe.Bake();
            for (int k = 0; k < poses; k++)
            {
                clip.Sample(clip.Duration * k / poses, local);
                ForwardKinematics.LocalToModel(skeleton, local, model);
                SkinMatrices.Fill(skeleton, model, matrices);
                CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, normals);
                SurfaceCrossings found = counter.Count(positions);
                bool worse = found.All > report.Worst.All;
                report = report with
                {
                    Worst = worse ? found : report.Worst,
                    WorstClip = worse ? clip.Name : report.WorstClip,
                    Poses = report.Poses + 1,
                    CrossingPoses = report.CrossingPoses + (found.All > 0 ? 1 : 0),
                };
            }
        }

        return report;
    }

    private static SurfaceCrossings OnLevels(CreatureMesh mesh)
    {
        int body = 0;
        int pieces = 0;
        for (int level = 1; level < mesh.Lods.Count; level++)
        {
            SurfaceCrossings found = new CrossingCounter(mesh, mesh.Lods[level].Triangles).Count();
            body += found.Body;
            pieces += found.Pieces;
        }

        return new SurfaceCrossings(body, pieces);
    }
}
