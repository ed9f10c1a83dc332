using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Tests.Creatures.Forks;
using Xunit;

namespace CreatureGen.Tests.Motion;

public sealed class SecondHeadTests
{
    private const float Frame = 1f / 60f;

    private static IEnumerable<MotionProfile> Bodies(int count) => ForkedCreatures.Of(LocomotionKind.Walking, Thoroughness.Of(count)).Select(pair => new MotionProfile(CreatureAssembler.Assemble(pair.Two)));

    [Fact]
    public void Both_heads_look_at_what_the_game_says()
    {
        foreach (MotionProfile body in Bodies(12))
        {
            Skeleton skeleton = body.Subject.Skeleton;
            var animator = new CreatureAnimator(body);
            Run(animator, 0.2f);
            foreach (float side in new[] { 1f, -1f })
            {
                Vector3 point = Middle(body) + (new Vector3(0.5f * side, 0.1f, 1f) * (20f * body.LegLength));
                animator.LookAt = animator.Root.ToWorld(point);
                Run(animator, 2f);
                foreach (int head in HeadsOf(skeleton))
                {
                    Vector3 ahead = Rotation.Rotate(Rotation.Multiply(animator.ModelPose.Rotations[head], Rotation.Inverse(skeleton.ModelRotations[head])), Vector3.UnitZ);
                    Vector3 wanted = Vec.Normalize(point - animator.ModelPose.Positions[head]);
                    float yaw = MathF.Abs((float)(PortableMath.Atan2(ahead.X, ahead.Z) - PortableMath.Atan2(wanted.X, wanted.Z)));
                    Assert.True(yaw < 0.45f, $"{body.Subject.Seed} {skeleton.Joints[head].Name} looks {yaw} rad past it");
                }
            }
        }
    }

    [Fact]
    public void Both_heads_bite_the_second_a_little_later()
    {
        int tried = 0;
        foreach (MotionProfile body in Bodies(12))
        {
            Skeleton skeleton = body.Subject.Skeleton;
            int second = skeleton.IndexOf("Jaw" + Heads.Suffix);
            var animator = new CreatureAnimator(body);
            Run(animator, 0.2f);
            if (second < 0 || animator.Perform("Bite").Status != ActStatus.Started)
            {
                continue;
            }

            int jaw = skeleton.FirstOf(JointRole.Jaw);
            tried++;
            float[] widest = new float[2];
            for (int i = 0; i < 120; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                widest[0] = Math.Max(widest[0], Opening(animator, jaw));
                widest[1] = Math.Max(widest[1], Opening(animator, second));
            }

            Assert.True(widest[1] > 0.6f * widest[0], $"{body.Subject.Seed}: {widest[0]} and {widest[1]}");
        }

        Assert.True(tried >= 2);
    }

    [Fact]
    public void Heads_that_look_far_aside_do_not_get_into_each_other()
    {
        foreach (MotionProfile body in Bodies(18))
        {
            Skeleton skeleton = body.Subject.Skeleton;
            int[] heads = HeadsOf(skeleton);
            CapsuleCollider[] capsules = heads.Select(head => body.Subject.Bones.First(bone => bone.Joint == head)).ToArray();
            var animator = new CreatureAnimator(body);
            float built = Apart(capsules, new Pose(skeleton.ModelRotations.ToArray(), skeleton.ModelPositions.ToArray()));
            float apart = Math.Min(capsules[0].Radius + capsules[1].Radius, built);
            foreach (float side in new[] { 8f, -8f })
            {
                Run(animator, 0.2f);
                animator.LookAt = animator.Root.ToWorld(Middle(body) + (new Vector3(side, 0f, 2f) * body.LegLength));
                for (int i = 0; i < 90; i++)
                {
                    animator.Update(Frame, default, FlatGround.Level);
                    Assert.True(Apart(capsules, animator.ModelPose) > 0.8f * apart, $"{body.Subject.Seed}: {Apart(capsules, animator.ModelPose)} of {apart} apart");
                }
            }
        }
    }

