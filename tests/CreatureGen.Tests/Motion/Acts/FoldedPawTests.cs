using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Falling;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

/// <summary>Feet of legs that fold under a body: on the ground, on their way and there.</summary>
public sealed class FoldedPawTests
{
    private const float Frame = 1f / 60f;

    /// <summary>These lay on their elbows, and their paws were held .16, .12 and .08 of a leg above the ground ahead of them.</summary>
    [Theory]
    [InlineData(24860111UL)]
    [InlineData(24781017UL)]
    [InlineData(24870005UL, Explicit = true)]
    public void Who_lies_on_its_elbows_has_its_paws_on_the_ground(ulong seed)
    {
        const float MaxHeld = 0.05f;
        float held = float.MaxValue;
        Perform(seed, "lie", animator => held = animator.ActPhase is { Lasts: true } ? MathF.Min(held, Held(animator)) : held);
        Assert.InRange(held, -MaxHeld, MaxHeld);
    }

    /// <summary>Both went up by .15 of a leg at once as it gave way in front: it dropped dead with a hop.</summary>
    [Theory]
    [InlineData(24816009UL)]
    public void Fore_feet_of_who_buckles_stay_near_the_ground(ulong seed)
    {
        const float MaxRaised = 0.1f;
        float raised = 0f;
        Perform(seed, "die", animator => raised = animator.ActPhase is { Name: "buckle" } ? MathF.Max(raised, Raised(animator)) : raised);
        Assert.InRange(raised, 0.001f, MaxRaised);
    }

    /// <summary>How high the ball of the foremost foot is above where it stands, leg lengths.</summary>
    private static float Held(CreatureAnimator animator)
    {
        LyingLeg[] legs = animator.Profile.Fall.Value.Legs;
        return (animator.ModelPose.Positions[legs[0].Rig.Ball].Y - legs[0].Rig.BallHeight) / animator.Profile.LegLength;
    }

    /// <summary>How far all of the foremost leg is above the ground, leg lengths.</summary>
    private static float Raised(CreatureAnimator animator)
    {
        FallProfile profile = animator.Profile.Fall.Value;
        return profile.Support.LowestOfLimb(profile.Legs[0].Rig.Hip, animator.Root, animator.ModelPose, Vector3.UnitY, FlatGround.Level, out _) / animator.Profile.LegLength;
    }

    private static void Perform(ulong seed, string act, Action<CreatureAnimator> look)
    {
        var animator = new CreatureAnimator(new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking })));
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(animator, 0.5f, 60f, default, FlatGround.Level);
        Assert.Equal(ActStatus.Started, animator.Perform(act).Status);
        for (int i = 0; i < 900; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            look(animator);
        }
    }
}
