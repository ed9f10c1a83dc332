using System;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Legs of bodies that get up, drawn in under them.</summary>
public sealed class DrawnLegsTests
{
    /// <summary>Feet that were not there yet as it rolled over onto them passed below the body, and it hung in the air over them: by .026 to .047 of its extent.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 18210048UL)]
    [InlineData(RequestedKind.Flying, 20200008UL)]
    [InlineData(RequestedKind.Walking, 20100005UL, Explicit = true)]
    [InlineData(RequestedKind.Flying, 20100013UL, Explicit = true)]
    public void Feet_are_under_the_body_before_it_rolls_over_onto_them(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        CreatureAnimator animator = GettingUpTests.Lying(new MotionProfile(creature));
        animator.GetUp();
        float highest = 0f;
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            highest = Math.Max(highest, GettingUpTests.Lowest(animator));
        }

        Assert.Equal(BodyState.Supported, animator.State);
        Assert.InRange(highest / GettingUpTests.Extent(creature), 0f, 0.025f);
    }
}
