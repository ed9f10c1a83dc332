using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>What folded wings look like, from all sides.</summary>
public sealed class FoldedShapeTests
{
    [Fact]
    public void Leading_edges_of_folded_wings_have_hardly_a_corner_at_the_elbow_as_seen_from_the_side()
    {
        var corners = new List<double>();
        foreach (StandingFlier flier in StandingFlier.Of(5000, 60).Where(flier => flier.IsStitched))
        {
            flier.Stand(FlatGround.Level);
            Vector3[] joints = flier.Creature.Limbs.First(limb => limb.Kind == LimbKind.Wing).Joints.Select(joint => flier.Animator.ModelPose.Positions[joint] with { X = 0f }).ToArray();
            double corner = Math.Acos(Math.Clamp(Vector3.Dot(Vector3.Normalize(joints[1] - joints[0]), Vector3.Normalize(joints[2] - joints[1])), -1f, 1f));
            corners.Add(corner);
        }

        // Narrow wings carry their wrists less far ahead, and fold with more of a corner than broad ones; off the midline, where left and right would cut through one another, with a little more.
        Assert.True(corners.Average() < 0.176, $"{corners.Average()} rad in the mean");
    }

    [Fact]
    public void Folded_membranes_do_not_stand_above_the_back_like_tents()
    {
        var heights = new List<double>();
        foreach (StandingFlier flier in StandingFlier.Of(20200000, 60, CreatureOptions.Default).Where(flier => flier.Creature.Blueprint.Wings.Any(wing => WingFingers.Of(wing.Style) != null)))
        {
            flier.Stand(FlatGround.Level);
            heights.Add(flier.AboveBack());
        }

        // Folded as feathers are they stood .11 above it in the mean, and the highest .53.
        Assert.True(heights.Count > 20);
        Assert.True(heights.Max() < 0.15, FormattableString.Invariant($"{heights.Max()} body lengths above the back"));
        Assert.True(heights.Average() < 0.075, FormattableString.Invariant($"{heights.Average()} body lengths above the back in the mean"));
    }

    [Theory]
    [InlineData(5015)]
    [InlineData(5016)]
    [InlineData(8101)]
    [InlineData(9216)]
    [InlineData(9217)]
    public void Legs_of_standing_moths_do_not_poke_through_their_folded_wings(int seed)
    {
        StandingFlier flier = StandingFlier.Of(seed, 1).Single();
        flier.Stand(FlatGround.Level);
        Assert.Equal(0, Crossings(flier));
    }

    /// <summary>Triangles of wings that the middle lines of the bones of legs go through.</summary>
    private static int Crossings(StandingFlier flier)
    {
        Skeleton skeleton = flier.Creature.Skeleton;
        CapsuleCollider[] legs = flier.Creature.Bones.Where(bone => skeleton.Joints[bone.Joint].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle).ToArray();
        int crossings = 0;
        ReadOnlySpan<int> triangles = flier.Creature.Mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            int[] corners = triangles.Slice(t, 3).ToArray();
            if (corners.All(v => skeleton.Joints[flier.Creature.Mesh.Weights[v].Joint0].Role == JointRole.Wing))
            {
                Vector3[] p = corners.Select(v => flier.Skin[v]).ToArray();
                crossings += legs.Count(bone => Goes(Place(flier, bone, bone.Start), Place(flier, bone, bone.End), p));
            }
        }

        return crossings;
    }

    private static Vector3 Place(StandingFlier flier, CapsuleCollider bone, Vector3 local) =>
        flier.Animator.ModelPose.Positions[bone.Joint] + Rotation.Rotate(flier.Animator.ModelPose.Rotations[bone.Joint], local);

    /// <summary>Whether a line goes through a triangle, after Möller and Trumbore.</summary>
    private static bool Goes(Vector3 start, Vector3 end, Vector3[] p)
    {
        Vector3 way = end - start;
        Vector3 across = Vector3.Cross(way, p[2] - p[0]);
        float determinant = Vector3.Dot(p[1] - p[0], across);
        if (determinant == 0f)
        {
            return false;
        }

        Vector3 from = start - p[0];
        Vector3 other = Vector3.Cross(from, p[1] - p[0]);
        float u = Vector3.Dot(from, across) / determinant;
        float v = Vector3.Dot(way, other) / determinant;
        float along = Vector3.Dot(p[2] - p[0], other) / determinant;
        return u >= 0f && v >= 0f && u + v <= 1f && along is >= 0f and <= 1f;
    }
}