    [Fact]
    public void The_second_head_is_carried_as_the_first_is_and_blinks_by_itself()
    {
        foreach (MotionProfile body in Bodies(6))
        {
            Skeleton skeleton = body.Subject.Skeleton;
            int[] heads = HeadsOf(skeleton);
            var animator = new CreatureAnimator(body) { Settings = MotionSettings.Default with { Idle = 0f } };
            float[] lowest = { float.MaxValue, float.MaxValue };
            float[] highest = { float.MinValue, float.MinValue };
            for (int i = 0; i < 240; i++)
            {
                animator.Update(Frame, new MotionInput(body.Gaits == null ? 0.5f : 0.25f * body.Gaits.TopSpeed), FlatGround.Level);
                for (int h = 0; h < 2 && i > 120; h++)
                {
                    lowest[h] = Math.Min(lowest[h], animator.ModelPose.Positions[heads[h]].Y);
                    highest[h] = Math.Max(highest[h], animator.ModelPose.Positions[heads[h]].Y);
                }
            }

            Assert.InRange(highest[1] - lowest[1], 0.4f * (highest[0] - lowest[0]), (2.5f * (highest[0] - lowest[0])) + (0.02f * body.LegLength));
        }
    }

    [Fact]
    public void A_limp_body_lets_both_heads_hang_and_gets_up_with_both()
    {
        foreach (MotionProfile body in Bodies(6))
        {
            var animator = new CreatureAnimator(body);
            Run(animator, 0.3f);
            animator.GoLimp();
            Run(animator, 3f);
            int[] heads = HeadsOf(body.Subject.Skeleton);
            Assert.All(heads, head => Assert.InRange(animator.ModelPose.Positions[head].Y, -0.3f * body.LegLength, 3f * body.LegLength));
            animator.GetUp();
            Quaternion[] before = animator.LocalPose.Rotations.ToArray();
            for (int i = 0; i < 480; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                foreach (int head in heads)
                {
                    double speed = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[head]), animator.LocalPose.Rotations[head])) / Frame;
                    Assert.True(speed < 25, $"{body.Subject.Seed} {body.Subject.Skeleton.Joints[head].Name}: {speed} rad/s after {i} updates");
                }

                animator.LocalPose.Rotations.CopyTo(before);
            }
        }
    }

    [Fact]
    public void Two_heads_allocate_nothing()
    {
        MotionProfile body = Bodies(1).First();
        var animator = new CreatureAnimator(body) { LookAt = new Vector3(3f, 1f, 2f) };
        Run(animator, 1f);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(animator, 1f);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static void Run(CreatureAnimator animator, float seconds)
    {
        for (int i = 0; i < (int)(seconds / Frame); i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }
    }

    private static int[] HeadsOf(Skeleton skeleton) => Enumerable.Range(0, skeleton.Count).Where(j => skeleton.Joints[j].Role == JointRole.Head).ToArray();

    private static Vector3 Middle(MotionProfile body) => body.Subject.Skeleton.ModelPositions[HeadsOf(body.Subject.Skeleton)[0]] with { X = 0f };

    private static float Opening(CreatureAnimator animator, int jaw) =>
        (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(animator.Profile.Subject.Skeleton.LocalRotations[jaw]), animator.LocalPose.Rotations[jaw]));

    private static float Apart(CapsuleCollider[] heads, in Pose model)
    {
        var ends = new Vector3[4];
        for (int h = 0; h < 2; h++)
        {
            ends[2 * h] = model.Positions[heads[h].Joint] + Rotation.Rotate(model.Rotations[heads[h].Joint], heads[h].Start);
            ends[(2 * h) + 1] = model.Positions[heads[h].Joint] + Rotation.Rotate(model.Rotations[heads[h].Joint], heads[h].End);
        }

        return MathF.Sqrt(SegmentDistance.Squared(ends[0], ends[1], ends[2], ends[3]));
    }
}
