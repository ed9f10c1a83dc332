using System.Numerics;
using CreatureGen.Motion.Walking.Footsteps;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

public sealed class FootPathTests
{
    [Fact]
    public void Up_is_away_from_a_level_way_and_from_none()
    {
        Assert.Equal(Vector3.UnitY, Way(new Vector3(0.3f, 0f, 0.4f)).Away);
        Assert.Equal(Vector3.UnitY, Way(default).Away);
        Assert.Equal(Vector3.UnitY, Way(new Vector3(0f, 0.2f, 0f)).Away);
    }

    [Theory]
    [InlineData(0.3f, 0.1f, 0.4f)]
    [InlineData(-0.3f, -0.2f, 0.4f)]
    public void All_places_of_a_way_are_as_far_away_and_what_is_higher_is_so_by_its_height(float x, float y, float z)
    {
        var end = new Vector3(x, y, z);
        Vector3 away = Way(end).Away;
        Assert.Equal(0f, Vector3.Dot(away, 0.4f * end), 1e-6f);
        Assert.Equal(0.05f, Vector3.Dot(away, (0.4f * end) + new Vector3(0f, 0.05f, 0f)), 1e-6f);
    }

    [Fact]
    public void A_way_steeper_than_one_in_one_is_taken_for_that()
    {
        Assert.Equal(new Vector3(0f, 1f, -1f), Way(new Vector3(0f, 3f, 0.5f)).Away);
        Assert.Equal(new Vector3(0f, 1f, 1f), Way(new Vector3(0f, -3f, 0.5f)).Away);
    }

    private static FootPath Way(Vector3 end) => new() { Start = new Vector3(1f, 2f, 3f), End = new Vector3(1f, 2f, 3f) + end };
}
