using System;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public sealed class GaitChoiceTests
{
    /// <summary>Parts by which steps may come quicker than the mass lets them, where one gait is left for the next.</summary>
    private const float Hurry = 1.4f;

    /// <summary>The first is a bird of a fifth of a ton on legs of a third of a metre, which took ten strides a second.</summary>
    [Theory]
    [InlineData(9920267, RequestedKind.Walking)]
    [InlineData(9920023, RequestedKind.Walking)]
    [InlineData(1, RequestedKind.Walking)]
    [InlineData(4, RequestedKind.Walking)]
    [InlineData(9920024, RequestedKind.Flying)]
    [InlineData(9920040, RequestedKind.Flying)]
    public void Steps_come_no_quicker_than_the_mass_lets_them_at_any_speed_up_to_the_top(ulong seed, RequestedKind kind)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        GaitSet gaits = profile.Gaits!;
        float quickest = GaitSet.QuickestOf(profile.Legs!.Mass);
        float unit = StandardGravity.Acceleration * profile.LegLength;
        int gait = 0;
        for (int i = 1; i <= 50; i++)
        {
            float speed = gaits.TopSpeed * i / 50f;
            gait = gaits.Choose(gait, speed * speed / unit);
            Gait chosen = gaits.Steps[gait].Gait;
            float frequency = GaitSet.FrequencyOf(chosen, speed * speed / unit, profile.LegLength, StandardGravity.Acceleration, SlopeStance.OnLevel(profile.Legs, chosen), quickest);
            Assert.True(frequency <= 1.001f * Hurry * quickest, FormattableString.Invariant($"{chosen.Name} at {speed} m/s: {frequency} steps a second, {quickest} at most"));
        }

        Assert.True(gaits.TopSpeed > 0.05f * (float)Math.Sqrt(unit));
    }
}
