using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Maths;

/// <summary>Rotations between unit vectors in single precision against those in double precision and against what they are asked for.</summary>
public sealed class UnitRotationTests
{
    private const int Draws = 5000;

    /// <summary>What floats lose (6e-8) where directions are nearly opposite: 1 + from · to is 0.01 at the least, and an angle has its error over the sine, 0.14; a few such errors.</summary>
    private const float Rounding = 1e-5f;

    [Fact]
    public void The_smallest_turn_is_that_of_double_precision_even_between_nearly_opposite_directions()
    {
        RandomStream random = new Seed(8).Stream();
        for (int i = 0; i < Draws; i++)
        {
            Vector3 from = Direction(random);
            Vector3 to = i % 5 == 0 ? Vec.Normalize((Direction(random) * 0.02f) - from) : Direction(random);
            Assert.True(Vec.Distance(to, Rotation.Rotate(UnitRotation.FromTo(from, to), from)) < Rounding);
            Assert.True(MovingPose.Between(Rotation.FromTo(from, to), UnitRotation.FromTo(from, to)) < (i % 5 == 0 ? 1e-3 : 2e-5));
        }
    }

    [Fact]
    public void A_frame_takes_its_direction_over_and_its_side_into_the_plane_of_the_other()
    {
        RandomStream random = new Seed(9).Stream();
        for (int i = 0; i < Draws; i++)
        {
            Vector3 from = Direction(random);
            Vector3 fromSide = Direction(random);
            Vector3 to = i % 5 == 0 ? Vec.Normalize((Direction(random) * 0.02f) - from) : Direction(random);
            Vector3 toSide = Direction(random) * 3f;
            Quaternion turn = UnitRotation.Frame(from, fromSide, to, toSide);
            Assert.True(Vec.Distance(to, Rotation.Rotate(turn, from)) < Rounding);
            Vector3 side = Vec.Reject(Rotation.Rotate(turn, fromSide), to);
            Vector3 wanted = Vec.Reject(toSide, to);
            if (Vec.Length(side) > 0.05f && Vec.Length(wanted) > 0.15f)
            {
                Assert.True(Vec.Distance(Vec.Normalize(side), Vec.Normalize(wanted)) < 1e-4f);
            }
        }
    }

    [Fact]
    public void A_side_that_has_to_go_half_round_goes_half_round()
    {
        Quaternion turn = UnitRotation.Frame(Vector3.UnitY, Vector3.UnitX, Vector3.UnitY, -Vector3.UnitX);
        Assert.True(Vec.Distance(-Vector3.UnitX, Rotation.Rotate(turn, Vector3.UnitX)) < 1e-6f);
        Assert.True(Vec.Distance(Vector3.UnitY, Rotation.Rotate(turn, Vector3.UnitY)) < 1e-6f);
    }

    private static Vector3 Direction(RandomStream random) => Rotation.Rotate(MovingPose.AnyRotation(random), Vector3.UnitZ);
}
