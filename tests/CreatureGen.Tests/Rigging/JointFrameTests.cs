using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class JointFrameTests
{
    [Fact]
    public void A_hanging_bone_turned_about_x_swings_back()
    {
        Quaternion frame = JointFrame.Hinged(-Vector3.UnitY, Vector3.UnitX);
        Vector3 tip = Rotation.Rotate(Rotation.Multiply(frame, Rotation.FromAxisAngle(Vector3.UnitX, 0.5)), Vector3.UnitY);
        Assert.True(tip.Z < -0.4f && tip.Y < 0f);
    }

    [Fact]
    public void A_snout_turned_about_x_tips_down_and_a_wing_rises()
    {
        Quaternion snout = JointFrame.Median(Vector3.UnitZ);
        Assert.True(Rotation.Rotate(Rotation.Multiply(snout, Rotation.FromAxisAngle(Vector3.UnitX, 0.5)), Vector3.UnitY).Y < -0.4f);
        Quaternion wing = JointFrame.Raised(Vector3.UnitX, Vector3.UnitY);
        Assert.True(Rotation.Rotate(Rotation.Multiply(wing, Rotation.FromAxisAngle(Vector3.UnitX, 0.5)), Vector3.UnitY).Y > 0.4f);
        Assert.True(Rotation.Rotate(Rotation.Multiply(wing, Rotation.FromAxisAngle(Vector3.UnitZ, 0.5)), Vector3.UnitY).Z < -0.4f);
    }

    [Theory]
    [InlineData(0f, -1f, 0f)]
    [InlineData(0.3f, -0.8f, 0.5f)]
    [InlineData(1f, 0f, 0f)]
    [InlineData(-1f, 1e-3f, 0f)]
    [InlineData(0f, 0f, 1f)]
    [InlineData(0f, 0f, -1f)]
    [InlineData(0f, 1f, 0f)]
    [InlineData(0f, 0f, 0f)]
    public void Every_direction_has_a_frame_of_three_unit_axes_with_y_along_it(float dx, float dy, float dz)
    {
        var direction = new Vector3(dx, dy, dz);
        foreach (Quaternion frame in new[]
        {
            JointFrame.Hinged(direction, Vector3.UnitX), JointFrame.Hinged(direction, Vector3.UnitZ),
            JointFrame.Raised(direction, Vector3.UnitY), JointFrame.Raised(direction, -Vector3.UnitY), JointFrame.Median(direction),
        })
        {
            Assert.Equal(1.0, ((double)frame.X * frame.X) + ((double)frame.Y * frame.Y) + ((double)frame.Z * frame.Z) + ((double)frame.W * frame.W), 6);
        }

        if (direction != Vector3.Zero)
        {
            Vector3 y = Rotation.Rotate(JointFrame.Hinged(direction, Vector3.UnitX), Vector3.UnitY);
            Assert.True(Vec.Distance(y, Vec.Normalize(direction)) < 1e-6f);
            y = Rotation.Rotate(JointFrame.Raised(direction, Vector3.UnitY), Vector3.UnitY);
            Assert.True(Vec.Distance(y, Vec.Normalize(direction)) < 1e-6f);
        }
    }

    [Fact]
    public void In_the_sagittal_plane_x_is_exactly_left_and_the_sign_of_zero_does_not_matter()
    {
        for (double a = 0; a < 6.28; a += 0.1)
        {
            Quaternion frame = JointFrame.Median(new Vector3(0.7f, (float)PortableMath.Cos(a), (float)PortableMath.Sin(a)));
            Assert.Equal((0f, 0f), (frame.Y, frame.Z));
            Assert.Equal(Vector3.UnitX, Rotation.Rotate(frame, Vector3.UnitX));
        }
    }
}
