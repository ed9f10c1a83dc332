using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

public sealed class PlatformRideTests
{
    private const float Rate = 60f;

    /// <summary>A theropod that runs on a platform that turns away under it as it goes farther out: in the air its body was left behind by up to a leg, and its feet came down in the ground.</summary>
    [Fact]
    public void Who_runs_on_a_platform_goes_over_it_as_over_ground_that_rests()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9920010, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var input = new MotionInput(Speed: profile.Gaits!.TopSpeed);
        var still = new CreatureAnimator(profile);
        var taken = new CreatureAnimator(profile);
        var lift = new Lift();
        still.Teleport(RootPlace.Identity, FlatGround.Level);
        taken.Teleport(RootPlace.Identity, lift);
        int aloft = 0;
        for (int i = 1; i <= 4 * Rate; i++)
        {
            float seconds = i / Rate;
            lift.Place = new RootPlace(new Vector3(1.5f, 0.4f, -0.3f) * seconds, AxisRotation.Yaw(0.3f * seconds));
            still.Update(1f / Rate, input, FlatGround.Level);
            taken.Update(1f / Rate, input, lift);
            aloft += taken.Foot(0).Phase == FootPhase.Swing && taken.Foot(1).Phase == FootPhase.Swing ? 1 : 0;
        }

        float apart = Vec.Distance(lift.Place.ToModel(taken.Root.Position), still.Root.Position);
        Assert.True(aloft > 20, $"{aloft} updates in the air");
        Assert.True(apart < 0.05f * profile.LegLength, $"{apart / profile.LegLength} legs from where it is on ground that rests");
    }

    [Fact]
    public void Feet_in_the_air_take_a_body_along_only_where_none_stands()
    {
        var lift = new Lift();
        var feet = new Foot[2];
        for (int i = 0; i < 2; i++)
        {
            var place = new Foothold { Platform = 7, Heading = Quaternion.Identity, Normal = Vector3.UnitY };
            place.Attach(lift);
            feet[i].Plan.From = place;
            feet[i].Plan.To = place;
        }

        feet[0].Plan.Phase = FootPhase.Swing;
        feet[1].Plan.Phase = FootPhase.Stance;
        feet[1].Plan.From.Platform = 0;
        lift.Place = new RootPlace(Vector3.UnitX, Quaternion.Identity);
        Assert.Equal(Vector3.Zero, PlatformRide.Carry(feet, RootPlace.Identity, lift, Vector3.UnitY).Position);

        feet[1] = feet[0];
        lift.Place = new RootPlace(2f * Vector3.UnitX, Quaternion.Identity);
        Assert.Equal(Vector3.UnitX, PlatformRide.Carry(feet, RootPlace.Identity, lift, Vector3.UnitY).Position);
    }

    /// <summary>What a swing goes by stayed where it was in the world: feet came down a part of a leg aside, where their hips ended.</summary>
    [Fact]
    public void Where_a_swing_goes_is_taken_along_with_all_that_is_known_of_it()
    {
        var lift = new Lift();
        var feet = new Foot[1];
        feet[0].Plan.Phase = FootPhase.Swing;
        feet[0].Plan.To = new Foothold { Platform = 7, Heading = Quaternion.Identity, Normal = Vector3.UnitY, Position = Vector3.UnitZ };
        feet[0].Plan.To.Attach(lift);
        (feet[0].Plan.Wanted, feet[0].Plan.Sought) = (Vector3.UnitZ, Vector3.UnitZ);
        lift.Place = new RootPlace(Vector3.UnitX, Quaternion.Identity);
        PlatformRide.Carry(feet, RootPlace.Identity, lift, Vector3.UnitY);
        Assert.Equal(Vector3.UnitX + Vector3.UnitZ, feet[0].Plan.To.Position);
        Assert.Equal(feet[0].Plan.To.Position, feet[0].Plan.Wanted);
        Assert.Equal(feet[0].Plan.To.Position, feet[0].Plan.Sought);
    }
}
