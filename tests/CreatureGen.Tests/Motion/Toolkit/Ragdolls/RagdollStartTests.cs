using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ragdolls;

public sealed class RagdollStartTests
{
    /// <summary>A creature that turned left by 0.1 in 0.1 s goes on turning left by 1 rad/s.</summary>
    [Fact]
    public void A_turning_creature_falls_with_the_spin_that_it_had()
    {
        Creature creature = CreatureGenerator.Generate(42);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var high = new Vector3(0f, 50f, 0f);
        var now = new RootPlace(high, Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.1f));
        Ragdoll.Start(rig, state, now, pose.Model, new RootPlace(high, Quaternion.Identity), pose.Model, 0.1f, FlatGround.Level);
        Assert.All(state.Spins.ToArray(), spin => Assert.True(Vector3.Distance(spin, Vector3.UnitY) < 0.01f, $"{spin}"));
    }

    [Fact]
    public void Friction_ends_a_slide()
    {
        float smooth = Slide(0f);
        float rough = Slide(1.5f);
        Assert.True(smooth > 1.5f, $"{smooth}");
        Assert.True(rough < 0.8f * smooth && rough > 0f, $"{rough} of {smooth}");
    }

    /// <summary>How far along +X a lying creature gets in a second from 3 m/s.</summary>
    private static float Slide(float friction)
    {
        Creature creature = CreatureGenerator.Generate(42);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(Vector3.Zero, Quaternion.Identity);
        Ragdoll.Start(rig, state, root, pose.Model, new RootPlace(new Vector3(-0.3f, 0f, 0f), Quaternion.Identity), pose.Model, 0.1f, FlatGround.Level);
        float start = Middle(state);
        for (int i = 0; i < 60; i++)
        {
            Ragdoll.Advance(rig, state, new RagdollSettings(new Vector3(0f, -9.81f, 0f), 12f, 0f, friction), FlatGround.Level, 1f / 60f);
        }

        return Middle(state) - start;
    }

    private static float Middle(RagdollState state) => state.Anchor.X + state.Positions.ToArray().Average(p => p.X);
}
