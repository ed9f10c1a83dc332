using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>Jumps, falls and landings.</content>
internal sealed partial class FallingMode
{
    /// <summary>Part of the speed that legs bear above which who has wings does not fall.</summary>
    private const float WingedFall = 0.9f;

    private RootPlace Leaping(RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        place = Leap.Advance(place, dt, settings, ground, layer, local, out bool off);
        wings?.HoldWings(place, dt, true, settings, layer, local);
        if (off)
        {
            Fall.Begin(local, Leap.Velocity, Leap.Turn);
            State = BodyState.Falling;
            legs!.Tell(MotionEventKind.FootUp, Vec.Length(Leap.Velocity), 1f);
            Tell(MotionEventKind.Jumped, place, settings.Up, Vec.Length(Leap.Velocity), 0f);
        }

        return place;
    }

    /// <summary>Whether a falling body opens its wings and flies: where it is asked to, or comes down as hard as its legs bear.</summary>
    private bool TakesWing(in RootPlace place, in MotionInput input, in MotionSettings settings) => wings != null
        && (input.Medium == MotionMedium.Air || -Vec.Dot(Fall.Velocity, settings.Up) > WingedFall * profile.Value.BorneSpeed * settings.Gravity * Tau(place.Scale, settings.Gravity));

    private void Begin(in RootPlace place, in Pose shown, in MotionSettings settings)
    {
        BodyVelocity velocity = legs!.Velocity;
        Fall.Begin(shown, Rotation.Rotate(place.Rotation, velocity.Linear) * place.Scale, AirTurn.Spinning(velocity.YawRate));
        State = BodyState.Falling;
        Tell(MotionEventKind.Fell, place, settings.Up, 0f, 0f);
    }

    private RootPlace Falling(RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        place = Fall.Fall(place, dt, settings, ground, layer, local, out float impact);
        wings?.HoldWings(place, dt, true, settings, layer, local);
        if (impact > 0f)
        {
            State = BodyState.Landed;
            if (impact > profile.Value.BorneSpeed * settings.Gravity * Tau(place.Scale, settings.Gravity))
            {
                // More than its legs take: it collapses, and gets up by itself.
                goesLimp = true;
                (getsUp, dazed) = (true, true);
            }

            float force = Fall.ForceOf(impact, settings.Gravity);
            Tell(MotionEventKind.Landed, place, settings.Up, impact, force);
            legs!.Tell(MotionEventKind.FootDown, impact, force);
        }

        return place;
    }

    /// <summary>The legs take up the fall; meanwhile it goes no faster than it came.</summary>
    private RootPlace Landed(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        State = Fall.Absorb(dt) ? BodyState.Supported : State;
        float going = legs!.Speed * place.Scale;
        var asked = new MotionInput(Scalar.Clamp(input.Speed, Math.Min(going, 0f), Math.Max(going, 0f)), input.YawRate);
        place = legs.Update(place, dt, asked, settings, ground, layer, local);
        Fall.Fade(dt, local);
        wings?.HoldWings(place, dt, false, settings, layer, local);
        return place;
    }
}
