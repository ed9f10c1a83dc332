using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class NearestBoneWeightsTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Weights_are_well_formed_mirrored_and_cross_no_gap(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        SkinWeights[] weights = NearestBoneWeights.Solve(subject.Input, subject.Rig);
        SkinFacts.AreWellFormed(weights, subject.Skeleton);
        SkinFacts.AreMirrored(weights, subject);
        SkinFacts.DoNotLeak(weights, subject);
    }

    [Fact]
    public void The_nearest_bone_has_the_largest_weight_and_weights_fall_with_the_square_of_the_distance()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Legless);
        SkinWeights[] weights = NearestBoneWeights.Solve(subject.Input, subject.Rig);
        for (int v = 0; v < weights.Length; v++)
        {
            if (subject.Rig.Jaw == weights[v].Joint0)
            {
                continue;
            }

            (int Joint, float Weight)[] influences = weights[v].Influences().ToArray();
            // Up to three influences too small to be seen (0.002 each) fall to the largest.
            float[] products = influences.Select(i => i.Weight * Squared(subject.Skeleton, i.Joint, subject.Input.Surface.Positions[v])).ToArray();
            Assert.All(products, p => Assert.Equal(products[0], p, products[0] * 8e-3f));
        }
    }

    [Fact]
    public void Over_all_plans_anatomy_keeps_the_volume_of_bent_spines_better_than_distance()
    {
        double anatomy = 0;
        double distance = 0;
        foreach (BodyPlan plan in Enum.GetValues<BodyPlan>())
        {
            RigSubject subject = RigSubject.Of(plan);
            Quaternion? Bend(Joint j) => j.Role is JointRole.Spine or JointRole.Neck or JointRole.Tail ? Rotation.FromAxisAngle(Vector3.UnitZ, j.Limit.SwingZ.Max) : null;
            anatomy += Math.Abs(SkinFacts.Bend(subject, subject.Weights, Bend).Volume);
            distance += Math.Abs(SkinFacts.Bend(subject, NearestBoneWeights.Solve(subject.Input, subject.Rig), Bend).Volume);
        }

        Assert.True(anatomy < 0.7 * distance, $"{anatomy} against {distance}");
    }

    private static float Squared(Skeleton skeleton, int joint, Vector3 p)
    {
        Vector3 a = skeleton.ModelPositions[joint];
        Vector3 d = Rotation.Rotate(skeleton.ModelRotations[joint], Vector3.UnitY) * skeleton.Joints[joint].Length;
        float t = Scalar.Clamp(Vec.Dot(p - a, d) / Vec.LengthSquared(d), 0f, 1f);
        return Vec.LengthSquared(p - (a + (d * t)));
    }

    [Fact]
    public void Vertices_of_any_mesh_follow_the_four_nearest_bones_of_any_skeleton()
    {
        var placements = new System.Collections.Generic.List<JointPlacement>();
        for (int i = 0; i < 8; i++)
        {
            placements.Add(new JointPlacement(FormattableString.Invariant($"bone {i}"), i - 1, Quaternion.Identity, new Vector3(i == 0 ? 0f : 1f, 0f, 0f)));
        }

        Skeleton skeleton = Skeleton.Build(placements);
        var random = new Random(4);
        Vector3[] points = [.. System.Linq.Enumerable.Range(0, 200).Select(_ => new Vector3(random.NextSingle() * 8f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f))];
        SkinWeights[] weights = NearestBoneWeights.Solve(points, skeleton);
        for (int v = 0; v < points.Length; v++)
        {
            // Naive: the distance to each bone from x = i to i + 1; the last joint is a point.
            double To(int bone)
            {
                double aside = Math.Sqrt((points[v].Y * points[v].Y) + (points[v].Z * points[v].Z));
                double x = points[v].X - Math.Clamp(points[v].X, bone, bone == 7 ? 7 : bone + 1);
                return Math.Max(Math.Sqrt((aside * aside) + (x * x)), 7e-4);
            }

            int[] nearest = [.. System.Linq.Enumerable.Range(0, 8).OrderBy(To).Take(4)];
            double sum = nearest.Sum(b => 1 / (To(b) * To(b)));
            Assert.Equal(nearest[0], weights[v].Joint0);
            Assert.Equal(1 / (To(nearest[0]) * To(nearest[0])) / sum, weights[v].Weights.X, 2);
            Assert.Equal(1f, weights[v].Weights.X + weights[v].Weights.Y + weights[v].Weights.Z + weights[v].Weights.W);
        }

        Assert.Throws<ArgumentException>(() => NearestBoneWeights.Solve([new Vector3(float.NaN)], skeleton));
    }
}
