using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Gaits;

public sealed class DutyLawTests
{
    [Theory]
    [InlineData(0f, 0.6f)]
    [InlineData(1f, 0.5f)]
    [InlineData(4f, 0.3f)]
    [InlineData(100f, 0.3f)]
    public void A_foot_is_down_for_less_of_the_cycle_the_faster_it_goes_between_two_ends(float froude, float duty) =>
        Assert.Equal(duty, new DutyLaw(0.7f, 0.2f, 0.3f, 0.6f).At(froude), 1e-6f);

    [Theory]
    [InlineData(0.25f, 1.498f)]
    [InlineData(1f, 2.4f)]
    [InlineData(4f, 3.845f)]
    public void Strides_lengthen_with_a_power_of_the_froude_number(float froude, float legLengths) => Assert.Equal(legLengths, StrideLaw.Symmetric.At(froude), 1e-3f);
}
