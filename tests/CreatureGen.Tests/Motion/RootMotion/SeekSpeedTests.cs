using System.Numerics;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.RootMotion;

public sealed class SeekSpeedTests
{
    /// <summary>2 m/s ahead and 0.66 of it back; 3 s⁻¹ of what is left; nothing beyond a right angle.</summary>
    [Theory]
    [InlineData(0f, 20f, 2f, 0f)]
    [InlineData(0f, 1f, -1.32f, 0f)]
    [InlineData(0f, 5f, 0f, 0f)]
    [InlineData(5f, 0.001f, 0f, 1.745f)]
    [InlineData(-20f, 0.001f, 0f, -1.745f)]
    [InlineData(10f, 10f, 1f, 1.745f)]
    public void What_a_seeker_wants_is_as_its_settings_say(float left, float ahead, float speed, float turn)
    {
        SeekState state = default;
        BodyVelocity wanted = Seek.Decide(ref state, SeekSettings.Default, new Vector3(left, 0.7f, ahead));
        Assert.Equal(speed, wanted.Linear.Z, 0.02f);
        Assert.Equal(turn, wanted.YawRate, 0.02f);
    }
}
