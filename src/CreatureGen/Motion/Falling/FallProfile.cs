using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking;

namespace CreatureGen.Motion.Falling;

/// <summary>What follows from a creature's build for how it falls, lies and gets up: worked out when it is first needed, immutable, shared by all its animators.</summary>
internal sealed class FallProfile
{
    /// <summary>Step in which the depth of its crouch is looked for, leg lengths, how deep that is at most, and what legs give in any case.</summary>
    private const float CrouchStep = 0.02f;
    private const float MaxCrouch = 0.7f;
    private const float LeastCrouch = 0.06f;

    /// <summary>How far a foot may be from its place in a crouch, and its skin in the ground, leg lengths.</summary>
    private const float MaxMiss = 0.015f;
    private const float MaxSunk = 0.02f;

    /// <summary>Part of a step by which the body has to come down in it: folded legs let it down no farther.</summary>
    private const float MinGain = 0.5f;

    /// <summary>How hard legs of an animal of the usual mass brake a fall, 1/τ with τ = √(ℓ/g); larger ones take less: their legs grow with the second power of their size, their weight with the third.</summary>
    private const float HardestBraking = 3.2f;
    private const float UsualMass = 30f;
    private const double BrakingPower = -0.08;
    private const float LeastFraction = 0.5f;
    private const float GreatestFraction = 1.2f;

    private FallProfile(Creature creature, LeggedBody? legs, GaitSet? gaits)
    {
        Body = Math.Max(creature.Skeleton.IndexOf("Body"), 0);
        Support = SupportPoints.Of(creature);
        if (legs != null)
        {
            CrouchDepth = DepthOf(legs, gaits!, Support);
            Braking = HardestBraking * (float)Scalar.Clamp(PortableMath.Pow(legs.Mass / UsualMass, BrakingPower), LeastFraction, GreatestFraction);
        }
    }

    /// <summary>The joint that carries the body.</summary>
    public int Body { get; }

    /// <summary>What it can lie on.</summary>
    public SupportPoints Support { get; }

    /// <summary>How far the body can be let down into its legs with its feet where they belong, metres of the model; 0 without legs.</summary>
    public float CrouchDepth { get; }

    /// <summary>How hard its legs brake a fall at most, 1/τ with τ = √(ℓ/g).</summary>
    public float Braking { get; }

    /// <summary>Works it out.</summary>
    public static FallProfile Of(Creature creature, LeggedBody? legs, GaitSet? gaits) => new(creature, legs, gaits);

    /// <summary>The deepest crouch that brings the body down, keeps the feet in their places and the skin out of the ground.</summary>
    private static float DepthOf(LeggedBody body, GaitSet gaits, SupportPoints support)
    {
        var legs = new WalkingMode(body, gaits, new EventQueue(0));
        var pose = new PoseBuffer(body.Skeleton);
        MotionSettings settings = MotionSettings.Default;
        settings.Idle = 0f;
        pose.Clear();
        legs.Stand(RootPlace.Identity, settings, FlatGround.Level, pose.Local);
        pose.Finish();
        float start = support.Lowest(pose.Model);
        float height = pose.Model.Positions[body.Trunk[0]].Y;
        float depth = 0f;
        for (int i = 1; i * CrouchStep <= MaxCrouch; i++)
        {
            legs.Sink = i * CrouchStep * body.LegLength;
            pose.Clear();
            legs.Hold(RootPlace.Identity, 0f, settings, pose.Local);
            pose.Finish();
            float miss = 0f;
            for (int foot = 0; foot < legs.FootCount; foot++)
            {
                miss = Math.Max(miss, legs.Report(foot).Residual);
            }

            float now = pose.Model.Positions[body.Trunk[0]].Y;
            float sunk = start - support.Lowest(pose.Model);
            if (miss > MaxMiss * body.LegLength || sunk > MaxSunk * body.LegLength || height - now < MinGain * CrouchStep * body.LegLength)
            {
                break;
            }

            height = now;
            depth = legs.Sink;
        }

        return Math.Max(depth, LeastCrouch * body.LegLength);
    }
}
