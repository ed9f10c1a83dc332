using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class ActTrialTests
{
    [Theory]
    [InlineData(RequestedKind.Walking, 4100, 1)]
    [InlineData(RequestedKind.Walking, 4101, 1, Explicit = true)]
    [InlineData(RequestedKind.Flying, 4100, 1, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 4100, 1)]
    [InlineData(RequestedKind.Walking, 4102, 4, Explicit = true)]
    [InlineData(RequestedKind.Flying, 4101, 2, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 4101, 2, Explicit = true)]
    public void Acts_keep_to_joints_speeds_ground_and_feet(RequestedKind kind, ulong first, int count)
    {
        List<string> wrong = [];
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = 0 });
            var profile = new MotionProfile(creature);
            foreach (ActTrial trial in ActTrial.Of(profile))
            {
                ActReport report = trial.Run(profile);
                Check("limit", report.LimitExcess, 0.0175f);
                Check("speed", report.JointSpeed, 60f);
                Check("slip", report.FootSlip ?? 0f, 0.01f);
                Check("sinks", report.Penetration ?? 0f, 0.02f);
                Check("misses", report.ContactError ?? 0f, 0.02f);

                // Fish dart off as they flinch; nobody jumps as it lies down, sleeps or dies.
                Check("jolts", report.TrunkJolt, trial.Ability.Act.Kind == ActKind.Posture ? 0.07f : 0.12f);

                void Check(string what, float value, float most)
                {
                    if (!(value <= most))
                    {
                        wrong.Add(FormattableString.Invariant($"{kind} {seed} {creature.Blueprint.Plan} {trial.Ability}: {what} {value:0.000}"));
                    }
                }
            }
        }

        Assert.Empty(wrong);
    }

    [Theory]
    [InlineData(RequestedKind.Walking, 25, Explicit = true)]
    [InlineData(RequestedKind.Flying, 4101, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 4102, Explicit = true)]
    public void An_act_that_is_tried_in_steps_comes_to_the_same_as_one_that_is_tried_at_once(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        CreatureActs atOnce = new MotionProfile(creature).Acts;
        CreatureActs stepped = new MotionProfile(creature).Acts;
        foreach (Act act in ActLibrary.All)
        {
            ActAbility expected = atOnce.Rehearse(act);
            List<ActAbility?> steps = [.. stepped.RehearseInSteps(act)];

            Assert.All(steps.Take(steps.Count - 1), Assert.Null);
            ActAbility found = steps[^1]!;
            Assert.Equal((expected.Refusal, expected.Seconds, expected.SecondsToContact, expected.UsualAim, expected.Parts, expected.Reach), (found.Refusal, found.Seconds, found.SecondsToContact, found.UsualAim, found.Parts, found.Reach));
        }
    }

    [Theory]
    [InlineData(7100062)]
    [InlineData(7100075, Explicit = true)]
    [InlineData(7100060, Explicit = true)]
    [InlineData(6024, Explicit = true)]
    public void Arms_that_hang_behind_a_body_that_bends_down_to_eat_are_not_thrown_out_of_the_ground(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0.6f }));
        foreach (ActTrial trial in ActTrial.Of(profile).Where(trial => trial.Ability.Act.Name is "Eat" or "Drink"))
        {
            ActReport report = trial.Run(profile);
            Assert.InRange(report.JointSpeed, 0f, 60f);
            Assert.InRange(report.Penetration ?? 0f, 0f, 0.02f);
        }
    }

    [Theory]
    [InlineData(9997096, "Claw")]
    [InlineData(9997096, "Scratch", Explicit = true)]
    [InlineData(9997079, "Claw", Explicit = true)]
    [InlineData(9997070, "Claw", Explicit = true)]
    public void A_foot_that_an_act_holds_in_the_air_is_not_laid_on_an_edge_of_its_sole(ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        ActReport report = new ActTrial(profile.Acts.Find(act)).Run(profile);
        Assert.InRange(report.JointSpeed, 0f, 60f);
        Assert.InRange(report.ContactError ?? 0f, 0f, 0.02f);
    }

    [Theory]
    [InlineData(RequestedKind.Walking, 9999008, "Submit")]
    [InlineData(RequestedKind.Flying, 9997011, "Scratch", Explicit = true)]
    [InlineData(RequestedKind.Flying, 9731035, "Submit", Explicit = true)]
    public void Tails_that_swing_in_an_act_do_not_swing_into_the_ground(RequestedKind kind, ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        ActReport report = new ActTrial(profile.Acts.Find(act)).Run(profile);

        // The heel of a foot on which a body sits may be a little deeper than that.
        bool tail = report.PenetrationJoint >= 0 && profile.Subject.Skeleton.Joints[report.PenetrationJoint].Role == JointRole.Tail;
        Assert.InRange(report.Penetration ?? 0f, 0f, tail ? 0.01f : 0.015f);
    }

    [Theory]
    [InlineData(9997082, "Sniff", Explicit = true)]
    [InlineData(9998566, "Shake")]
    public void A_swing_of_the_trunk_is_tried_at_its_ends_and_not_at_a_few_moments(ulong seed, string act)
    {
        // Feet slid by .0104 and .0201 of their legs between two of the moments at which they were looked at.
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(new ActTrial(profile.Acts.Find(act)).Run(profile).FootSlip ?? 0f, 0f, 0.008f);
    }

    [Theory]
    [InlineData(9998523, "Sit")]
    [InlineData(9998523, "Scratch", Explicit = true)]
    [InlineData(9998567, "Sit", Explicit = true)]
    [InlineData(9998511, "Die", Explicit = true)]
    public void Skin_at_folded_hips_stays_above_the_ground_though_several_bones_move_it(ulong seed, string act)
    {
        // .020 to .023 of the body's length was in the ground, where a thigh alone would have left .010.
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(new ActTrial(profile.Acts.Find(act)).Run(profile).Penetration ?? 0f, 0f, 0.015f);
    }

    [Theory]
    [InlineData("Lie")]
    [InlineData("Die", Explicit = true)]
    public void An_abdomen_whose_skin_comes_away_from_its_root_does_not_spring_up(string act)
    {
        // By .7 rad in one update: skin next to the root was not asked, and a little farther off asked for all at once.
        var profile = new MotionProfile(CreatureGenerator.Generate(9971541, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        ActReport report = new ActTrial(profile.Acts.Find(act)).Run(profile);
        Assert.InRange(report.JointSpeed, 0f, 40f);
        Assert.InRange(report.Penetration ?? 0f, 0f, 0.015f);
    }

    [Theory]
    [InlineData("Eat")]
    [InlineData("Drink", Explicit = true)]
    public void A_head_brought_below_its_own_neck_does_not_turn_from_side_to_side(string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9998509, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(new ActTrial(profile.Acts.Find(act)).Run(profile).JointSpeed, 0f, 30f);
    }

    [Theory]
    [InlineData(9999059)]
    [InlineData(9999032)]
    [InlineData(9999004, Explicit = true)]
    [InlineData(9999087, Explicit = true)]
    public void Who_scratches_itself_sits_and_lifts_the_foot_of_one_side_alone(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        ActAbility ability = profile.Acts.Find("Scratch");
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        int pelvis = profile.Subject.Skeleton.IndexOf("Pelvis");
        float stood = animator.ModelPose.Positions[pelvis].Y;
        animator.Perform(ability);
        int raised = ability.Act.Phases.ToList().FindIndex(phase => phase.Name == "raise");
        Walkers.Run(animator, ability.SecondsTo(raised), 60f, default, FlatGround.Level);
        (int left, int right) = profile.Acts.Body.HindFeet;
        Assert.InRange(animator.ModelPose.Positions[pelvis].Y / stood, 0f, 0.85f);
        Assert.True(Height(left) > Height(right) + (0.1f * profile.Acts.Body.Unit), $"{Height(left)} m and {Height(right)} m");
        Assert.InRange(new ActTrial(ability).Run(profile).JointSpeed, 0f, 60f);

        float Height(int foot) => animator.ModelPose.Positions[profile.Legs!.Legs[foot].Ball].Y;
    }

    [Theory]
    [InlineData(9999012)]
    [InlineData(9999040)]
    [InlineData(9999001)]
    [InlineData(9999037, Explicit = true)]
    [InlineData(9999095, Explicit = true)]
    public void Low_bodies_eat_off_the_ground_with_neither_jaw_nor_feelers_in_it(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        ActAbility eating = profile.Acts.Find("Eat");
        Assert.True(eating.IsPossible, eating.Refusal);
        ActReport report = new ActTrial(eating).Run(profile);
        Assert.InRange(report.Penetration ?? 0f, 0f, 0.02f);
        Assert.InRange(report.ContactError ?? 0f, 0f, 0.02f);
    }

    [Fact]
    public void Where_legs_fold_is_found_in_many_small_steps()
    {
        CreatureActs acts = new MotionProfile(CreatureGenerator.Generate(25, CreatureOptions.Default with { Kind = RequestedKind.Walking })).Acts;
        Assert.InRange(ActLibrary.All.Where(act => act.Name == "Lie").Max(act => acts.RehearseInSteps(act).Count()), 50, 1000);
    }

    [Fact]
    public void How_far_a_trunk_goes_and_where_it_reaches_is_found_in_many_small_steps()
    {
        CreatureActs acts = new MotionProfile(SpeciesSubject.Of("bovine", RequestedKind.Walking)).Acts;
        int first = ActLibrary.All.Where(act => act.Name == "Dance").Sum(act => acts.RehearseInSteps(act).Count());
        int again = ActLibrary.All.Where(act => act.Name == "Dance").Sum(act => acts.RehearseInSteps(act).Count());
        Assert.InRange(first - again, 10, 20);
        Assert.InRange(ActLibrary.All.Where(act => act.Name == "Eat").Max(act => acts.RehearseInSteps(act).Count()), 50, 2000);
    }

    [Theory]
    [InlineData(6006, "Lie")]
    [InlineData(6021, "Die", Explicit = true)]
    [InlineData(6022, "Sleep", Explicit = true)]
    [InlineData(6023, "Die")]
    public void A_body_whose_legs_fold_lies_on_the_ground_and_never_hovers_above_it(ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        ActAbility ability = profile.Acts.Find(act);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Perform(ability);
        float highest = 0f;
        for (float seconds = 0f; seconds < ability.Seconds; seconds += 1f / 60f)
        {
            if (seconds < ability.SecondsToLast && seconds + (1f / 60f) >= ability.SecondsToLast)
            {
                animator.GoOn();
            }

            animator.Update(1f / 60f, default, FlatGround.Level);
            highest = Math.Max(highest, profile.Acts.Body.Skin.Lowest(animator.ModelPose) / profile.Acts.Body.Size);
        }

        Assert.InRange(highest, 0f, 0.025f);
    }

    [Theory]
    [InlineData(6021, "Die")]
    [InlineData(6006, "Lie", Explicit = true)]
    [InlineData(6016, "Sleep", Explicit = true)]
    [InlineData(6049, "Shake", Explicit = true)]
    [InlineData(6095, "Lie", Explicit = true)]
    [InlineData(9731018, "Threaten")]
    [InlineData(9985059, "Flinch", Explicit = true)]
    public void Tails_and_feelers_that_swing_stay_above_the_ground(ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile).Penetration!.Value, 0f, 0.01f);
    }

    /// <summary>The club at the end of a tail that goes down steeply is below it as the tail comes to lie.</summary>
    [Theory]
    [InlineData("Submit")]
    [InlineData("Die")]
    public void A_steep_tail_that_comes_to_lie_stays_above_the_ground_with_all_of_its_skin(string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9731023, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        Assert.InRange(ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile).Penetration!.Value, 0f, 0.01f);
    }

    [Theory]
    [InlineData(9731011, "TailSweep")]
    [InlineData(9731014, "TailSweep")]
    [InlineData(9731011, "Groom", Explicit = true)]
    public void Feet_stay_where_they_stand_as_weight_that_was_on_one_side_comes_back_for_an_act(ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile).FootSlip!.Value, 0f, 0.01f);
    }

    [Theory]
    [InlineData(RequestedKind.Flying, 7100092, "Scratch")]
    [InlineData(RequestedKind.Flying, 7100040, "Threaten")]
    public void Tails_come_out_of_the_ground_as_quickly_as_they_would_go_into_it_and_no_quicker(RequestedKind kind, ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        ActReport report = ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile);
        Assert.InRange(report.Penetration!.Value, 0f, 0.02f);
        Assert.InRange(report.JointSpeed, 0f, 30f);
    }

    /// <summary>Its fore feet lay straight out beside its hips, along the hinges of their knees: as they came back these legs turned round at once, the lower one under the body, which it threw up by .65 m.</summary>
    [Fact]
    public void A_body_that_topples_is_not_thrown_up_by_a_leg_that_turns_round_below_it()
    {
        ActReport report = Die(24800458);
        Assert.InRange(report.JointSpeed, 0f, 20f);
        Assert.InRange(report.TrunkJolt, 0f, 0.03f);
    }

    /// <summary>Bodies on two legs came over at full speed and stood still at once; spread wings stood in the way of a body that rolled onto them and legs out to the sides below lizards and insects were like stilts. In order: jolts of .047, .043, .046, .049, .055 and .061 of the body's length.</summary>
    [Theory]
    [InlineData(24811005)]
    [InlineData(24811016, Explicit = true)]
    [InlineData(24781017)]
    [InlineData(24830005, Explicit = true)]
    [InlineData(24830011)]
    [InlineData(24830007)]
    public void Bodies_that_die_come_down_without_a_jolt(ulong seed) => Assert.InRange(Die(seed).TrunkJolt, 0f, 0.03f);

    /// <summary>It went over in the air on stiff legs, 2.3 times as high as it stands.</summary>
    [Fact]
    public void Legs_out_to_the_sides_are_drawn_in_before_a_body_rolls_over_onto_its_back()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(24811004, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Update(1f / 60f, default, FlatGround.Level);
        int chest = profile.Subject.Skeleton.FirstOf(JointRole.Chest);
        float standing = animator.ModelPose.Positions[chest].Y;
        ActAbility die = profile.Acts.Find("Die");
        animator.Perform(die);
        float highest = 0f;
        for (float time = 0f; time < die.SecondsToLast; time += 1f / 60f)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            highest = Math.Max(highest, animator.ModelPose.Positions[chest].Y);
        }

        Assert.InRange(highest / standing, 0f, 1.7f);
    }

    [Theory]
    [InlineData(7100003, Explicit = true)]
    [InlineData(7100059, Explicit = true)]
    [InlineData(9982050, Explicit = true)]
    public void Upright_bodies_lie_down_without_a_leg_that_springs_round(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        foreach (ActTrial trial in ActTrial.Of(profile).Where(trial => trial.Ability.Act.Name is "Lie" or "Sleep" or "Die"))
        {
            Assert.InRange(trial.Run(profile).JointSpeed, 0f, 60f);
        }
    }

    [Fact]
    public void What_a_body_cannot_do_one_way_it_does_another_way()
    {
        // Its feet would not stay where they stand if it took its nose down to the ground as other bodies on hooves do.
        CreatureActs acts = new MotionProfile(CreatureGenerator.Generate(7100062, CreatureOptions.Default with { Kind = RequestedKind.Walking })).Acts;
        Act[] ways = [.. ActLibrary.All.Where(act => act.Name == "Sniff" && (act.Builds & BodyBuild.Hoofed) != 0)];
        Assert.Contains("feet", acts.Rehearse(ways[0]).Refusal, StringComparison.Ordinal);
        Assert.Same(ways[1], acts.Find("Sniff").Act);
        Assert.True(acts.Find("Sniff").IsPossible);

        // What no way suits tells why not the way that suits best.
        Assert.Contains("it is not for a body", acts.Find("Scratch").Refusal, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(7100058)]
    [InlineData(9982050)]
    public void Bodies_with_arms_wash_their_faces(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var animator = new CreatureAnimator(creature);
        int hand = creature.Limbs.First(limb => limb.Kind == LimbKind.Arm).Joints[^1];
        int head = creature.Skeleton.FirstOf(JointRole.Head);
        animator.Update(1f / 60f, default, FlatGround.Level);
        float hanging = Apart();
        animator.Perform("Groom");
        float nearest = float.MaxValue;
        for (int i = 0; i < 300; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            nearest = Math.Min(nearest, Apart());
        }

        Assert.True(nearest < 0.7f * hanging, $"hands come to {nearest} m from the head, {hanging} m as they hang");

        float Apart() => Vector3.Distance(animator.ModelPose.Positions[hand], animator.ModelPose.Positions[head]);
    }

    [Theory]
    [InlineData(6023)]
    [InlineData(6046)]
    [InlineData(6059)]
    public void An_upright_body_lies_on_its_chest_and_not_on_its_heels(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        int chest = profile.Subject.Skeleton.IndexOf("Chest");
        float stood = animator.ModelPose.Positions[chest].Y;
        animator.Perform("Lie");
        Walkers.Run(animator, profile.Acts.Find("Lie").SecondsToLast, 60f, default, FlatGround.Level);
        Assert.InRange(animator.ModelPose.Positions[chest].Y / stood, 0f, 0.4f);
    }

    [Theory]
    [InlineData(6023)]
    [InlineData(6024)]
    [InlineData(6027)]
    public void An_arm_that_claws_does_not_whip_round(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        foreach (ActTrial trial in ActTrial.Of(profile).Where(trial => trial.Ability.Act is { Name: "Claw", Tool: ActTool.Hand }))
        {
            Assert.InRange(trial.Run(profile).JointSpeed, 0f, 60f);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Plantigrade, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Unguligrade, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Theropod, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Sprawling, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Digitigrade, "Sit")]
    [InlineData(BodyPlan.Upright, "Sit", Explicit = true)]
    public void Who_lies_or_sits_has_its_hips_down_by_most_of_the_height_of_its_belly(BodyPlan plan, string act)
    {
        List<string> wrong = [];
        for (ulong seed = 1; seed <= 4; seed++)
        {
            var profile = new MotionProfile(Walkers.Of(plan, seed));
            ActAbility lie = profile.Acts.Find(act);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(animator.Root, FlatGround.Level);
            int pelvis = profile.Subject.Skeleton.IndexOf("Pelvis");
            float stood = animator.ModelPose.Positions[pelvis].Y;
            ActStart start = animator.Perform(lie);
            Walkers.Run(animator, lie.SecondsToLast, 60f, default, FlatGround.Level);
            float down = (stood - animator.ModelPose.Positions[pelvis].Y) / profile.Legs!.BellyHeight;
            if (start.Status != ActStatus.Started || !(down > 0.55f))
            {
                wrong.Add(FormattableString.Invariant($"{seed}: {start.Reason} down by {down:0.00}"));
            }
        }

        Assert.Empty(wrong);
    }

    [Fact]
    public void Every_creature_that_stands_can_do_most_of_the_acts()
    {
        int possible = 0;
        int all = 0;
        for (ulong seed = 4200; seed < 4210; seed++)
        {
            CreatureActs acts = new MotionProfile(Walkers.Any(seed)).Acts;
            possible += acts.Possible.Count();
            all += acts.All.Count;
            Assert.All(acts.All, ability => Assert.True(ability.IsPossible || ability.Refusal!.Length > 10, ability.Act.Name));
        }

        Assert.InRange(possible / (double)all, 0.5, 1);
    }

    private static ActReport Die(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        return new ActTrial(profile.Acts.Find("Die")).Run(profile);
    }
}
