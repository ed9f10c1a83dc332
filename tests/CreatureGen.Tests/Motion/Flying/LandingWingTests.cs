using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>Wings that beat close to the ground.</summary>
public sealed class LandingWingTests
{
    private const int Rate = 60;

    /// <summary>Three whose last downstrokes went as deep into the ground as .13, .04 and .03 of half their span.</summary>
    [Theory]
    [InlineData(10080016)]
    [InlineData(10080017)]
    [InlineData(10080019)]
    public void Wings_of_a_flier_that_comes_down_keep_off_the_ground(ulong seed)
    {
        Creature creature = KeptCreatures.Of(seed);
        var animator = new CreatureAnimator(creature);
        var ground = new FlatGround(Vector3.Zero, Vector3.UnitY);
        animator.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), ground);
        var joints = new HashSet<int>(creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing).SelectMany(limb => limb.Joints));
        int[] skin = Enumerable.Range(0, creature.Mesh.Positions.Length).Where(v => joints.Contains(creature.Mesh.Weights[v].Joint0)).ToArray();
        float half = skin.Max(v => creature.Mesh.Positions[v].X);
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        float cruise = creature.DefaultSpeed;
        Go(1.5f, new MotionInput(cruise, ClimbRate: 0.5f * cruise, Medium: MotionMedium.Air));
        Go(1.5f, new MotionInput(cruise, Medium: MotionMedium.Air));
        Go(0.5f, new MotionInput(cruise, ClimbRate: -0.3f * cruise));
        float lowest = Go(3f, new MotionInput(0f, ClimbRate: -0.3f * cruise));
        Assert.InRange(animator.Root.Position.Y, -0.01f, 0.01f);
        Assert.True(lowest > -0.01f * half, FormattableString.Invariant($"{seed}: {lowest} m, half of the span is {half} m"));

        float Go(float seconds, MotionInput input)
        {
            float low = float.MaxValue;
            for (int i = 0; i < seconds * Rate; i++)
            {
                animator.Update(1f / Rate, input, ground);
                SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
                low = Math.Min(low, animator.Root.Position.Y + skin.Min(v => Height(creature.Mesh.Positions[v], creature.Mesh.Weights[v])));
            }

            return low;
        }

        float Height(Vector3 p, SkinWeights w) =>
            (Vector3.Transform(p, matrices[w.Joint0]).Y * w.Weights.X) + (Vector3.Transform(p, matrices[w.Joint1]).Y * w.Weights.Y) + (Vector3.Transform(p, matrices[w.Joint2]).Y * w.Weights.Z) + (Vector3.Transform(p, matrices[w.Joint3]).Y * w.Weights.W);
    }

    [Fact]
    public void Wings_beat_as_they_do_where_there_is_room_below_them()
    {
        Assert.Equal(0, WingFloor.Lift(shoulder: 2, reach: 1, lowest: 0.6));
        double last = 0;
        for (double shoulder = 1; shoulder >= 0; shoulder -= 0.05)
        {
            double lift = WingFloor.Lift(shoulder, 1, 0.6);
            Assert.InRange(lift, last, 0.6);
            last = lift;
        }

        Assert.InRange(last, 0.59, 0.6);
    }
}
