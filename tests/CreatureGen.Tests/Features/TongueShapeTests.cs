using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class TongueShapeTests
{
    private static readonly Vector3 pink = new(0.6f, 0.2f, 0.2f);

    [Fact]
    public void A_rounded_tongue_is_one_closed_symmetric_shell_within_the_lips()
    {
        var builder = new PieceBuilder();
        TongueShape.AppendRounded(builder, Floor(), 0.76f, pink);
        Piece tongue = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(tongue);
        PieceChecks.IsSymmetric(tongue);
        PieceChecks.NormalsFollowFaces(tongue, 0.97);
        Assert.InRange(PieceChecks.TriangleCount(tongue), 60, 130);
        Assert.All(tongue.Positions, p => Assert.InRange(System.Math.Abs(p.X), 0f, 0.8f * 0.06f));
        Assert.InRange(tongue.Positions.Max(p => p.Z), 0.2f, 0.3f);
    }

    [Fact]
    public void A_forked_tongue_has_two_points_that_lie_apart()
    {
        var builder = new PieceBuilder();
        TongueShape.AppendForked(builder, Floor(), 0.2f, pink);
        Piece tongue = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(tongue);
        PieceChecks.IsSymmetric(tongue);
        float front = tongue.Positions.Max(p => p.Z);
        Vector3[] points = tongue.Positions.Where(p => p.Z > front - 1e-6f).ToArray();
        Assert.Equal(2, points.Length);
        Assert.Equal(points[0].X, -points[1].X);
        Assert.True(System.Math.Abs(points[0].X) > 0.005f);
    }

    [Theory]
    [InlineData(LocomotionKind.Walking, 3)]
    [InlineData(LocomotionKind.Flying, 3)]
    [InlineData(LocomotionKind.Swimming, 3)]
    [InlineData(LocomotionKind.Walking, 150, Explicit = true)]
    [InlineData(LocomotionKind.Flying, 150, Explicit = true)]
    [InlineData(LocomotionKind.Swimming, 150, Explicit = true)]
    public void No_tongue_shows_outside_a_shut_mouth(LocomotionKind kind, int seeds)
    {
        int tongues = 0;
        for (ulong seed = 0; seed < (ulong)seeds; seed++)
        {
            CreatureBlueprint drawn = BlueprintSampler.Sample(seed, kind);
            CreatureBlueprint blueprint = drawn with { Head = drawn.Head with { Mouth = drawn.Head.Mouth with { Opening = 0, Teeth = 0 } } };
            Assert.Equal(blueprint.Head.Mouth.CornerRing > 0, blueprint.Head.Mouth.Tongue != TongueStyle.None);
            if (blueprint.Head.Mouth.Tongue == TongueStyle.None)
            {
                continue;
            }

            tongues++;
            GrownSurface grown = GrownSurface.Grow(blueprint);
            Vector3[] points = TonguePoints(blueprint, grown);
            for (int v = 0; v < points.Length; v++)
            {
                Assert.True(IsCovered(grown, points[v]), $"{kind} {seed}, {blueprint.Body.Blend.First}: the tongue shows at its vertex {v} of {points.Length}, {points[v]}");
            }
        }

        Assert.True(tongues > 0.4 * seeds, $"{tongues} tongues");
    }

    /// <summary>The head without the lining of its mouth, as a solid: whatever is in it cannot be seen while the lips touch.</summary>
    private static bool IsCovered(GrownSurface grown, Vector3 point)
    {
        int covered = 0;
        foreach (Vector3 direction in new[] { new Vector3(0.01f, 1f, 0.02f), new Vector3(0.02f, -1f, -0.01f), new Vector3(1f, 0.21f, 0.03f) })
        {
            int hits = 0;
            int[] triangles = grown.Surface.Triangles.ToArray();
            for (int t = 0; t < triangles.Length; t += 3)
            {
                bool lining = grown.Surface.Addresses[triangles[t]].Region == SurfaceRegion.Mouth
                    || grown.Surface.Addresses[triangles[t + 1]].Region == SurfaceRegion.Mouth
                    || grown.Surface.Addresses[triangles[t + 2]].Region == SurfaceRegion.Mouth;
                Vector3[] p = grown.Surface.Positions;
                hits += !lining && RayCast.Hit(point, Vector3.Normalize(direction), p[triangles[t]], p[triangles[t + 1]], p[triangles[t + 2]], out _, out _, out _) ? 1 : 0;
            }

            covered += hits % 2;
        }

        return covered >= 2;
    }

    private static Vector3[] TonguePoints(CreatureBlueprint blueprint, GrownSurface grown)
    {
        var builder = new PieceBuilder();
        MouthSetter.AppendTongue(builder, blueprint, grown, pink);
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere).Positions;
    }

    private static MouthFloor Floor()
    {
        Vector3[] lip = Enumerable.Range(0, 9).Select(k => new Vector3(0.06f - (0.004f * k), 1f - (0.002f * k), 0.03f * k)).ToArray();
        return new MouthFloor(lip, Vector3.UnitY, 0.95f, 0.05f);
    }
}
