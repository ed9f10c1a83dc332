using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

/// <summary>Acts of what swims. It hung stiff in the water, and slept and flinched without anything that was to be seen.</summary>
public class SwimmerActTests
{
    private const float Rate = 60f;

    [Theory]
    [InlineData(21200009UL)]
    [InlineData(21200018UL)]
    [InlineData(21200005UL, Explicit = true)]
    public void Who_is_startled_in_water_bends_its_back(ulong seed)
    {
        CreatureAnimator animator = Performing(seed, "Flinch");
        float bent = 0f;
        for (int i = 0; i < 0.5f * Rate; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            bent = Math.Max(bent, Bend(animator));
        }

        Assert.InRange(bent, 0.05f, 0.4f);
    }

    [Theory]
    [InlineData(21200009UL)]
    [InlineData(21200018UL)]
    [InlineData(21200010UL, Explicit = true)]
    public void Who_submits_in_water_shows_its_belly(ulong seed)
    {
        CreatureAnimator animator = Performing(seed, "Submit");
        Assert.InRange(UpOf(animator), 0.9f, 1f);
        Walkers.Run(animator, 0.6f * animator.Profile.Acts.Find("Submit").Seconds, Rate, default, FlatGround.Level);
        Assert.InRange(UpOf(animator), 0.2f, 0.8f);
    }

    [Theory]
    [InlineData(21200009UL)]
    [InlineData(21200018UL)]
    [InlineData(21200010UL, Explicit = true)]
    public void Who_sleeps_in_water_hangs_head_down(ulong seed)
    {
        CreatureAnimator animator = Performing(seed, "Sleep");
        float awake = Slope(animator);
        Walkers.Run(animator, animator.Profile.Acts.Find("Sleep").SecondsToLast, Rate, default, FlatGround.Level);
        Assert.InRange(awake - Slope(animator), 0.15f, 1f);
    }

    [Theory]
    [InlineData(21200009UL)]
    [InlineData(21200018UL)]
    public void Who_sniffs_in_water_stoops_with_all_of_its_body(ulong seed)
    {
        CreatureAnimator animator = Performing(seed, "Sniff");
        float level = Slope(animator);
        Walkers.Run(animator, animator.Profile.Acts.Find("Sniff").SecondsToContact!.Value, Rate, default, FlatGround.Level);
        Assert.InRange(level - Slope(animator), 0.15f, 1f);
    }

    [Theory]
    [InlineData(21200009UL)]
    [InlineData(21200018UL)]
    public void Who_dances_in_water_goes_from_side_to_side(ulong seed)
    {
        CreatureAnimator animator = Performing(seed, "Dance");
        ActBody body = animator.Profile.Acts.Body;
        (float left, float right) = (float.MinValue, float.MaxValue);
        for (int i = 0; i < Rate * animator.Profile.Acts.Find("Dance").Seconds; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            float aside = animator.ModelPose.Positions[body.Body].X;
            (left, right) = (Math.Max(left, aside), Math.Min(right, aside));
        }

        Assert.InRange((left - right) / body.Unit, 0.8f, 2f);
    }

    /// <summary>How far the middle of the back is beside the line from its front to its rear, of that line's length at rest.</summary>
    private static float Bend(CreatureAnimator animator)
    {
        ActBody body = animator.Profile.Acts.Body;
        ReadOnlySpan<Vector3> now = animator.ModelPose.Positions;
        int front = body.Spine[0];
        int rear = body.Spine[^1];
        Vector3 aside = Vector3.Cross(Vector3.Normalize(now[front] - now[rear]), now[body.Spine[body.Spine.Length / 2]] - now[rear]);
        return Math.Abs(aside.Y) / Vector3.Distance(body.Skeleton.ModelPositions[front], body.Skeleton.ModelPositions[rear]);
    }

    /// <summary>How far up the back of the trunk is, 1 as it swims.</summary>
    private static float UpOf(CreatureAnimator animator)
    {
        ActBody body = animator.Profile.Acts.Body;
        return Vector3.Transform(Vector3.UnitY, animator.ModelPose.Rotations[body.Body] * Quaternion.Inverse(body.Skeleton.ModelRotations[body.Body])).Y;
    }

    /// <summary>How far the front of the back is above its rear, of the body's length.</summary>
    private static float Slope(CreatureAnimator animator)
    {
        ActBody body = animator.Profile.Acts.Body;
        return (animator.ModelPose.Positions[body.Spine[0]].Y - animator.ModelPose.Positions[body.Spine[^1]].Y) / body.Size;
    }

    private static CreatureAnimator Performing(ulong seed, string act)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, 10f, 0f), Quaternion.Identity), FlatGround.Level);
        Assert.Equal(ActStatus.Started, animator.Perform(profile.Acts.Find(act)).Status);
        return animator;
    }
}
