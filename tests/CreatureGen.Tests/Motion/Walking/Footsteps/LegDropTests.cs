using System.Numerics;
using CreatureGen.Motion.Walking.Footsteps;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>How quickly the body comes down for its legs.</summary>
public sealed class LegDropTests
{
    private const float Leg = 0.5f;

    [Fact]
    public void A_body_comes_down_and_up_again_by_no_more_than_three_legs_in_a_second_and_all_the_way()
    {
        var drop = new LegDrop();
        Follow(ref drop, 0.01f, 0f, 0f);
        (float hind, float fore) = Follow(ref drop, 0.01f, 0.075f, -0.01f);
        Assert.Equal(0.015f, hind, 5);
        Assert.Equal(-0.01f, fore, 5);
        (hind, _) = Follow(ref drop, 0.05f, 0.075f, -0.01f);
        Assert.Equal(0.075f, hind, 5);
        (hind, fore) = Follow(ref drop, 0.02f, 0f, 0.1f);
        Assert.Equal(0.045f, hind, 5);
        Assert.Equal(0.02f, fore, 5);
    }

    [Fact]
    public void All_that_is_asked_is_taken_at_once_at_first_and_where_no_time_passes()
    {
        var drop = new LegDrop();
        Assert.Equal((0.07f, 0.02f), Follow(ref drop, 0.01f, 0.07f, 0.02f));
        Assert.Equal((0f, 0f), Follow(ref drop, 0f, 0f, 0f));
    }

    [Fact]
    public void A_trunk_that_an_act_throws_over_its_feet_comes_down_for_them_as_quickly()
    {
        var drop = new LegDrop();
        Follow(ref drop, 0.01f, 0f, 0f);
        (float hind, _) = Follow(ref drop, 0.01f, 0.075f, 0f, 0.04f);
        Assert.Equal(0.055f, hind, 5);
    }

    private static (float Hind, float Fore) Follow(ref LegDrop drop, float seconds, float hind, float fore, float ahead = 0f)
    {
        drop.Follow(seconds, Leg, ahead * Vector3.UnitZ, ref hind, ref fore);
        return (hind, fore);
    }
}
