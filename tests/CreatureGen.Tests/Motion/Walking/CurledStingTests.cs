using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Tails with stings as walkers carry them.</summary>
public sealed class CurledStingTests
{
    /// <summary>As it is grown such a tail ends upright, a mast from the front and from behind.</summary>
    [Theory]
    [InlineData(9999067)]
    [InlineData(9999092)]
    [InlineData(24250163)]
    public void On_the_way_the_end_of_a_tail_with_a_sting_is_curled_forward_over_the_back(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var animator = new CreatureAnimator(creature);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        ActBody body = animator.Profile.Acts.Body;
        double standing = EndFromUpright(body, animator);
        Walkers.Run(animator, 4f, 60f, new MotionInput(animator.Profile.Gaits!.Speeds[0].Comfortable), FlatGround.Level);
        double going = EndFromUpright(body, animator);
        Assert.True(going > standing + 0.4, FormattableString.Invariant($"{seed}: its end leans {standing:0.00} rad ahead of upright standing, {going:0.00} on its way"));
    }

    /// <summary>How far the last bone of the tail leans ahead of upright, radians, counted on beyond level.</summary>
    private static double EndFromUpright(ActBody body, CreatureAnimator animator)
    {
        int last = body.Tail.Joints[^1];
        Vector3 rest = body.Skeleton.ModelPositions[last] - body.Skeleton.ModelPositions[body.Tail.Joints[^2]];
        Quaternion turned = Rotation.Multiply(animator.ModelPose.Rotations[last], Rotation.Inverse(body.Skeleton.ModelRotations[last]));
        Vector3 way = Rotation.Rotate(turned, rest);
        return Math.Atan2(way.Z, way.Y);
    }
}
