using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Limbs;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

/// <summary>Outlines of legs as they are seen: no posts, and no legs before the face.</summary>
public sealed class LegOutlineTests
{
    /// <summary>Greatest radius of the narrowest row below the knee, relative to the knee's (.80 of a post) and to that of the foot (.76).</summary>
    private const double Narrow = 0.72;
    private const double BelowFoot = 0.65;

    /// <summary>Most of the arched walkers whose leg stands before an eye as they are seen from the side (2 of 60 where they were not turned back).</summary>
    private const double Covered = 0.02;

    public static TheoryData<LimbArchetype> Standing() => new()
    {
        LimbArchetype.Theropod, LimbArchetype.Bird, LimbArchetype.DigitigradeHind, LimbArchetype.DigitigradeFore,
        LimbArchetype.PlantigradeHind, LimbArchetype.PlantigradeFore, LimbArchetype.UnguligradeHind, LimbArchetype.UnguligradeFore, LimbArchetype.Column,
    };

    [Theory]
    [MemberData(nameof(Standing))]
    public void A_leg_under_the_body_has_a_calf_a_narrow_shank_and_a_broader_foot(LimbArchetype archetype)
    {
        LegOutline outline = LegKinds.Of(archetype).Outline;
        LegSection[] shank = outline.Rows.Skip(outline.KneeRow + 1).Take(outline.BallRow - outline.KneeRow - 1).ToArray();
        double narrowest = shank.Min(row => row.SideRadius);
        double knee = outline.Rows[outline.KneeRow].SideRadius;
        Assert.True(narrowest <= Narrow * knee, FormattableString.Invariant($"a shank of {narrowest / knee:0.00} of the knee"));
        Assert.True(narrowest <= BelowFoot * outline.Rows[^1].SideRadius, FormattableString.Invariant($"a shank of {narrowest / outline.Rows[^1].SideRadius:0.00} of the foot"));

        double calf = outline.Rows[outline.KneeRow + 1].SideRadius;
        double straight = (knee + outline.Rows[outline.AnkleRow].SideRadius) / 2;
        Assert.True(archetype is LimbArchetype.Bird or LimbArchetype.UnguligradeFore or LimbArchetype.UnguligradeHind || calf > 1.1 * straight, FormattableString.Invariant($"a calf of {calf}, {straight} without one"));
    }

    /// <summary>Broader beside their socket than the socket itself, legs of insects met in lumps on the thorax.</summary>
    [Fact]
    public void Legs_of_insects_are_no_broader_beside_their_socket_than_the_socket()
    {
        const float Half = 0.1f;
        LegKind kind = LegKinds.Of(LimbArchetype.Insect);
        foreach (LegOutline outline in new[] { kind.Outline, kind.Trailing! })
        {
            float thickest = outline.Thickness(wanted: 1f, Half, height: 1f);
            Assert.True(outline.Rows[1].ForeRadius / 1000f * thickest <= Half, FormattableString.Invariant($"{outline.Rows[1].ForeRadius / 1000f * thickest / Half:0.00} of it"));
        }
    }

    [Theory]
    [InlineData(LimbArchetype.Theropod)]
    [InlineData(LimbArchetype.Bird)]
    [InlineData(LimbArchetype.DigitigradeHind)]
    [InlineData(LimbArchetype.UnguligradeHind)]
    [InlineData(LimbArchetype.UnguligradeFore)]
    public void A_hock_or_wrist_stands_out_below_a_thinner_shank(LimbArchetype archetype)
    {
        LegOutline outline = LegKinds.Of(archetype).Outline;
        double joint = outline.Rows[outline.AnkleRow].SideRadius;
        double above = outline.Rows[outline.AnkleRow - 1].SideRadius;
        Assert.True(joint > 1.12 * above, FormattableString.Invariant($"{joint / above:0.00} of what is above it"));
    }

