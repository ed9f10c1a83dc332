using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Maths;

/// <summary>Shares of a turn against interpolation from the identity.</summary>
public sealed class RotationFractionsTests
{
    [Fact]
    public void A_share_is_the_rotation_at_that_place_of_the_shorter_way()
    {
        RandomStream random = new Seed(7).Stream();
        for (int i = 0; i < 2000; i++)
        {
            Quaternion any = MovingPose.AnyRotation(random);
            Quaternion turn = i % 3 == 0 ? Rotation.Nlerp(Quaternion.Identity, any, 1e-3) : i % 3 == 1 ? new Quaternion(-any.X, -any.Y, -any.Z, -any.W) : any;
            var fractions = new RotationFractions(turn);
            for (int k = 0; k <= 4; k++)
            {
                Assert.True(MovingPose.Between(Rotation.Slerp(Quaternion.Identity, turn, 0.25 * k), fractions.At(0.25f * k)) < 2e-6);
            }
        }
    }

    [Fact]
    public void Any_share_of_no_turn_is_none()
    {
        Assert.Equal(Quaternion.Identity, new RotationFractions(Quaternion.Identity).At(0.7f));
        Assert.Equal(Quaternion.Identity, new RotationFractions(new Quaternion(0f, 0f, 0f, -1f)).At(0.7f));
    }
}
