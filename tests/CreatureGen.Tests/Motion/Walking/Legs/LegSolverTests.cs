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
                    float before = Height(leg, held);
                    float asked = before + (0.3f * leg.Length * (i % 5) / 5f);
                    LegRotations after = held;
                    LegSolver.Raise(leg, leg.Parts, asked, 0f, ref after);
                    float height = Height(leg, after);
                    Assert.True(height > before - (Tolerance * leg.Length), $"{seed}: lowered from {before} to {height}");
                    Assert.True(height < asked + (Tolerance * leg.Length), $"{seed}: raised to {height}, asked {asked}");
                    double cosine = Math.Cos(after.KneeTurn);
                    double sine = Math.Sin(after.KneeTurn);
                    Assert.True(leg.KneeFold.Clamp(ref cosine, ref sine, 0f) < 1e-3f, $"{seed}: the knee is beyond its limits");
                    raised += height > before + (0.05f * leg.Length) ? 1 : 0;
                }
            }
        }

        Assert.True(raised > 100, $"only {raised} were raised");
    }

    [Fact]
    public void An_end_that_is_high_enough_stays_where_it_is()
    {
        LegRig leg = new MotionProfile(Walkers.Any(42)).Legs!.Legs[0];
        LegRotations held = Held(leg, 0.3f);
        LegRotations after = held;
        LegSolver.Raise(leg, leg.Parts, Height(leg, held) - 0.01f, 0f, ref after);
        Assert.Equal(held.Knee, after.Knee);
    }

    /// <summary>A leg at rest with its thigh swung by an angle.</summary>
    private static LegRotations Held(LegRig leg, float angle)
    {
        LegSolver.Solve(leg, leg.Parts, leg.Parts.Upper + leg.Shank, leg.Hinge, 0f, 0f, out LegRotations turns);
        turns.Thigh = Rotation.Multiply(Rotation.FromAxisAngle(leg.Hinge, angle), turns.Thigh);
        turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
        return turns;
    }

    private static float Height(LegRig leg, in LegRotations turns) => (Rotation.Rotate(turns.Thigh, leg.Parts.Upper) + Rotation.Rotate(turns.Shank, leg.Shank)).Y;
}
