using System;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>Moves the body, wings, legs, neck and tail of a flier.</summary>
/// <remarks>All oscillations are whole multiples of one slow cycle of <see cref="FlightProfile.BeatsPerCycle"/> beats: under steady input the motion repeats exactly after it.</remarks>
internal static class FlightMotion
{
    /// <summary>Moves on and writes the body's root, axis, wings and legs of a local pose.</summary>
    /// <param name="profile">How the creature flies.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="state">Where it is in its motion.</param>
    /// <param name="dt">Seconds, not negative; longer steps than 0.25 s count as that.</param>
    /// <param name="local">Pose in the parents' space, one entry per joint of the creature's skeleton.</param>
    /// <returns>How far the root went, metres of the model: in the air towards what is asked, as fast as its build lets it get faster, slower and round; by the motion itself while it takes off or lands. Where it begins to do something else it stops, and has time left.</returns>
    /// <exception cref="ArgumentException">The pose does not fit, or a number is not finite.</exception>
    public static RootDelta Update(FlightProfile profile, in FlightInput input, ref FlightState state, float dt, in Pose local)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        local.Require(profile.Skeleton);
        RootDelta way = Advance(profile, input, ref state, dt);
        FlightPose.Write(profile, state, input, local);
        return way;
    }

    /// <summary>Moves on without writing a pose.</summary>
    /// <inheritdoc cref="Update"/>
    public static RootDelta Advance(FlightProfile profile, in FlightInput input, ref FlightState state, float dt)
    {
        input.Require();
        FlightWay way = FlightPath.Travel(profile, input, ref state, (float)StepCheck.Step(dt));
        FlightControl.Advance(profile, input, way, ref state);
        return way.Root;
    }
}
