using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Legs;

public sealed class LegSolverTests
{
    private const float Tolerance = 1e-4f;

    [Fact]
    public void A_leg_whose_thigh_is_held_bends_its_knee_until_its_end_is_as_high_as_asked_or_the_knee_ends()
    {
        int raised = 0;
        foreach (ulong seed in new ulong[] { 3, 9, 42, 101, 125 })
        {
            foreach (LegRig leg in new MotionProfile(Walkers.Any(seed)).Legs!.Legs)
            {
                for (int i = 0; i < 50; i++)
                {
                    LegRotations held = Held(leg, (0.04f * i) - 1f);
                    var away = new Vector3(0f, 1f, 0.4f * ((i % 3) - 1));
                    float before = Vector3.Dot(away, End(leg, held));
                    float asked = before + (0.3f * leg.Length * (i % 5) / 5f);
                    LegRotations after = held;
                    LegSolver.Raise(leg, leg.Parts, away, asked, 0f, ref after);
                    float height = Vector3.Dot(away, End(leg, after));
                    Assert.True(height > before - (Tolerance * leg.Length), $"{seed}: lowered from {before} to {height}");
                    Assert.True(height < asked + (Tolerance * leg.Length), $"{seed}: raised to {height}, asked {asked}");
                    double cosine = Math.Cos(after.KneeTurn);
                    double sine = Math.Sin(after.KneeTurn);
                    Assert.True(leg.Limits.Knee.Clamp(ref cosine, ref sine, 0f) < 1e-3f, $"{seed}: the knee is beyond its limits");
                    raised += height > before + (0.05f * leg.Length) ? 1 : 0;
                }
            }
        }

        Assert.True(raised > 100, $"only {raised} were raised");
    }

    /// <summary>It flipped from one side of the place below the knee to the other, by up to the whole of what is too low.</summary>
    [Fact]
    public void A_knee_that_opens_goes_through_what_is_too_low_without_a_leap()
    {
        const float Step = 0.01f;
        int passed = 0;
        foreach (ulong seed in new ulong[] { 3, 9, 42, 101, 125 })
        {
            foreach (LegRig leg in new MotionProfile(Walkers.Any(seed)).Legs!.Legs)
            {
                foreach (float swung in new[] { -1.2f, -0.8f, 0.8f, 1.2f })
                {
                    float? last = null;
                    for (int i = -314; i < 314; i++)
                    {
                        double cosine = Math.Cos(Step * i);
                        double sine = Math.Sin(Step * i);
                        if (leg.Limits.Knee.Clamp(ref cosine, ref sine, 0f) != 0)
                        {
                            continue;
                        }

                        LegRotations turns = Held(leg, swung);
                        turns.Knee = Rotation.FromAxisAngle(leg.Hinge, Step * i);
                        turns.KneeHalfSine = MathF.Sin(0.5f * Step * i);
                        turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
                        float free = Height(leg, turns);
                        LegSolver.Raise(leg, leg.Parts, Vector3.UnitY, Rotation.Rotate(turns.Thigh, leg.Parts.Upper).Y - (0.7f * leg.Shank.Length()), 0f, ref turns);
                        Assert.True(Math.Abs(turns.KneeTurn - (last ?? turns.KneeTurn)) < 5f * Step, $"{seed}: the knee leaps from {last} to {turns.KneeTurn}");
                        last = turns.KneeTurn;
                        passed += Height(leg, turns) > free + (0.02f * leg.Length) ? 1 : 0;
                    }
                }
            }
        }

        Assert.True(passed > 100, $"only {passed} were raised");
    }

    [Fact]
    public void An_end_that_is_high_enough_stays_where_it_is()
    {
        LegRig leg = new MotionProfile(Walkers.Any(42)).Legs!.Legs[0];
        LegRotations held = Held(leg, 0.3f);
        LegRotations after = held;
        LegSolver.Raise(leg, leg.Parts, Vector3.UnitY, Height(leg, held) - 0.01f, 0f, ref after);
        Assert.Equal(held.Knee, after.Knee);
    }

