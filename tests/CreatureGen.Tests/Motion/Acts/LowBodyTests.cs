using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Falling;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

/// <summary>Acts of bodies with legs out to the side, with many, and with none.</summary>
public class LowBodyTests
{
    private const float Rate = 60f;

    /// <summary>A trunk rolled and shifted over feet that stand leaves these no room: a frog did a third of it, and died on its feet.</summary>
    [Theory]
    [InlineData(11200012UL)]
    [InlineData(11200002UL, Explicit = true)]
    public void Who_dies_on_low_legs_comes_down_with_chest_and_head(ulong seed)
    {
        CreatureAnimator animator = Performing(Strange(seed), "Die", out ActAbility die);
        float stood = Height(animator, JointRole.Chest);
        Walkers.Run(animator, die.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.Equal(1f, die.Gain);
        Assert.InRange(Height(animator, JointRole.Chest) / stood, 0f, 0.72f);
        Assert.InRange(Height(animator, JointRole.Head) / stood, 0f, 0.72f);
        Assert.InRange(GettingUpTests.Lowest(animator), -0.01f * GettingUpTests.Extent(animator.Profile.Subject.Creature!), 1f);
    }

    /// <summary>It was let down by as much as its belly, which hangs lower.</summary>
    [Theory]
    [InlineData(11200072UL)]
    public void A_body_whose_back_slopes_lets_its_chest_down_farther_than_its_belly(ulong seed)
    {
        CreatureAnimator animator = Performing(new MotionProfile(KeptCreatures.Of(seed)), "Lie", out ActAbility lie);
        float stood = Lowest(animator, "Chest");
        Walkers.Run(animator, lie.SecondsToLast, Rate, default, FlatGround.Level);
        float down = (stood - Lowest(animator, "Chest")) / animator.Profile.Acts.Body.Legs!.BellyHeight;
        Assert.True(down > 1.05f, $"its chest came down by {down} of the height of its belly");
    }

    /// <summary>Its feet stayed where they stood and its knees where they were, .58 to .66 of a leg high: it hung between four stilts.</summary>
    [Theory]
    [InlineData(24781011UL)]
    [InlineData(24803025UL, Explicit = true)]
    [InlineData(24803027UL, Explicit = true)]
    [InlineData(24803060UL, Explicit = true)]
    [InlineData(24803020UL, Explicit = true)]
    [InlineData(24803058UL, Explicit = true)]
    public void Legs_out_to_the_sides_of_a_body_that_lies_are_laid_down_with_their_elbows_behind_and_their_knees_ahead(ulong seed)
    {
        CreatureAnimator animator = Performing(Strange(seed), "Lie", out ActAbility lie);
        Walkers.Run(animator, lie.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.All(animator.Profile.Acts.Body.Legs!.Legs, leg =>
        {
            ReadOnlySpan<Vector3> places = animator.ModelPose.Positions;
            Vector3 knee = places[leg.Knee] - places[leg.Hip];
            Assert.InRange(places[leg.Knee].Y / leg.Length, 0f, 0.36f);
            Assert.InRange((leg.Row == 0 ? knee.Z : -knee.Z) / leg.Length, 0.1f, 1f);
        });
    }

    /// <summary>Bent or raised over all of them, a trunk with a dozen pairs of legs, or with short ones out to the side, drags its feet.</summary>
    [Theory]
    [InlineData(11200043UL, "Bite")]
    [InlineData(11200043UL, "Threaten")]
    [InlineData(11200086UL, "Bite", Explicit = true)]
    public void Many_feet_do_not_keep_a_body_from_biting_and_threatening(ulong seed, string act) => Assert.Null(Strange(seed).Acts.Find(act).Refusal);

    /// <summary>Its trunk was away before its knees could go along, and a foot slipped by .019 of its leg.</summary>
    [Fact]
    public void The_feet_of_a_centipede_stay_where_they_stand_as_it_starts()
    {
        MotionProfile profile = Of(BodyPlan.ManyLegged, 24353267);
        ActReport report = ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == "Flinch").Run(profile);
        Assert.InRange(report.FootSlip!.Value, 0f, 0.01f);
    }

    [Theory]
    [InlineData(11200000UL)]
    [InlineData(11200004UL, Explicit = true)]
    public void A_crawler_dances(ulong seed) => Assert.Null(Crawler(seed).Acts.Find("Dance").Refusal);

    /// <summary>It lay down flat along the ground, from where it could not strike.</summary>
    [Theory]
    [InlineData(11200000UL)]
    [InlineData(11200004UL, Explicit = true)]
    public void A_startled_crawler_draws_its_head_up(ulong seed)
    {
        MotionProfile profile = Crawler(seed);
        CreatureAnimator animator = Performing(profile, "Flinch", out ActAbility flinch);
        float carried = Height(animator, JointRole.Head);
        Walkers.Run(animator, flinch.SecondsTo(1), Rate, default, FlatGround.Level);
        Assert.InRange(Height(animator, JointRole.Head) / carried, 1.2f, 10f);
    }

    /// <summary>They kept it as high as they carry it, which is not much higher than a head that lies.</summary>
    [Theory]
    [InlineData(11200000UL, "Die")]
    [InlineData(11200004UL, "Die", Explicit = true)]
    public void A_crawler_lays_its_head_down_as_it_dies(ulong seed, string act)
    {
        MotionProfile profile = Crawler(seed);
        var awake = new CreatureAnimator(profile);
        awake.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(awake, 1f, Rate, default, FlatGround.Level);
        float carried = Height(awake, JointRole.Head);
        CreatureAnimator animator = Performing(profile, act, out ActAbility die);
        Walkers.Run(animator, die.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.InRange(Height(animator, JointRole.Head) / carried, 0f, 0.92f);
        Assert.InRange(GettingUpTests.Lowest(animator), -0.015f * GettingUpTests.Extent(animator.Profile.Subject.Creature!), 1f);
    }

    /// <summary>They kept their necks in an arch, with the snout on the ground.</summary>
    [Theory]
    [InlineData(12500127UL, "Die")]
    [InlineData(12500035UL, "Die", Explicit = true)]
    [InlineData(12500127UL, "Sleep", Explicit = true)]
    public void A_crawler_that_carries_its_neck_raised_lays_it_along_the_ground(ulong seed, string act)
    {
        MotionProfile profile = Strange(seed);
        ReadOnlySpan<Vector3> carried = profile.Subject.Skeleton.ModelPositions;
        CreatureAnimator animator = Performing(profile, act, out ActAbility ability);
        Walkers.Run(animator, ability.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.Equal(1f, ability.Gain);
        foreach (string joint in new[] { "Neck_03", "Head" })
        {
            int index = profile.Subject.Skeleton.IndexOf(joint);
            Assert.InRange(animator.ModelPose.Positions[index].Y / carried[index].Y, 0f, 0.6f);
        }

        Assert.InRange(GettingUpTests.Lowest(animator), -0.015f * GettingUpTests.Extent(animator.Profile.Subject.Creature!), 1f);
    }

    /// <summary>What of the skin of its neck touches the ground changes from one moment to the next: a joint that came out of it at once turned at 80 rad/s, one that made good what all those before it had turned at 85 and 166.</summary>
    [Theory]
    [InlineData(15040048UL, "Die")]
    [InlineData(20100026UL, "Die")]
    [InlineData(20100026UL, "Sleep")]
    public void No_joint_of_a_crawler_that_lays_its_neck_down_flips_over(ulong seed, string act)
    {
        MotionProfile profile = Strange(seed);
        Assert.InRange(ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile).JointSpeed, 0f, 60f);
    }

    /// <summary>Its tall legs stand close together: a chest that came down before the hips tipped it over onto its head, so that it did half of it.</summary>
    [Theory]
    [InlineData(12500081UL)]
    [InlineData(12500007UL, Explicit = true)]
    public void A_mantis_that_dies_comes_down_on_its_belly(ulong seed)
    {
        CreatureAnimator animator = Performing(Strange(seed), "Die", out ActAbility die);
        Walkers.Run(animator, die.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.Equal(1f, die.Gain);
        ActBody body = animator.Profile.Acts.Body;
        Assert.InRange(animator.ModelPose.Positions[body.Body].Y - body.Depth, -1f, 0.15f * body.Legs!.BellyHeight);
    }

    /// <summary>On its way to its back it went over a stiff wing, on which it stood four times as high as on its legs.</summary>
    [Theory]
    [InlineData(24800454UL)]
    [InlineData(24800471UL)]
    public void A_sprawler_with_spread_wings_dies_on_its_belly(ulong seed)
    {
        MotionProfile profile = Strange(seed);
        CreatureAnimator animator = Performing(profile, "Die", out ActAbility die);
        int body = profile.Acts.Body.Body;
        float stands = animator.ModelPose.Positions[body].Y;
        float highest = 0f;
        for (float seconds = 0f; seconds < die.SecondsToLast; seconds += 1f / 60f)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            highest = Math.Max(highest, animator.ModelPose.Positions[body].Y);
        }

        Assert.InRange(highest, 0.5f * stands, 1.1f * stands);
    }

    /// <summary>Laid back as feelers are it would go into the ground.</summary>
    [Fact]
    public void What_points_back_is_not_laid_back_with_the_ears()
    {
        MotionProfile profile = Strange(12500005);
        Assert.NotEmpty(profile.Acts.Body.Trains);
        Assert.Equal(1f, profile.Acts.Find("Flinch").Gain);
    }

    /// <summary>Insects drew back and bit with their heads by .37 of a leg, which looked like nothing.</summary>
    [Theory]
    [InlineData(24353303UL)]
    [InlineData(24353301UL, Explicit = true)]
    public void Many_legs_draw_back_and_throw_the_body_ahead_as_it_bites(ulong seed)
    {
        (Vector3 least, Vector3 most) = WayOfHead(Of(BodyPlan.Hexapod, seed), "Bite");
        Assert.InRange(most.Z - least.Z, 0.47f, 2f);
    }

    /// <summary>Its head stayed at the ground and hardly moved.</summary>
    [Theory]
    [InlineData(24353303UL)]
    public void Who_eats_on_many_legs_raises_its_head_to_chew(ulong seed) => Assert.InRange(WayOfHead(Of(BodyPlan.Hexapod, seed), "Eat").Most.Y, 0.1f, 1f);

    /// <summary>Where its feet left its trunk no room it did a third of all, of what head and tail do too.</summary>
    [Theory]
    [InlineData(24353305UL)]
    [InlineData(24353300UL, Explicit = true)]
    public void Head_and_tail_of_a_centipede_flinch_though_its_feet_hold_its_trunk(ulong seed) => Assert.Equal(1f, Of(BodyPlan.ManyLegged, seed).Acts.Find("Flinch").Gain);

    /// <summary>It raised its head and two feet, and its trunk hardly moved in any act. Joints bend by some sixty degrees at most for it, on short backs by forty.</summary>
    [Theory]
    [InlineData(24903001UL, "Threaten", 2)]
    [InlineData(24903004UL, "Dance", 2, Explicit = true)]
    [InlineData(24903008UL, "Sniff", 2, Explicit = true)]
    public void Who_stands_on_many_pairs_of_legs_raises_the_front_of_its_trunk_with_its_feet(ulong seed, string act, int pairs)
    {
        CreatureAnimator animator = Performing(Of(BodyPlan.ManyLegged, seed), act, out ActAbility ability);
        ActBody body = animator.Profile.Acts.Body;
        int chest = body.Spine[^1];
        float stood = animator.ModelPose.Positions[chest].Y;
        float highest = 0f;
        int aloft = 0;
        for (int i = 0; i < ability.Seconds * Rate; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            highest = Math.Max(highest, (animator.ModelPose.Positions[chest].Y - stood) / body.Unit);
            int raised = 0;
            foreach ((int left, int right) in body.FrontPairs)
            {
                float lower = Math.Min(animator.ModelPose.Positions[body.Legs!.Legs[left].Ball].Y, animator.ModelPose.Positions[body.Legs.Legs[right].Ball].Y);
                raised += lower > 0.1f * body.Unit ? 1 : 0;
            }

            aloft = Math.Max(aloft, raised);
        }

        Assert.InRange(highest, 0.35f, 5f);
        Assert.InRange(aloft, pairs, body.Legs!.Rows / 2);
        Assert.Equal(1f, ability.Gain);
    }

    /// <summary>It slept as it stood, only lower, with its back straight.</summary>
    [Theory]
    [InlineData(24903001UL)]
    [InlineData(24903006UL, Explicit = true)]
    public void Who_sleeps_on_many_pairs_of_legs_coils_up_with_its_feet_beside_it(ulong seed)
    {
        CreatureAnimator animator = Performing(Of(BodyPlan.ManyLegged, seed), "Sleep", out ActAbility sleep);
        ActBody body = animator.Profile.Acts.Body;
        float stood = Vec.Distance(animator.ModelPose.Positions[body.Spine[^1]], animator.ModelPose.Positions[body.Spine[0]]);
        Walkers.Run(animator, sleep.SecondsToLast, Rate, default, FlatGround.Level);
        Assert.InRange(Vec.Distance(animator.ModelPose.Positions[body.Spine[^1]], animator.ModelPose.Positions[body.Spine[0]]) / stood, 0.3f, 0.93f);
        foreach (LegRig leg in body.Legs!.Legs)
        {
            Vector3 way = animator.ModelPose.Positions[leg.Ball] - animator.ModelPose.Positions[leg.Hip];
            Assert.InRange(Vec.Length(way) / leg.Length, 0f, 1.05f);
        }
    }

    /// <summary>How far the head goes from where it is as the body stands, leg lengths.</summary>
    private static (Vector3 Least, Vector3 Most) WayOfHead(MotionProfile profile, string act)
    {
        CreatureAnimator animator = Performing(profile, act, out ActAbility ability);
        int head = profile.Acts.Body.Head;
        Vector3 stood = animator.ModelPose.Positions[head];
        Vector3 least = Vector3.Zero;
        Vector3 most = Vector3.Zero;
        for (int i = 0; i < ability.Seconds * Rate; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            Vector3 way = (animator.ModelPose.Positions[head] - stood) / profile.Acts.Body.Unit;
            least = Vector3.Min(least, way);
            most = Vector3.Max(most, way);
        }

        return (least, most);
    }

    private static MotionProfile Of(BodyPlan plan, ulong seed) => new(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = new([new BodyPlanWeight(plan, 1000)]) }));

    private static MotionProfile Strange(ulong seed) => new(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));

    private static MotionProfile Crawler(ulong seed) => new(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = BodyPlanWeight.Only(BodyPlan.Legless) }));

    private static CreatureAnimator Performing(MotionProfile profile, string act, out ActAbility ability)
    {
        ability = profile.Acts.Find(act);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Assert.Equal(ActStatus.Started, animator.Perform(ability).Status);
        return animator;
    }

    /// <summary>Height of the lowest skin that a joint moves most.</summary>
    private static float Lowest(CreatureAnimator animator, string joint)
    {
        int index = animator.Profile.Subject.Skeleton.IndexOf(joint);
        Vector3[] skin = GettingUpTests.Skin(animator);
        return Enumerable.Range(0, skin.Length).Where(v => animator.Profile.Subject.Mesh.Weights[v].Joint0 == index).Min(v => skin[v].Y);
    }

    /// <summary>Mean height of the joints of a role.</summary>
    private static float Height(CreatureAnimator animator, JointRole role)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        return Enumerable.Range(0, skeleton.Count).Where(j => skeleton.Joints[j].Role == role).Average(j => animator.ModelPose.Positions[j].Y);
    }
}
