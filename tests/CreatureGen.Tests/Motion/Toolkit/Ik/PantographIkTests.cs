using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class PantographIkTests
{
    private static readonly PantographLeg leg = new(new Vector3(0.02f, -0.8f, 0.5f), new Vector3(0f, -0.7f, -0.7f), new Vector3(-0.01f, -0.6f, 0.1f), Vector3.UnitX);

    [Fact]
    public void The_rest_target_gives_the_rest_leg()
    {
        Vector3 target = leg.Thigh + leg.Shank + leg.Metatarsus;
        Assert.True(PantographIk.Solve(leg, target, Vector3.UnitX, 0f, Reach.Default, out Quaternion thigh, out Quaternion shank, out Quaternion metatarsus).Reached);
        Assert.True(Rotation.Angle(thigh) < 1e-5 && Rotation.Angle(shank) < 1e-5 && Rotation.Angle(metatarsus) < 1e-5);
    }

    [Fact]
    public void Any_target_within_reach_is_met_and_thigh_and_metatarsus_turn_together_but_for_the_fold()
    {
        RandomStream random = new Seed(1).Stream();
        for (int i = 0; i < 3000; i++)
        {
            float fold = (float)random.Uniform(-0.3, 1.2);
            Vector3 target = new((float)random.Uniform(-0.3, 0.3), (float)random.Uniform(-1.6, -1.0), (float)random.Uniform(-0.6, 0.6));
            IkResult result = PantographIk.Solve(leg, target, Vector3.UnitX, fold, Reach.Default, out Quaternion thigh, out Quaternion shank, out Quaternion metatarsus);
            Vector3 ball = Rotation.Rotate(thigh, leg.Thigh) + Rotation.Rotate(shank, leg.Shank) + Rotation.Rotate(metatarsus, leg.Metatarsus);
            Assert.Equal(result.Residual, Vec.Distance(ball, target), 1e-5f);
            Assert.True(result.Reached || fold > 0.5f);
            Assert.True(MovingPose.Between(Rotation.Multiply(thigh, Rotation.FromAxisAngle(Vector3.UnitX, fold)), metatarsus) < 1e-6);
            Vector3 hinge = Rotation.Rotate(thigh, Vector3.UnitX);
            Vector3 wanted = Vec.Normalize(Vec.Reject(Vector3.UnitX, Vec.Normalize(target)));
            Assert.True(Vec.Dot(hinge, wanted) > 0.97f);
        }
    }

    [Fact]
    public void Hind_and_fore_legs_of_creatures_reach_their_resting_places_lifted_and_swung()
    {
        int legs = 0;
        foreach (BodyPlan plan in new[] { BodyPlan.Centaur, BodyPlan.Flapping, BodyPlan.Digitigrade })
        {
            RigSubject subject = RigSubject.Of(plan);
            foreach (LimbChain limb in subject.Rig.Limbs)
            {
                if (limb.Kind != LimbKind.Leg)
                {
                    continue;
                }

                (int hip, int knee, int ankle, int ball) = (limb.Joints[1], limb.Joints[2], limb.Joints[3], limb.Joints[4]);
                PantographLeg real = PantographLeg.Of(subject.Skeleton, hip, knee, ankle, ball);
                MovingPose pose = new(subject.Skeleton);
                Vector3 rest = pose.ModelPositions[ball];
                float length = Vec.Distance(rest, pose.ModelPositions[hip]);
                foreach (Vector3 shift in new[] { Vector3.Zero, new Vector3(0f, 0.1f, 0f), new Vector3(0f, 0.1f, 0.2f), new Vector3(0.05f, 0.1f, -0.2f) })
                {
                    Vector3 target = rest + (shift * length);
                    IkResult result = PantographIk.Apply(subject.Skeleton, hip, knee, ankle, real, target, real.Hinge, 0f, Reach.Default, pose.Local, pose.Model);
                    Assert.Equal(result.Residual, Vec.Distance(pose.ModelPositions[ball], target), 2e-5f * length);
                    Assert.True(result.Reached || result.Residual < 0.03f * length, $"{plan} {subject.Skeleton.Joints[hip].Name} {shift}: {result}");
                    legs++;
                }
            }
        }

        Assert.True(legs > 20);
    }
}
