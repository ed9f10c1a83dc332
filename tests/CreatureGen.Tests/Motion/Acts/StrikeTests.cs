using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class StrikeTests
{
    [Theory]
    [InlineData(9999067)]
    [InlineData(9999092)]
    [InlineData(9999095)]
    public void A_sting_comes_over_the_back(ulong seed)
    {
        Vector3 tip = TipFromRoot(seed);
        Assert.InRange(tip.Y, 0.25f, 0.8f);
        Assert.InRange(tip.Z, -0.02f, 0.8f);
    }

    [Theory]
    [InlineData(9999001)]
    [InlineData(9999006)]
    [InlineData(9999018)]
    public void An_abdomen_stings_down_under_itself(ulong seed)
    {
        Assert.InRange(TipFromRoot(seed).Y, -0.95f, -0.3f);
    }

    [Fact]
    public void A_sting_or_spikes_along_the_back_are_no_horns_to_gore_with()
    {
        Assert.Contains("no horns", Profile(9999092).Acts.Find("Gore").Refusal, StringComparison.Ordinal);
        Assert.True(Profile(9999049).Acts.Find("Gore").IsPossible);
    }

    [Theory]
    [InlineData(9999049)]
    [InlineData(9999007)]
    [InlineData(9999068)]
    [InlineData(9999079)]
    public void A_head_that_gores_is_lowered_as_it_hits(ulong seed)
    {
        CreatureAnimator striking = AtContact(seed, "Gore");
        ActBody body = striking.Profile.Acts.Body;
        Pose hit = striking.ModelPose;
        Assert.InRange(hit.Positions[body.Head].Y / body.Skeleton.ModelPositions[body.Head].Y, 0f, 0.9f);
    }

    [Theory]
    [InlineData(9999048)]
    [InlineData(9999010)]
    [InlineData(9999060)]
    [InlineData(9999047)]
    public void An_arm_that_claws_is_stretched_out_as_it_hits(ulong seed)
    {
        CreatureAnimator striking = AtContact(seed, "Claw");
        Pose hit = striking.ModelPose;
        int[] arm = striking.Profile.Acts.Body.Tools.ArmOf(false);
        float length = 0f;
        for (int i = 1; i < arm.Length; i++)
        {
            length += Vector3.Distance(hit.Positions[arm[i]], hit.Positions[arm[i - 1]]);
        }

        Assert.InRange(Vector3.Distance(hit.Positions[arm[0]], hit.Positions[arm[^1]]) / length, 0.7f, 1f);
    }

    /// <summary>It came no higher than .4 of the leg, under a trunk that leaned back by .12.</summary>
    [Theory]
    [InlineData(20100003)]
    [InlineData(20100013)]
    [InlineData(20100033)]
    public void Who_kicks_on_two_legs_leans_back_and_brings_its_foot_up_before_it(ulong seed)
    {
        CreatureAnimator striking = AtContact(seed, "Kick");
        ActBody body = striking.Profile.Acts.Body;
        Pose hit = striking.ModelPose;
        ReadOnlySpan<Vector3> rest = body.Skeleton.ModelPositions;
        int ball = body.Legs!.Legs[body.HindFeet.Left].Ball;
        int chest = body.Spine[^1];
        Assert.InRange((hit.Positions[ball].Y - rest[ball].Y) / body.Unit, 0.45f, 1f);
        Assert.InRange(Elevation(hit.Positions[chest] - hit.Positions[body.Spine[0]]) - Elevation(rest[chest] - rest[body.Spine[0]]), 0.2f, 0.6f);

        static float Elevation(Vector3 way) => MathF.Atan2(way.Y, way.Z);
    }

    /// <summary>Where the tip of the tail is as it stings, from the tail's root, tails.</summary>
    private static Vector3 TipFromRoot(ulong seed)
    {
        CreatureAnimator striking = AtContact(seed, "Sting");
        ActBody body = striking.Profile.Acts.Body;
        Pose hit = striking.ModelPose;
        return (body.Tools.PlaceOf(ActTool.Tail, false, hit) - hit.Positions[body.Tail.Joints[0]]) / body.Tail.Length;
    }

    private static MotionProfile Profile(ulong seed) => new(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));

    /// <summary>A walker as its act, on the left and at what suits it, has its contact.</summary>
    private static CreatureAnimator AtContact(ulong seed, string act)
    {
        MotionProfile profile = Profile(seed);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        ActAbility ability = profile.Acts.Find(act);
        animator.Perform(ability, ActTarget.At(ability.Usual));
        for (int i = 0; i < 600; i++)
        {
            animator.Update(1f / 240f, default, FlatGround.Level);
            foreach (ActEvent moment in animator.ActEvents)
            {
                if (moment.Mark == ActMark.Contact)
                {
                    return animator;
                }
            }
        }

        throw new Xunit.Sdk.XunitException(ability.ToString());
    }
}
