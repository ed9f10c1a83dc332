using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Winged;

namespace CreatureGen.Motion.Flying;

/// <summary>Where a flier wants to be.</summary>
internal enum FlightIntent
{
    /// <summary>On the ground: it comes down on its legs when it is low enough, folds its wings and stands.</summary>
    Ground,

    /// <summary>In the air: it takes off when it stands.</summary>
    Air,
}

/// <summary>What a flier is to do.</summary>
/// <param name="Intent">On the ground or in the air.</param>
/// <param name="Speed">Metres per second ahead; 0 hovers.</param>
/// <param name="YawRate">Radians per second; positive turns left.</param>
/// <param name="ClimbRate">Metres per second up; negative descends.</param>
/// <param name="Height">Metres from the ground up to the root.</param>
/// <param name="Gravity">Metres per second squared; 0.05..10000. In the space of the model: that of the world over the creature's scale.</param>
/// <param name="Settings">How it flies; null for the defaults.</param>
/// <param name="ShownWings">How far wings are spread and raised to be seen, however it goes: 0..1, or beyond to raise them higher.</param>
/// <param name="Sway">How folded wings swing with its steps.</param>
internal readonly record struct FlightInput(FlightIntent Intent, float Speed, float YawRate = 0f, float ClimbRate = 0f, float Height = 100f, float Gravity = StandardGravity.Acceleration, FlyingSettings? Settings = null, float ShownWings = 0f, WingSway Sway = default)
{
    /// <summary>Throws on numbers that are not finite or not in range.</summary>
    public void Require()
    {
        StepCheck.Finite(Speed, nameof(Speed));
        StepCheck.Finite(YawRate, nameof(YawRate));
        StepCheck.Finite(ClimbRate, nameof(ClimbRate));
        StepCheck.Finite(Height, nameof(Height));
        if (!(StepCheck.Finite(Gravity, nameof(Gravity)) > 0))
        {
            throw new ArgumentOutOfRangeException(nameof(Gravity), Gravity, "expected a gravity above 0");
        }
    }
}
