using System;
using CreatureGen.Motion.Walking;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A jump out of a run, which carries the body to its target: as low as a jump may be at the speed that it has, higher where the target is farther. Where it is nearer the body crouches less and takes off sooner, and
/// where that is not enough it brakes as it does.
/// </summary>
/// <remarks>Where and how fast the body is at the take-off is foretold by the very law by which its speed changes, so that it flies on at the speed that it has.</remarks>
internal readonly struct RunningLeap
{
    /// <summary>Part of a whole crouch that it takes, and the least.</summary>
    public const float UsualCrouch = 0.5f;
    private const float ShortestCrouch = 0.2f;

    /// <summary>How often what lands at the target is halved in on.</summary>
    private const int Halvings = 16;

    private readonly LeapTiming timing;
    private readonly WalkingMode legs;
    private readonly MotionSettings settings;
    private readonly float scale;
    private readonly float heading;
    private readonly float height;
    private readonly LeapPlan low;

    /// <summary>Jumps of a body at a run to a height.</summary>
    /// <param name="timing">Of the body.</param>
    /// <param name="legs">On which it runs.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="towards">Its speed to the target, world m/s.</param>
    /// <param name="height">Of the target above it, world metres.</param>
    public RunningLeap(in LeapTiming timing, WalkingMode legs, in MotionSettings settings, float scale, float towards, float height)
    {
        (this.timing, this.legs, this.settings, this.scale, this.height) = (timing, legs, settings, scale, height);
        float ahead = legs.Speed * scale;
        heading = towards / ahead;
        low = new LeapPlan(timing.Lowest(height), ahead, UsualCrouch);
    }

    /// <summary>How far it jumps at least, world metres.</summary>
    public float Nearest => Length(low with { Crouch = ShortestCrouch, Pace = 0f });

    /// <summary>The jump over a distance that is no nearer; none where it is too far or too high for a run.</summary>
    /// <param name="distance">World metres.</param>
    /// <param name="fastest">Greatest speed upwards, world m/s.</param>
    public LeapPlan? Over(float distance, float fastest)
    {
        LeapPlan high = low with { Upward = fastest };
        LeapPlan soon = low with { Crouch = ShortestCrouch };
        return low.Upward > fastest || Length(high) < distance ? null
            : Length(low) <= distance ? Between(low, high, distance)
            : Length(soon) <= distance ? Between(soon, low, distance)
            : Between(soon with { Pace = 0f }, soon, distance);
    }

    /// <summary>What is as far as that, of all between one that is nearer and one that is farther.</summary>
    private LeapPlan Between(in LeapPlan nearer, in LeapPlan farther, float distance)
    {
        float below = 0f;
        float above = 1f;
        for (int i = 0; i < Halvings; i++)
        {
            float middle = 0.5f * (below + above);
            (below, above) = Length(LeapPlan.Lerp(nearer, farther, middle)) > distance ? (below, middle) : (middle, above);
        }

        return LeapPlan.Lerp(nearer, farther, above);
    }

    /// <summary>From where it is to where it lands.</summary>
    private float Length(in LeapPlan plan)
    {
        float way = legs.Foretell(plan.Pace, timing.WindUpSeconds(plan.Crouch, plan.Upward), scale, settings, out float speed);
        return heading * (way + (speed * timing.FlightSeconds(plan.Upward, height)));
    }
}
