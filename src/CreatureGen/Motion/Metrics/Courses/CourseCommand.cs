using System;
using System.Text;

namespace CreatureGen.Motion.Metrics;

/// <summary>What a creature is asked to do for a time, as a player asks it: at once, whatever it did before.</summary>
/// <param name="Seconds">How long, above 0.</param>
/// <param name="Input">What is asked.</param>
/// <param name="Gait">The gait to keep to; null to choose by speed.</param>
public readonly record struct CourseCommand(float Seconds, MotionInput Input, Gait? Gait = null)
{
    /// <summary>An act that begins with the command; null for none.</summary>
    public ActAbility? Act { get; init; }

    /// <summary>What the act goes for.</summary>
    public ActTarget Target { get; init; }

    /// <summary>What becomes of an act that is under way.</summary>
    public ActOrder Order { get; init; }

    /// <summary>What pictures call it; null to tell it by what is asked.</summary>
    public string? Name { get; init; }

    /// <summary>What is done to the body as it begins.</summary>
    public BodyCommand Body { get; init; }

    /// <summary>Its name, or what is asked: <c>2.1 m/s left 1.5</c>.</summary>
    public override string ToString()
    {
        if (Name != null)
        {
            return Name;
        }

        var text = new StringBuilder();
        text.Append(Input.Speed == 0f ? "stand" : FormattableString.Invariant($"{Input.Speed:0.0} m/s"));
        Add(Input.YawRate, "left", "right");
        Add(Input.Sideways, "aside", "aside");
        Add(Input.ClimbRate, "up", "down");
        text.Append(Gait == null ? "" : " " + Gait.Name).Append(Input.Medium == MotionMedium.Air ? " in the air" : "");
        return text.ToString();

        void Add(float rate, string positive, string negative) =>
            text.Append(Math.Abs(rate) < 0.05f ? "" : FormattableString.Invariant($" {(rate > 0f ? positive : negative)} {Math.Abs(rate):0.0}"));
    }
}
