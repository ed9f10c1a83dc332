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
}
