using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

public class PlaneGroundTests
{
    [Theory]
    [InlineData(0f)]
    [InlineData(0.2f)]
    public void The_promise_of_a_plane_saves_rays_and_changes_nothing_that_is_seen(float slope)
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5));
        var plane = new FlatGround(Vector3.Zero, Vec.Normalize(new Vector3(0f, 1f, slope)));
        var promised = new Promised(plane);
        var felt = new Felt(plane);
        var on = new CreatureAnimator(profile);
        var over = new CreatureAnimator(profile);
        Walkers.Run(on, 3f, 60f, new MotionInput(1.5f, 0.3f), promised);
        Walkers.Run(over, 3f, 60f, new MotionInput(1.5f, 0.3f), felt);

        Assert.True(3 * promised.Rays < felt.Rays, $"{promised.Rays} rays with the promise, {felt.Rays} without");
        for (int joint = 0; joint < profile.Subject.Skeleton.Count; joint++)
        {
            Assert.InRange(Vec.Distance(on.ModelPose.Positions[joint], over.ModelPose.Positions[joint]), 0f, 1e-3f * profile.LegLength);
        }
    }

    private class Felt(IGround ground) : IGround
    {
        public int Rays { get; private set; }

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            Rays++;
            return ground.Cast(origin, direction, distance, out hit);
        }
    }

    private sealed class Promised(FlatGround ground) : Felt(ground), IPlaneGround
    {
        public Vector3 Normal => ground.Normal;
    }
}