    [Fact]
    public void A_leg_whose_thigh_is_held_brings_its_end_as_near_to_its_target_as_any_bend_of_its_knee_does()
    {
        int moved = 0;
        foreach (ulong seed in new ulong[] { 3, 9, 42, 101, 125 })
        {
            foreach (LegRig leg in new MotionProfile(Walkers.Any(seed)).Legs!.Legs)
            {
                for (int i = 0; i < 20; i++)
                {
                    // Targets around where its end is, none within a shank of the knee.
                    LegRotations held = Held(leg, (0.1f * i) - 1f);
                    Vector3 target = End(leg, held) + (leg.Length * new Vector3(0.05f * (i % 3), 0.1f * (i % 4), 0.15f * ((i % 5) - 2)));
                    Vector3 knee = Rotation.Rotate(held.Thigh, leg.Parts.Upper);
                    if (Vector3.Distance(knee, target) < leg.Shank.Length())
                    {
                        continue;
                    }

                    LegRotations after = held;
                    LegSolver.Bend(leg, leg.Parts, target, 0f, ref after);
                    float miss = Vector3.Distance(End(leg, after), target);
                    float least = NearestOfAll(leg, held, target);
                    Assert.True(miss <= least + (1e-3f * leg.Length), $"{seed}: {miss} from its target, a search came to {least}");
                    moved += Vector3.Distance(End(leg, held), target) > miss + (0.05f * leg.Length) ? 1 : 0;
                }
            }
        }

        Assert.True(moved > 30, $"only {moved} came nearer");
    }

    [Fact]
    public void A_leg_whose_target_is_close_to_its_knee_keeps_its_bend()
    {
        LegRig leg = new MotionProfile(Walkers.Any(42)).Legs!.Legs[0];
        LegRotations held = Held(leg, 0.3f);
        LegRotations after = held;
        LegSolver.Bend(leg, leg.Parts, Rotation.Rotate(held.Thigh, leg.Parts.Upper) + (0.3f * leg.Shank), 0f, ref after);
        Assert.Equal(held.Knee, after.Knee);
    }

    [Fact]
    public void Turns_of_a_leg_are_blended_from_the_one_to_the_other()
    {
        LegRig leg = new MotionProfile(Walkers.Any(42)).Legs!.Legs[0];
        LegRotations one = Held(leg, 0.3f);
        LegRotations other = Held(leg, -0.2f);
        LegSolver.Raise(leg, leg.Parts, Vector3.UnitY, Height(leg, other) + (0.2f * leg.Length), 0f, ref other);
        LegRotations none = one;
        none.Blend(other, 0f, leg.Hinge);
        LegRotations all = one;
        all.Blend(other, 1f, leg.Hinge);
        LegRotations half = one;
        half.Blend(other, 0.5f, leg.Hinge);
        Assert.InRange(Vector3.Distance(End(leg, one), End(leg, none)), 0f, Tolerance * leg.Length);
        Assert.InRange(Vector3.Distance(End(leg, other), End(leg, all)), 0f, Tolerance * leg.Length);
        Assert.InRange(half.KneeTurn, Math.Min(one.KneeTurn, other.KneeTurn), Math.Max(one.KneeTurn, other.KneeTurn));
    }

    /// <summary>How near any turn of the knee within its limits, in steps of a hundredth of a radian, brings the end.</summary>
    private static float NearestOfAll(LegRig leg, LegRotations turns, Vector3 target)
    {
        float least = float.MaxValue;
        for (int i = -314; i < 314; i++)
        {
            double cosine = Math.Cos(0.01 * i);
            double sine = Math.Sin(0.01 * i);
            if (leg.Limits.Knee.Clamp(ref cosine, ref sine, 0f) == 0)
            {
                turns.Knee = Rotation.FromAxisAngle(leg.Hinge, 0.01f * i);
                turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
                least = Math.Min(least, Vector3.Distance(End(leg, turns), target));
            }
        }

        return least;
    }

