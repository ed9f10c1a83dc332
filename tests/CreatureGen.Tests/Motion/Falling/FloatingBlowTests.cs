using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Blows to what air or water carries.</summary>
public sealed class FloatingBlowTests
{
    private const float Frame = 1f / 60f;

    /// <summary>It was carried off as stiff as a board.</summary>
    [Theory]
    [InlineData(RequestedKind.Swimming)]
    [InlineData(RequestedKind.Flying)]
    public void A_blow_to_the_head_turns_what_floats_away_from_it_and_it_rights_itself(RequestedKind kind)
    {
        int struck = 0;
        for (ulong seed = 9972000; seed < 9972000 + (ulong)Thoroughness.Of(36); seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
            Vector2[] left = Turned(profile, -1f);
            Vector2[] right = Turned(profile, 1f);
            float away = left.Max(turn => Math.Abs(turn.X));
            Assert.True(away > 0.03f, $"{seed} {profile.Subject.Plan} {profile.Subject.Mass.Mass} kg {profile.Fall.Value.Height} m: yaws by {away} rad, rolls by {left.Max(turn => Math.Abs(turn.Y))}");
            Assert.True(left.Max(turn => Math.Abs(turn.Y)) is > 0.05f and < 0.6f, $"{seed}: rolls by {left.Max(turn => Math.Abs(turn.Y))} rad");
            Vector2 first = left[6];
            Assert.True(first.X * right[6].X < 0f && first.Y * right[6].Y < 0f, $"{seed}: {first} and {right[6]}");
            Assert.True(left[^1].Length() < 0.01f, $"{seed}: {left[^1]} is left");
            struck++;
        }

        Assert.True(struck > 10);
    }

    /// <summary>How far the whole body is yawed and rolled by a blow, frame by frame, beside one that nothing hits.</summary>
    private static Vector2[] Turned(MotionProfile profile, float side)
    {
        CreatureAnimator struck = Afloat(profile);
        CreatureAnimator calm = Afloat(profile);
        Skeleton skeleton = profile.Subject.Skeleton;
        int body = skeleton.FirstOf(JointRole.Body);
        float speed = MathF.Sqrt(9.81f * profile.Fall.Value.Height);
        struck.Hit(skeleton.FirstOf(JointRole.Head), new Vector3(0.3f * side * speed * profile.Subject.Mass.Mass, 0f, 0f));
        return Enumerable.Range(0, 600).Select(_ =>
        {
            struck.Update(Frame, Hovers, FlatGround.Level);
            calm.Update(Frame, Hovers, FlatGround.Level);
            Quaternion turn = Rotation.Multiply(struck.ModelPose.Rotations[body], Rotation.Inverse(calm.ModelPose.Rotations[body]));
            return new Vector2(2f * turn.Y, 2f * turn.Z) * MathF.Sign(turn.W);
        }).ToArray();
    }

    private static CreatureAnimator Afloat(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(new RootPlace(new Vector3(0f, 60f, 0f), Quaternion.Identity), FlatGround.Level);
        for (int i = 0; i < 240; i++)
        {
            animator.Update(Frame, Hovers, FlatGround.Level);
        }

        return animator;
    }

    private static MotionInput Hovers => new(0f, Medium: MotionMedium.Air);
}
