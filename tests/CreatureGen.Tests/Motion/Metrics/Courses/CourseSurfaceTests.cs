using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

public sealed class CourseSurfaceTests
{
    [Fact]
    public void Rays_from_any_side_meet_hills_where_straight_ones_do()
    {
        var hills = new EndlessHills(new Seed(3), 0.8f);
        RandomStream random = new Seed(4).Stream();
        for (int i = 0; i < 200; i++)
        {
            var origin = new Vector3((float)random.Uniform(-90, 90), 1f, (float)random.Uniform(-90, 90));
            var direction = Vector3.Normalize(new Vector3((float)random.Uniform(-0.5, 0.5), -1f, (float)random.Uniform(-0.5, 0.5)));
            Assert.True(hills.Cast(origin, direction, 5f, out GroundHit hit));
            Assert.True(hills.Cast(hit.Point + Vector3.UnitY, -Vector3.UnitY, 2f, out GroundHit below));
            Assert.Equal(below.Point.Y, hit.Point.Y, 1e-4f);
            Assert.Equal(1f, hit.Normal.Length(), 1e-4f);
            Assert.InRange(hit.Point.Y, -0.15f * 0.8f, 0.15f * 0.8f);
            Assert.False(hills.Cast(origin, direction, 0.3f, out _));
            Assert.False(hills.Cast(origin, -direction, 50f, out _));
        }

        // In the ground a ray is at once at its surface.
        Assert.True(hills.Cast(new Vector3(2f, -3f, 1f), Vector3.UnitY, 0.1f, out GroundHit inside));
        Assert.True(hills.Cast(new Vector3(2f, 3f, 1f), -Vector3.UnitY, 9f, out GroundHit above));
        Assert.Equal(above, inside);
    }

    [Fact]
    public void Stairs_rise_by_steps_and_are_not_there_from_below()
    {
        MeshGround stairs = new GroundProfile(2f, -3f).Floor(4f).Flight(30, 0.5f, 0.2f).Floor(3f).Flight(30, 0.5f, -0.2f).ToGround();
        Assert.Equal(0f, Height(stairs, 0.99f));
        Assert.Equal(0.2f, Height(stairs, 1.01f), 1e-5f);
        Assert.Equal(0.2f, Height(stairs, 1.49f), 1e-5f);
        Assert.Equal(0.6f, Height(stairs, 2.01f), 1e-5f);
        Assert.Equal(6f, Height(stairs, 16.5f), 1e-4f);
        Assert.Equal(5.8f, Height(stairs, 19.1f), 1e-4f);
        Assert.False(stairs.Cast(new Vector3(0f, -1f, 1.2f), Vector3.UnitY, 9f, out _));

        // Risers are met from the side of the lower tread, going up and going down.
        Assert.True(stairs.Cast(new Vector3(0f, 0.1f, 0f), Vector3.UnitZ, 2f, out GroundHit up));
        Assert.Equal(1f, up.Point.Z, 1e-5f);
        Assert.True(stairs.Cast(new Vector3(0f, 5.9f, 19.2f), -Vector3.UnitZ, 2f, out GroundHit down));
        Assert.Equal(19f, down.Point.Z, 1e-4f);
    }

    [Fact]
    public void What_is_just_inside_a_riser_is_hardly_in_the_ground_and_what_is_below_a_floor_is_as_deep_as_it_lies()
    {
        var surface = new CourseSurface(new GroundProfile(5f, -3f).Floor(4f).Flight(3, 0.5f, 0.2f).Floor(3f).ToGround());
        Assert.Equal(0.0125f, surface.DepthOf(new Vector3(0f, 0.05f, 1.01f), 0.15f, 9f), 0.01f);
        Assert.Equal(0.15f, surface.DepthOf(new Vector3(0f, 0.05f, 1.25f), 0.15f, 9f), 1e-5f);
        Assert.Equal(0.08f, surface.DepthOf(new Vector3(0f, -0.08f, -1f), 0.08f, 9f), 1e-5f);

        // A sole a hair below its tread is as deep as its toes are in the riser.
        Assert.Equal(0.05f, surface.DepthOf(new Vector3(0f, -0.0001f, 1.05f), 0.2001f, 9f), 0.013f);
    }

    [Fact]
    public void Ramps_join_floors_and_gaps_have_no_ground()
    {
        MeshGround ground = new GroundProfile(2f, 0f).Floor(1f).Ramp(2f, 1f).Gap(0.5f).Floor(1f).Riser(-1f).Floor(1f).ToGround();
        Assert.Equal([0f, 0.25f, 1f, 0f], new[] { 0.5f, 1.5f, 4f, 5f }.Select(z => Height(ground, z)));
        Assert.True(float.IsNaN(Height(ground, 3.25f)));
        Assert.Equal(4.5f, new GroundProfile(2f, 0f).Until(4f, line => line.Floor(1.5f)).Z);
    }

    [Fact]
    public void The_lift_starts_at_rest_and_its_axes_go_along()
    {
        var lift = new LiftSurface(2f);
        Assert.Equal(0f, lift.HeightAt(new Vector3(5f, 0f, 5f), 10f));
        lift.Advance(1e-3);
        Assert.True(Math.Abs(lift.HeightAt(Vector3.Zero, 10f)!.Value) < 1e-5f);
        for (int i = 0; i < 100; i++)
        {
            lift.Advance(0.02);
            RootPlace frame = lift.Frame;
            Assert.Equal(frame.Position.Y, lift.HeightAt(new Vector3(7f, 0f, -3f), 10f)!.Value, 1e-5f);
            Assert.True(((IMovingGround)lift.Ground).TryLocate(1, out RootPlace found));
            Assert.Equal(frame, found);
        }

        Assert.True(lift.Frame.Position.Length() > 0.1f);
    }

    private static float Height(IGround ground, float z) => ground.Cast(new Vector3(0f, 20f, z), -Vector3.UnitY, 40f, out GroundHit hit) ? hit.Point.Y : float.NaN;
}
