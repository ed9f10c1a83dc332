using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class FabrikIkTests
{
    private static readonly int[] chain = [0, 1, 2, 3, 4, 5, 6];
    private static readonly Skeleton skeleton = MovingPose.Chain(6, 1f, JointLimit.Free);

    [Fact]
    public void Beyond_its_length_the_chain_stretches_towards_the_target_and_says_so()
    {
        MovingPose pose = new(skeleton);
        IkResult result = FabrikIk.Apply(skeleton, chain, new Vector3(0f, 6f, 8f), 50, 1e-3f, pose.Local, pose.Model);
        Assert.Equal(IkStatus.TooFar, result.Status);
        Assert.Equal(4f, result.Residual, 2);
    }

    [Fact]
    public void A_chain_that_is_straight_in_line_with_its_target_folds_to_it()
    {
        MovingPose pose = new(skeleton);
        IkResult result = FabrikIk.Apply(skeleton, chain, new Vector3(0f, 3f, 0f), 40, 1e-3f, pose.Local, pose.Model);
        Assert.True(result.Reached, $"{result}");
    }

    [Fact]
    public void It_bends_a_free_chain_more_evenly_than_coordinate_descent()
    {
        MovingPose even = new(skeleton);
        MovingPose curled = new(skeleton);
        var target = new Vector3(0f, 2f, 3.2f);
        Assert.True(FabrikIk.Apply(skeleton, chain, target, FabrikIk.UsualRounds, 1e-3f, even.Local, even.Model).Reached);
        Assert.True(CcdIk.Apply(skeleton, chain, target, new CcdSettings(16, 1e-3f, 3.1f), curled.Local, curled.Model).Reached);
        Assert.True(SharpestBend(even) < SharpestBend(curled));

        static double SharpestBend(MovingPose pose)
        {
            double most = 0;
            for (int k = 1; k < 6; k++)
            {
                most = Math.Max(most, Rotation.Angle(pose.LocalRotations[k]));
            }

            return most;
        }
    }

    [Fact]
    public void A_gap_in_the_chain_and_numbers_that_are_none_are_told_and_nothing_is_allocated()
    {
        MovingPose pose = new(skeleton);
        Assert.Throws<ArgumentException>(() => FabrikIk.Apply(skeleton, [0, 2], Vector3.One, 16, 1e-3f, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => FabrikIk.Apply(skeleton, chain, new Vector3(float.NaN), 16, 1e-3f, pose.Local, pose.Model));
        Assert.Throws<ArgumentOutOfRangeException>(() => FabrikIk.Apply(skeleton, chain, Vector3.One, 0, 1e-3f, pose.Local, pose.Model));
        Assert.Equal(0, MovingPose.Allocated(() => FabrikIk.Apply(skeleton, chain, new Vector3(0f, 1f, 2f), 16, 1e-3f, pose.Local, pose.Model)));
    }
}
