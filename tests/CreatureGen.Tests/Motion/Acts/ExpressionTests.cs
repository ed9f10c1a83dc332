using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
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

    /// <summary>It turned its head to the side and looked about.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade, 1)]
    [InlineData(BodyPlan.Unguligrade, 2)]
    public void Who_grooms_without_hands_brings_its_mouth_to_a_fore_leg(BodyPlan plan, ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(plan, seed, "Groom");
        ActBody body = profile.Acts.Body;
        LegRig leg = body.Legs!.Legs[body.ForeFeet.Left];
        float nearest = float.MaxValue;
        foreach (Still pose in poses)
        {
            Vector3 mouth = body.Tools.PlaceOf(ActTool.Mouth, false, new Pose(pose.Rotations, pose.Positions));
            foreach (int joint in new[] { leg.Knee, leg.Ankle, leg.Ball })
            {
                nearest = Math.Min(nearest, Vector3.Distance(mouth, pose.Positions[joint]));
            }
        }

        Assert.InRange(nearest / body.Unit, 0f, 0.25f);
    }

    /// <summary>Its hind feet stood as if nailed to the ground.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade, 1)]
    [InlineData(BodyPlan.Unguligrade, 2)]
    public void Who_dances_on_four_feet_lifts_those_behind_too(BodyPlan plan, ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(plan, seed, "Dance");
        ActBody body = profile.Acts.Body;
        foreach (int leg in new[] { body.HindFeet.Left, body.HindFeet.Right })
        {
            int ball = body.Legs!.Legs[leg].Ball;
            float highest = float.MinValue;
            foreach (Still pose in poses)
            {
                highest = Math.Max(highest, pose.Positions[ball].Y - poses[0].Positions[ball].Y);
            }

            Assert.InRange(highest / body.Unit, 0.08f, 0.4f);
        }
    }

    /// <summary>It slept with its head straight ahead, in the air.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Who_sleeps_on_two_legs_lays_its_head_round_to_a_shoulder(ulong seed)
    {
        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Theropod, seed, "Sleep");
        int head = profile.Acts.Body.Head;
        Vector3 snout = Vector3.Transform(Vector3.UnitZ, poses[^1].Rotations[head] * Quaternion.Inverse(poses[0].Rotations[head]));
        Assert.InRange(Math.Abs(snout.X), 0.45f, 1f);
    }

    /// <summary>They went up off the rump with a chest that bows away from it.</summary>
    [Fact]
    public void Folded_wings_stay_along_a_back_that_bends()
    {
        ulong bird = 1;
        while (new MotionProfile(Walkers.Of(BodyPlan.Theropod, bird)).Acts.Body.Wings.Length == 0)
        {
            bird++;
        }

        (MotionProfile profile, List<Still> poses) = Filmed(BodyPlan.Theropod, bird, "Eat");
        ActBody body = profile.Acts.Body;
        float off = 0f;
        foreach (Still pose in poses)
        {
            off = Math.Max(off, Off(pose) - Off(poses[0]));
        }

        Assert.InRange(off, 0f, 0.16f);

        // By how much a wing points up from the line of the back, radians.
        float Off(Still pose)
        {
            Vector3 back = pose.Positions[body.Spine[0]] - pose.Positions[body.Spine[^1]];
            Vector3 wing = pose.Positions[Tip(body, body.Wings[0])] - pose.Positions[body.Wings[0]];
            return MathF.Atan2(wing.Y, -wing.Z) - MathF.Atan2(back.Y, -back.Z);
        }
    }

    private static int Tip(ActBody body, int root)
    {
        int tip = root;
        for (int joint = root; joint < body.Skeleton.Count; joint++)
        {
            tip = body.Skeleton.Parents[joint] == tip ? joint : tip;
        }

        return tip;
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
