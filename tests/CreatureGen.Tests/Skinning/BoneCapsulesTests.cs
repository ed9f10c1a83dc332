using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class BoneCapsulesTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Each_capsule_lies_along_its_bone_near_the_skin_that_the_bone_holds(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Vector3[] skin = subject.Input.Surface.Positions;
        CapsuleCollider[] capsules = BoneCapsules.Fit(subject.Skeleton, subject.Weights, skin);
        Assert.Equal(capsules.Length, capsules.Select(c => c.Joint).Distinct().Count());
        foreach (CapsuleCollider capsule in capsules)
        {
            Joint joint = subject.Skeleton.Joints[capsule.Joint];
            Assert.NotEqual(JointRole.End, joint.Role);
            Assert.True(capsule.Radius > 1e-3f && capsule.Radius < 1.5f, $"{joint.Name}: {capsule.Radius}");
            Assert.True(capsule.End.Y >= capsule.Start.Y);
            Assert.Equal(capsule.Start.X, capsule.End.X, 1e-4f);
            Assert.Equal(capsule.Start.Z, capsule.End.Z, 1e-4f);
            int[] held = Enumerable.Range(0, skin.Length).Where(v => subject.Weights[v].Joint0 == capsule.Joint).ToArray();
            int inside = held.Count(v => Distance(capsule, Local(joint, skin[v])) <= capsule.Radius * 1.5f);
            Assert.True(inside >= 0.55 * held.Length, $"{joint.Name}: {inside} of {held.Length} vertices lie within one and a half radii");
        }

        foreach (LimbChain limb in subject.Rig.Limbs.Where(l => l.Kind == LimbKind.Leg))
        {
            Assert.Contains(capsules, c => c.Joint == limb.Joints[1]);
            Assert.Contains(capsules, c => c.Joint == limb.Joints[2]);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Flapping)]
    public void The_right_capsules_are_exact_mirror_images(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        CapsuleCollider[] capsules = BoneCapsules.Fit(subject.Skeleton, subject.Weights, subject.Input.Surface.Positions);
        foreach (CapsuleCollider capsule in capsules)
        {
            CapsuleCollider mirror = capsules.Single(c => c.Joint == subject.Skeleton.Mirrors[capsule.Joint]);
            Joint joint = subject.Skeleton.Joints[capsule.Joint];
            Assert.Equal(capsule.Radius, mirror.Radius);
            if (joint.Side == Side.Median)
            {
                Assert.Equal(0f, capsule.Start.X);
            }
            else
            {
                Assert.Equal(Vec.Mirror(capsule.Start), mirror.Start);
                Assert.Equal(Vec.Mirror(capsule.End), mirror.End);
            }
        }
    }

    private static Vector3 Local(Joint joint, Vector3 p) => Rotation.Rotate(Rotation.Inverse(joint.ModelRotation), p - joint.ModelPosition);

    private static float Distance(CapsuleCollider c, Vector3 p)
    {
        Vector3 d = c.End - c.Start;
        float squared = Vec.LengthSquared(d);
        float t = squared > 0f ? Scalar.Clamp(Vec.Dot(p - c.Start, d) / squared, 0f, 1f) : 0f;
        return Vec.Distance(p, c.Start + (d * t));
    }
}