    [Theory]
    [InlineData(LimbArchetype.Insect)]
    [InlineData(LimbArchetype.Raptorial)]
    public void A_jointed_leg_is_drawn_in_at_its_root_and_at_its_knee(LimbArchetype archetype)
    {
        LegOutline outline = LegKinds.Of(archetype).Outline;
        int knee = archetype == LimbArchetype.Insect ? outline.KneeRow : outline.AnkleRow;
        double thigh = outline.Rows.Skip(2).Take(knee - 2).Max(row => row.ForeRadius);
        Assert.True(outline.Rows.Take(knee - 1).Min(row => row.ForeRadius) < 0.75 * thigh, "a thigh that is a pipe from its root on");
        Assert.True(outline.Rows[knee].ForeRadius < 0.5 * thigh, "a knee as thick as its thigh");
    }

    [Fact]
    public void The_arms_of_a_mantis_have_spines_that_shut_on_one_another()
    {
        CreatureBlueprint mantis = BlueprintSampler.Sample(23371100, SpeciesSubject.Only("mantis", RequestedKind.Walking));
        DigitTip[] spines = GrownSurface.Grow(mantis).Tips.Where(tip => tip.ClawLength == 5f).ToArray();
        Assert.True(spines.Length >= 6, $"{spines.Length} spines");
        Assert.Contains(spines, spine => spine.Direction.Z > 0.5f);
        Assert.Contains(spines, spine => spine.Direction.Z < -0.5f);
    }

    [Fact]
    public void A_jointed_leg_has_a_thigh_twice_as_thick_as_all_of_its_shank()
    {
        LegOutline outline = LegKinds.Of(LimbArchetype.Insect).Outline;
        double thigh = outline.Rows.Skip(1).Take(outline.KneeRow - 1).Min(row => row.SideRadius);
        Assert.All(outline.Rows.Skip(outline.KneeRow + 1).Take(outline.BallRow - outline.KneeRow), row => Assert.True(thigh >= 2 * row.SideRadius, $"{thigh} over {row.SideRadius}"));
    }

    [Fact]
    public void Few_arched_legs_stand_before_an_eye()
    {
        int covered = 0;
        int bodies = 0;
        for (ulong seed = 15040000; bodies < 60; seed++)
        {
            CreatureBlueprint walker = BlueprintSampler.Sample(seed, new CreatureOptions { Kind = RequestedKind.Walking, Strangeness = seed % 2 == 0 ? 1 : 0.6 });
            if (!walker.Legs.Any(leg => leg.Archetype == LimbArchetype.Insect))
            {
                continue;
            }

            Creature creature = CreatureGenerator.Build(walker);
            if (EyeOf(creature) is int eye)
            {
                bodies++;
                covered += Covers(creature, eye) ? 1 : 0;
            }
        }

        Assert.True(covered <= Covered * bodies, $"{covered} of {bodies}");
    }

    private static int? EyeOf(Creature creature) => Enumerable.Range(0, creature.Skeleton.Joints.Count)
        .Where(j => creature.Skeleton.Joints[j].Role == JointRole.Eye && creature.Skeleton.ModelPositions[j].X > 0)
        .Select(j => (int?)j)
        .FirstOrDefault();

    private static bool Covers(Creature creature, int eye)
    {
        Vector3[] at = creature.Skeleton.ModelPositions.ToArray();
        Vector2 pupil = new(at[eye].Z, at[eye].Y);
        foreach (LimbChain leg in creature.Limbs.Where(limb => limb.Side == Side.Left && limb.Archetype is LimbArchetype.Insect or LimbArchetype.Raptorial))
        {
            for (int k = 2; k < leg.Joints.Count; k++)
            {
                Vector3 a = at[leg.Joints[k - 1]];
                Vector3 b = at[leg.Joints[k]];
                if (a.X > at[eye].X && Distance(pupil, new Vector2(a.Z, a.Y), new Vector2(b.Z, b.Y)) < 0.025f)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static float Distance(Vector2 p, Vector2 a, Vector2 b)
    {
        Vector2 line = b - a;
        float t = Math.Clamp(Vector2.Dot(p - a, line) / Math.Max(line.LengthSquared(), 1e-9f), 0f, 1f);
        return Vector2.Distance(p, a + (t * line));
    }
}
