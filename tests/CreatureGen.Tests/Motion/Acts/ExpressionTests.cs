using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

/// <summary>What acts look like from afar, on bodies whose face does not tell.</summary>
public class ExpressionTests
{
    private const float Rate = 60f;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Many_legged_bodies_flinch_with_their_abdomen_up(ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Hexapod, seed, "Flinch");
        ActBody body = profile.Acts.Body;
        int chest = body.Spine[^1];
        int tip = body.Tail.Joints[^1];
        float up = float.MinValue;
        foreach (Still pose in poses)
        {
            up = Math.Max(up, pose.Positions[tip].Y - pose.Positions[chest].Y - (poses[0].Positions[tip].Y - poses[0].Positions[chest].Y));
        }

        Assert.InRange(up / body.Tail.Length, 0.3f, 2f);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Upright_bodies_bow_their_head_far_down_as_they_submit(ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Upright, seed, "Submit");
        Assert.InRange(Lowest(poses, profile.Acts.Body.Head) / poses[0].Positions[profile.Acts.Body.Head].Y, 0.1f, 0.6f);
    }

    /// <summary>They crouched with the head level and ahead.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade, 1)]
    [InlineData(BodyPlan.Unguligrade, 2)]
    [InlineData(BodyPlan.Theropod, 3)]
    public void Who_submits_bows_its_head_and_turns_it_away(BodyPlan plan, ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(plan, seed, "Submit");
        int head = profile.Acts.Body.Head;
        Still bowed = poses[poses.Count / 2];
        Vector3 snout = Vector3.Transform(Vector3.UnitZ, bowed.Rotations[head] * Quaternion.Inverse(poses[0].Rotations[head]));
        Assert.InRange(snout.Y, -1f, -0.45f);
        Assert.InRange(Math.Abs(snout.X), 0.3f, 1f);
    }

    /// <summary>Its nose stayed before its breast.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade, 1)]
    [InlineData(BodyPlan.Unguligrade, 2)]
    [InlineData(BodyPlan.Theropod, 3)]
    public void Who_sniffs_has_its_nose_at_the_ground(BodyPlan plan, ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(plan, seed, "Sniff");
        int head = profile.Acts.Body.Head;
        Assert.InRange(Lowest(poses, head) / poses[0].Positions[head].Y, 0f, 0.6f);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void A_head_that_shakes_swings_from_side_to_side_and_not_only_about_its_own_axis(ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Digitigrade, seed, "Shake");
        int head = profile.Acts.Body.Head;
        float left = float.MinValue;
        float right = float.MaxValue;
        foreach (Still pose in poses)
        {
            Vector3 ahead = Vector3.Transform(Vector3.UnitZ, pose.Rotations[head] * Quaternion.Inverse(poses[0].Rotations[head]));
            left = Math.Max(left, ahead.X);
            right = Math.Min(right, ahead.X);
        }

        Assert.InRange(left - right, 0.5f, 1.4f);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Who_drinks_raises_its_head_in_between_and_drinks_again(ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Unguligrade, seed, "Drink");
        int head = profile.Acts.Body.Head;
        float lowest = Lowest(poses, head);
        float raised = lowest + (0.15f * (poses[0].Positions[head].Y - lowest));
        int dips = 0;
        bool isDown = false;
        foreach (Still pose in poses)
        {
            bool down = pose.Positions[head].Y < raised;
            dips += down && !isDown ? 1 : 0;
            isDown = down;
        }

        Assert.Equal(2, dips);
    }

    private static float Lowest(List<Still> poses, int joint)
    {
        float lowest = float.MaxValue;
        foreach (Still pose in poses)
        {
            lowest = Math.Min(lowest, pose.Positions[joint].Y);
        }

        return lowest;
    }

    /// <summary>A creature of a plan as it stands, and then in each frame of an act, in model space.</summary>
    private static (MotionProfile Profile, List<Still> Poses) Filmed(BodyPlan plan, ulong seed, string act)
    {
        var profile = new MotionProfile(Walkers.Of(plan, seed));
        var animator = new CreatureAnimator(profile);
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(animator.Root, FlatGround.Level);
        ActAbility ability = profile.Acts.Find(act);
        List<Still> poses = [Copy()];
        animator.Perform(ability);
        for (int i = 0; i < ability.Seconds * Rate; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            poses.Add(Copy());
        }

        return (profile, poses);

        Still Copy() => new(animator.ModelPose.Positions.ToArray(), animator.ModelPose.Rotations.ToArray());
    }

    private sealed record Still(Vector3[] Positions, Quaternion[] Rotations);
}
