using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>Feet on stairs that are hardly longer than they are: they are put where no end of them is in a riser.</summary>
public sealed class StairFootingTests
{
    private const float Deep = 0.03f;
    private const float Lookout = 10f;

    [Theory]
    [InlineData(7100003UL, Explicit = true)]
    [InlineData(7100005UL, Explicit = true)]
    [InlineData(7100006UL, Explicit = true)]
    [InlineData(9920017UL)]
    public void Standing_feet_are_seldom_in_the_risers_of_stairs_at_a_run(ulong seed)
    {
        Creature creature = Walkers.Any(seed);
        var profile = new MotionProfile(creature);
        var simulation = new CourseSimulation(profile, CourseScripts.Runner(profile, 8f), CourseGround.Stairs, CourseRate.Of(60f));
        FootSkin[] skins = Array.ConvertAll(profile.Legs!.Legs, leg => new FootSkin(new MotionSubject(creature), leg.Ankle, leg.Ball, leg.Length));
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        int standing = 0;
        int deep = 0;
        foreach (float _ in simulation.Updates())
        {
            SkinMatrices.Fill(creature.Skeleton, simulation.Animator.ModelPose, matrices);
            for (int i = 0; i < skins.Length; i++)
            {
                if (simulation.Animator.Foot(i).Phase == FootPhase.Stance)
                {
                    standing++;
                    deep += Depth(simulation, skins[i], matrices) > Deep * profile.LegLength ? 1 : 0;
                }
            }
        }

        Assert.True(deep <= 0.05 * standing, $"{seed}: {deep} of {standing} times a standing foot is deeper than {Deep} leg lengths in the stairs");
    }

    /// <summary>A bear whose hip turned by 90 rad/s as a foot passed it.</summary>
    [Fact]
    public void No_leg_whirls_about_its_hip_where_a_foot_is_carried_past_it_up_stairs()
    {
        var profile = new MotionProfile(KeptCreatures.Of(9920015));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.JointSpeed < 60f, $"{profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
    }

    /// <summary>A running biped whose thigh came to its end before a riser: it flipped its shank from behind that to before it, at 112 rad/s, to be as high as its foot was to be farther up.</summary>
    [Fact]
    public void A_shank_is_brought_over_a_riser_without_a_flip_where_its_thigh_is_at_its_limit()
    {
        var profile = new MotionProfile(KeptCreatures.Of(10900037));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.JointSpeed < 60f, $"{profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
    }

    /// <summary>Lizards whose toes turned with the foot as its heel came off: they slipped by 4 and 4.9 % of a leg.</summary>
    [Theory]
    [InlineData(9920012UL, Explicit = true)]
    [InlineData(9920031UL)]
    public void Toes_of_legs_out_to_the_side_stay_where_they_stand_on_stairs_as_their_heels_come_off(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.015f, $"{seed}: a stance slips by {report.StanceSlip}");
    }

    /// <summary>A running biped whose foot came down far behind it: its hip came to its end between two decisions, and dragged the foot by 4.8 % of a leg.</summary>
    [Fact]
    public void A_foot_that_lies_far_behind_on_stairs_is_let_go_before_its_hip_ends()
    {
        var profile = new MotionProfile(KeptCreatures.Of(9920016));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 15f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.03f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>An insect whose foot came down .15 of a leg from where its leg could bring it, on another tread: it is not dragged back so far.</summary>
    [Fact]
    public void A_foot_that_comes_down_far_from_its_place_stays_on_the_tread_that_it_has_come_to()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9920051, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.02f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>A cat whose foot was shifted off an edge once more as it stood where it had come down: it slipped by 12 % of a leg.</summary>
    [Fact]
    public void A_foot_that_stands_where_it_came_down_is_not_shifted_off_edges_again()
    {
        var profile = new MotionProfile(KeptCreatures.Of(9920002));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.015f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>A centipede that stood across stairs shifted its weight over a foot that reached far up, and drew it along by .114 of a leg.</summary>
    [Fact]
    public void Who_stands_across_stairs_does_not_draw_feet_along_that_are_above_it()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(22401057, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Mixed(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.02f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>An upright walker's flat feet lay still down stairs where their toes hung over edges, until their ankles came to their ends and drew them along: by .0087 of a leg.</summary>
    [Fact]
    public void Heels_of_flat_feet_rise_whose_toes_hang_over_an_edge()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(24352025, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.006f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>A body on six hooves came down for a leg that was stretched, and pushed a folded one by .07 of a leg into the ground: its foot slipped by .027.</summary>
    [Fact]
    public void A_body_comes_down_for_a_stretched_leg_no_farther_than_the_others_fold()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(24350022, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip < 0.01f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>A fore foot with spread toes, one of which was in the next riser, stood on air as high as a part of that: it was dragged as it rolled, by .02 of a leg.</summary>
    [Fact]
    public void Feet_are_set_back_where_one_of_their_spread_toes_would_be_in_a_riser()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(23153307, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile);
        Assert.True(report.StanceSlip99 < 0.01f, $"one stance of a hundred slips by {report.StanceSlip99}");
    }

    /// <summary>The place of a foot was moved off risers little by little while what was asked for went on: toes were .12 of a leg deep in the mean.</summary>
    [Theory]
    [InlineData(10800000UL, 8)]
    [InlineData(10800016UL, 16, Explicit = true)]
    public void Feet_seldom_come_down_with_their_toes_in_the_next_riser(ulong first, int count)
    {
        var depths = new List<float>();
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
            if (profile.Legs != null)
            {
                depths.Add(new MotionCourse(CourseScripts.Runner(profile, 12f), CourseGround.Stairs, CourseRate.Of(60f)).Run(profile).Penetration!.Value);
            }
        }

        Assert.True(depths.Average() < 0.1f, $"{string.Join(", ", depths)} leg lengths");
    }

    private static float Depth(CourseSimulation simulation, FootSkin skin, Matrix4x4[] matrices)
    {
        float depth = 0f;
        for (int v = 0; v < skin.Count; v++)
        {
            Vector3 place = simulation.Animator.Root.ToWorld(skin.At(v, matrices));
            depth = Math.Max(depth, simulation.Surface.HeightAt(place, Lookout * simulation.Animator.Profile.LegLength) is float height ? height - place.Y : 0f);
        }

        return depth;
    }
}
