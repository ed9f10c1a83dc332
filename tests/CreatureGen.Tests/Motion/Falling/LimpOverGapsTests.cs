using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Limp bodies whose parts fall into gaps and are carried under the far edge.</summary>
public sealed class LimpOverGapsTests
{
    /// <summary>Balls found deep below the edge were once brought out within one substep, and the body flew up to three legs high: runners as they were then (<see cref="KeptCreatures"/>).</summary>
    [Theory]
    [InlineData(9990004)]
    [InlineData(9990010, Explicit = true)]
    [InlineData(9990022, Explicit = true)]
    [InlineData(9990030, Explicit = true)]
    public void A_runner_that_goes_limp_over_gaps_is_not_flung_up_by_their_edges(ulong seed)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        var ground = new Gaps(profile.LegLength);
        var input = new MotionInput(profile.Gaits!.Speeds[^1].Comfortable);
        for (int moment = 0; moment < 6; moment++)
        {
            var animator = new CreatureAnimator(profile);
            for (int i = 0; i < 150 + (7 * moment); i++)
            {
                animator.Update(1f / 60f, input, ground);
            }

            float before = Height(animator);
            float highest = before;
            animator.GoLimp();
            for (int i = 0; i < 120; i++)
            {
                animator.Update(1f / 60f, input, ground);
                highest = Math.Max(highest, Height(animator));
            }

            Assert.True(highest - before < 0.5f * profile.LegLength, $"moment {moment}: {(highest - before) / profile.LegLength} leg lengths up");
        }
    }

    /// <summary>Mean height of the joints, metres.</summary>
    private static float Height(CreatureAnimator animator)
    {
        Vector3 sum = Vector3.Zero;
        foreach (Vector3 position in animator.ModelPose.Positions)
        {
            sum += position;
        }

        Vector3 mean = sum / animator.ModelPose.Positions.Length;
        return animator.Root.Position.Y + (animator.Root.Scale * Vector3.Transform(mean, animator.Root.Rotation).Y);
    }

    /// <summary>Level ground at height 0 with a gap across the way every 2.2 leg lengths.</summary>
    private sealed class Gaps(float leg) : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            hit = default;
            float along = direction.Y < 0f ? -origin.Y / direction.Y : -1f;
            if (!(along >= 0f && along <= distance))
            {
                return false;
            }

            Vector3 point = origin + (along * direction);
            float place = point.Z / (2.2f * leg);
            if (place - MathF.Floor(place) < 0.4f / 2.2f)
            {
                return false;
            }

            hit = new GroundHit(point, Vector3.UnitY);
            return true;
        }
    }
}
