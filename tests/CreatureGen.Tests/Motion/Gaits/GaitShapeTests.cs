using CreatureGen.Motion;
using CreatureGen.Motion.Gaits;
using Xunit;

namespace CreatureGen.Tests.Motion.Gaits;

public sealed class GaitShapeTests
{
    private const float Fraction = 0.03f;

    [Fact]
    public void Numbers_of_a_gait_go_the_same_share_of_what_is_left_in_each_step()
    {
        GaitShape shape = GaitShape.Of(GaitLibrary.Walk);
        float before = GaitLibrary.Walk.ForceDip - GaitLibrary.Trot.ForceDip;
        for (int i = 0; i < 50; i++)
        {
            shape.Approach(GaitLibrary.Trot, Fraction);
            float left = shape.ForceDip - GaitLibrary.Trot.ForceDip;
            Assert.Equal((1f - Fraction) * before, left, 1e-6f);
            before = left;
        }
    }

    /// <summary>One that goes to 0 was a smaller number in each step for ever, and what is worked out from it was found anew.</summary>
    [Fact]
    public void They_arrive_at_those_of_the_next_gait_and_change_no_more()
    {
        GaitShape shape = GaitShape.Of(GaitLibrary.Walk);
        for (int i = 0; i < 400; i++)
        {
            shape.Approach(GaitLibrary.Trot, Fraction);
        }

        Assert.Equal(GaitShape.Of(GaitLibrary.Trot), shape);
        shape.Approach(GaitLibrary.Trot, Fraction);
        Assert.Equal(GaitShape.Of(GaitLibrary.Trot), shape);
    }

    [Fact]
    public void One_that_turns_back_on_its_way_arrives_where_it_came_from()
    {
        GaitShape shape = GaitShape.Of(GaitLibrary.Walk);
        shape.Approach(GaitLibrary.Trot, 0.5f);
        Assert.NotEqual(GaitLibrary.Walk.ForceDip, shape.ForceDip);
        for (int i = 0; i < 400; i++)
        {
            shape.Approach(GaitLibrary.Walk, Fraction);
        }

        Assert.Equal(GaitShape.Of(GaitLibrary.Walk), shape);
    }
}