    [Fact]
    public void A_foot_in_the_air_that_passes_under_its_hip_is_led_past_it_on_the_outer_side_and_its_leg_does_not_whirl()
    {
        int checkedLegs = 0;
        foreach (LegRig leg in new MotionProfile(Walkers.Of(CreatureGen.Anatomy.BodyPlan.Sprawling, 3)).Legs!.Legs)
        {
            float outward = leg.Side == CreatureGen.Anatomy.Side.Left ? 1f : -1f;
            float low = 0.6f * leg.FoldedReach;
            float ground = -low - (leg.Traits.Lift * leg.Length);
            double last = -0.5 * Math.PI;
            for (int i = -300; i <= 300; i++)
            {
                // Back to front, under the hip and a little inward of it: by its angle from straight out.
                var chord = new Vector3(-0.05f * outward * leg.FoldedReach, -low, 0.01f * i * leg.FoldedReach);
                Vector3 led = LegSolver.Outside(leg, Quaternion.Identity, chord, ground, 1f);
                double angle = Math.Atan2(led.Z, led.X * outward);
                Assert.Equal(chord.Y, led.Y, Tolerance);
                Assert.Equal(chord.Z, led.Z, Tolerance);
                Assert.True(Math.Abs(i) > 100 || led.X * outward > 0f, $"{chord} is led inward, to {led}");
                Assert.True(Math.Abs(i) < 200 || led == chord, $"{chord} is led to {led}");
                Assert.True(i == -300 || Math.Abs(angle - last) < 0.02, $"{chord} is led to {led}, {last} rad from straight out before");
                Assert.Equal(chord, LegSolver.Outside(leg, Quaternion.Identity, chord, ground, 0f));
                last = angle;
                checkedLegs++;
            }
        }

        Assert.True(checkedLegs > 0);
    }

    [Fact]
    public void A_foot_that_comes_down_under_its_hip_is_led_back_there_by_turning_about_it()
    {
        LegRig leg = new MotionProfile(Walkers.Of(CreatureGen.Anatomy.BodyPlan.Sprawling, 3)).Legs!.Legs[0];
        float outward = leg.Side == CreatureGen.Anatomy.Side.Left ? 1f : -1f;
        var chord = new Vector3(-0.1f * outward, -0.6f, 0.2f) * leg.FoldedReach;
        double last = Math.Atan2(chord.Z, chord.X * outward);
        for (float fraction = 0f; fraction <= 1f; fraction += 0.01f)
        {
            Vector3 led = LegSolver.Outside(leg, Quaternion.Identity, chord, chord.Y - (leg.Traits.Lift * leg.Length), fraction);
            double angle = Math.Atan2(led.Z, led.X * outward);
            Assert.True(Math.Abs(angle - last) < 0.03, $"{fraction}: from {last} to {angle} rad");
            last = angle;
        }
    }

    [Theory]
    [InlineData(0.975f)]
    [InlineData(0.99f)]
    [InlineData(1.02f)]
    public void A_standing_foot_that_its_leg_does_not_reach_down_to_is_over_its_place(float stretch)
    {
        LegRig leg = new MotionProfile(Walkers.Any(42)).Legs!.Legs[0];
        float distance = (float)Math.Sqrt(Math.Pow(stretch * leg.Parts.Max, 2) + leg.Parts.OffsetSquared);
        Vector3 place = Vector3.Normalize(new Vector3(0.1f, -1f, -0.5f)) * distance;
        LegSolver.Solve(leg, leg.Parts, place, leg.Hinge, 0f, 0f, Vector3.UnitY, out LegRotations stands);
        LegSolver.Solve(leg, leg.Parts, place, leg.Hinge, 0f, 0f, Vector3.Zero, out LegRotations hangs);
        Assert.True(Aside(End(leg, stands), place) < 1e-4f * leg.Length, $"{Aside(End(leg, stands), place)} metres aside");
        Assert.True(Aside(End(leg, hangs), place) > 10f * Aside(End(leg, stands), place));
        Assert.True(End(leg, stands).Y > place.Y);
    }

    private static float Aside(Vector3 end, Vector3 place) => new Vector2(end.X - place.X, end.Z - place.Z).Length();

    /// <summary>A leg at rest with its thigh swung by an angle.</summary>
    private static LegRotations Held(LegRig leg, float angle)
    {
        LegSolver.Solve(leg, leg.Parts, leg.Parts.Upper + leg.Shank, leg.Hinge, 0f, 0f, Vector3.Zero, out LegRotations turns);
        turns.Thigh = Rotation.Multiply(Rotation.FromAxisAngle(leg.Hinge, angle), turns.Thigh);
        turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
        return turns;
    }

    private static Vector3 End(LegRig leg, in LegRotations turns) => Rotation.Rotate(turns.Thigh, leg.Parts.Upper) + Rotation.Rotate(turns.Shank, leg.Shank);

    private static float Height(LegRig leg, in LegRotations turns) => End(leg, turns).Y;
}
