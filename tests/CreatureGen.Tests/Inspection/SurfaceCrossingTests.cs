using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Inspection;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Inspection;

/// <summary>Crossings are seen on the body, within its pieces, on its levels of detail and as it moves.</summary>
public sealed class SurfaceCrossingTests
{
    private static readonly Creature Sound = CreatureGenerator.Generate(42, CreatureOptions.Default with { TriangleBudget = 6000 });

    [Fact]
    public void A_piece_that_crosses_itself_counts_and_one_that_is_set_into_the_body_does_not()
    {
        SurfaceCrossings before = CreatureInspection.CountCrossings(Sound);
        Assert.Equal(before, CreatureInspection.CountCrossings(With(0f)));
        SurfaceCrossings twisted = CreatureInspection.CountCrossings(With(1f));
        Assert.Equal(before.Body, twisted.Body);
        Assert.Equal(before.Pieces + 1, twisted.Pieces);
    }

    [Fact]
    public void The_body_counts_as_it_always_did() => Assert.Equal(CreatureInspection.CountSelfIntersections(Sound), CreatureInspection.CountCrossings(Sound).Body);

    /// <summary>As the body folds its limbs onto itself it crosses; the same vertices brought back to rest do not.</summary>
    [Fact(Explicit = true)]
    public void Poses_of_all_clips_are_looked_at_evenly()
    {
        int clips = ClipBaker.RecipesOf(new MotionProfile(Sound)).Count;
        CrossingReport report = CrossingTrial.Run(Sound, 4);
        Assert.Equal(4 * clips, report.Poses);
        Assert.Equal(CreatureInspection.CountCrossings(Sound), report.Rest);
        Assert.InRange(report.CrossingPoses, 0, report.Poses);
        Assert.Equal(report.CrossingPoses > 0, report.Worst.All > 0);
        Assert.Equal(report.CrossingPoses > 0, report.WorstClip.Length > 0);
        Assert.Equal(0, CrossingTrial.Run(Sound, 0).Poses);
        Assert.Throws<ArgumentOutOfRangeException>("poses", () => CrossingTrial.Run(Sound, 257));
    }

    /// <summary>
    /// Flesh folds at knees and hips, folded wings lie on the back and on one another: pairs of triangles that cross in poses are counted, and must not become many more than they were
    /// (docs/testing.md, on more creatures).
    /// </summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 1, 0.04, Explicit = true)]
    [InlineData(RequestedKind.Flying, 1, 0.06, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 1, 0.01)]
    [InlineData(RequestedKind.Walking, 12, 0.09, Explicit = true)]
    [InlineData(RequestedKind.Flying, 12, 0.11, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 12, 0.01, Explicit = true)]
    public void In_no_pose_more_than_a_small_part_of_the_triangles_cross(RequestedKind kind, int creatures, double most)
    {
        for (ulong seed = 7200000; seed < 7200000 + (ulong)creatures; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, SizeOfSeed.In(CreatureOptions.Default with { Kind = kind }, seed));
            CrossingReport report = CrossingTrial.Run(creature, 4);
            Assert.True(report.Worst.All <= most * creature.Mesh.Triangles.Length / 3, $"{seed}: {report}");
        }
    }

    /// <summary>A thin strip of five triangles on the creature's back, whose end is bent through its beginning or not.</summary>
    private static Creature With(float twist)
    {
        CreatureMesh mesh = Sound.Mesh;
        Vector3 at = new(0f, mesh.Positions.ToArray().Max(p => p.Y) + 1f, 0f);
        Vector3[] strip = [new(0, 0, 0), new(1, 0, 0), new(0.5f, 0, 1), new(1.5f, 0, 1), new(0.6f, 0.5f, 0.6f), new(1.2f, 1, 0.2f), twist > 0f ? new(0.5f, -0.5f, 0.4f) : new(2f, 1f, 0.4f)];
        int[] corners = [0, 1, 2, 1, 3, 2, 3, 5, 4, 4, 5, 6, 2, 3, 4];
        int first = mesh.Positions.Length;
        Vector3[] positions = [.. mesh.Positions, .. strip.Select(p => at + (0.3f * p))];
        int[] triangles = [.. mesh.Triangles, .. corners.Select(c => first + c)];
        MeshPart last = mesh.Parts[^1];
        MeshPart[] parts = [.. mesh.Parts.SkipLast(1), last with { IndexCount = last.IndexCount + corners.Length }];
        return Sound with
        {
            Mesh = new CreatureMesh(
                positions,
                [.. mesh.Normals, .. strip.Select(_ => Vector3.UnitY)],
                [.. mesh.Texcoords, .. strip.Select(_ => Vector2.Zero)],
                [.. mesh.Colours, .. strip.Select(_ => Vector3.One)],
                [.. mesh.Weights, .. strip.Select(_ => new SkinWeights(0, 0, 0, 0, new Vector4(1, 0, 0, 0)))],
                triangles,
                parts),
        };
    }
}
