using System;
using CreatureGen.Appearance;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class FaceShadeTests
{
    private const float EyeRing = 9.5f;
    private const float EyeAround = 1.05f;

    [Fact]
    public void The_bridge_of_a_nose_is_light_between_dark_troughs_from_the_eyes()
    {
        for (float ring = 5f; ring <= 7.5f; ring += 0.5f)
        {
            float middle = FaceShade.At(ring, 0f, EyeRing, EyeAround);
            float beside = FaceShade.At(ring, 0.8f, EyeRing, EyeAround);
            Assert.True(middle > 0.7f && beside < -0.4f, FormattableString.Invariant($"ring {ring}: {middle:0.00} on the bridge, {beside:0.00} beside it"));
        }
    }

    [Fact]
    public void Cheekbones_are_light_below_the_eyes() => Assert.True(FaceShade.At(9f, EyeAround + 0.72f, EyeRing, EyeAround) > 0.3f);

    [Theory]
    [InlineData(0f)]
    [InlineData(20f)]
    public void Nose_and_nape_keep_their_tone(float ring)
    {
        for (float around = 0f; around < 3.1f; around += 0.1f)
        {
            Assert.InRange(FaceShade.At(ring, around, EyeRing, EyeAround), -0.01f, 0.01f);
        }
    }
}
