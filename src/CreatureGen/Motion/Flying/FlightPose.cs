using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>Writes the pose of a flier at a moment.</summary>
internal static class FlightPose
{
    private const double HoverPitch = 0.72;
    private const double BuzzPitch = 0.5;
    private const double FlarePitch = 0.45;

    /// <summary>Part of the slope of its way by which the body is pitched.</summary>
    private const double PathPitch = 0.75;

    private const double BeatPitch = 0.035;
    private const double MaxHeave = 0.05;
    private const double HoverBob = 0.03;
    private const double GlideEdge = 0.7;
    private const double GlideRounding = 0.5;

    /// <summary>Writes what the state says.</summary>
    public static void Write(FlightProfile profile, in FlightState state, in FlightInput input, in Pose local)
    {
        double hover = FlightControl.Hover(state.Cruises);
        double beats = state.Cycle * profile.BeatsPerCycle;
        double glide = Glide(profile, state);
        double amplitude = state.Amplitude.Value;
        double steer = state.Steer;
        PortableMath.SinCos(2 * PortableMath.Pi * state.Cycle, out double slow, out _);
        var wings = new WingStroke
        {
            Phase = beats,
            Amplitude = amplitude,
            Glide = glide,
            Spread = 1 - ((1 - state.Spread.Value) * (1 - Math.Min(input.ShownWings, 1f))),
            Shown = input.ShownWings,
            Flare = Scalar.Clamp(state.Flare.Value, 0, 1),
            Steer = steer,
            Hover = hover,
            Drift = slow,
            Altitude = state.Height.Value,
            LiftLeft = input.Sway.Left,
            LiftRight = input.Sway.Right,
        };
        foreach (WingPair wing in profile.Wings)
        {
            wing.Write(local, wings);
        }

        foreach (BuzzPair wing in profile.Buzzers)
        {
            wing.Write(local, wings);
        }

        Body(profile, state, hover, glide, slow, input.Gravity, local);
    }

    /// <summary>How much the wings are held still: all the time in a descent, part of the slow cycle at level flight, never in a climb.</summary>
    private static double Glide(FlightProfile profile, in FlightState state)
    {
        double edge = Math.Min(GlideEdge / profile.BeatsPerCycle, 0.25);
        double half = (1 - Scalar.Clamp(state.Effort.Value, 0, 1)) * (0.5 + edge);
        double away = Math.Abs(state.Cycle - 0.6);
        away = Math.Min(away, 1 - away);

        // Rounded: a glide that only just begins has no peak.
        double round = GlideRounding * edge;
        away = Math.Sqrt((away * away) + (round * round)) - round;
        return Scalar.Smooth((half - away) / edge);
    }

    private static void Body(FlightProfile profile, in FlightState state, double hover, double glide, double slow, double gravity, in Pose local)
    {
        double air = Scalar.Clamp(state.Air.Value, 0, 1);
        double beats = state.Cycle * profile.BeatsPerCycle;
        double beating = state.Amplitude.Value * (1 - glide) * air;
        double frequency = Math.Max(state.Frequency.Value, 0.25 * profile.BeatsIn(gravity));
        double max = MaxHeave * profile.WingSpan;
        double size = Math.Min(gravity / (frequency * frequency), max / profile.Force.Reach);
        double heave = beating * (profile.Buzzes ? 0.2 : 1) * size * profile.Force.At(beats);
        heave += HoverBob * profile.LegLength * hover * air * slow;
        double crouch = state.CrouchDepth;
        heave -= profile.CrouchDepth * crouch;

        // Near the ground the body comes down to where legs that hang free stand.
        heave -= profile.SoleHeight * (1 - Scalar.Smooth(state.Height.Value / (FlightPath.LandingHeight * profile.LegLength)));

        double posture = profile.Buzzes ? Scalar.Lerp(0.08, -BuzzPitch, hover) : Scalar.Lerp(-0.03, -HoverPitch, hover);

        // Close to the ground it goes over to how it stands, so that all feet reach it.
        double free = air * Scalar.Smooth(state.Height.Value / profile.LegLength);
        double raised = (1 - free) * state.Upright.Value;

        // Who flares does not go nose down along a way that leads down: it comes down on its spread wings.
        double flare = Scalar.Clamp(state.Flare.Value, 0, 1);
        double pitch = (free * (posture - (PathPitch * (1 - flare) * state.Path.Value) - (FlarePitch * flare))) - (raised * profile.Posture.Raised);
        pitch += (profile.Buzzes ? 0.2 : 1) * BeatPitch * beating * PortableMath.Sin((2 * PortableMath.Pi * beats) + 0.6);
        pitch -= 0.12 * crouch;
        double roll = -air * state.Bank;
        Quaternion body = Rotation.Multiply(AxisRotation.Pitch(pitch), AxisRotation.Roll(roll));
        AxialChain chain = profile.Chain;
        Vector3 now = chain.BodyPivot + new Vector3(0f, (float)heave, (float)(raised * profile.Posture.Ahead)) + profile.Raise(raised * profile.Posture.Raised);
        local.Rotations[chain.Body] = Rotation.Normalize(Rotation.Multiply(body, profile.Skeleton.LocalRotations[chain.Body]));
        local.Positions[chain.Body] = profile.Skeleton.LocalPositions[chain.Body] + (now - chain.BodyPivot);

        double steer = state.Steer;
        double stream = air * Scalar.Smooth(Math.Abs(state.Cruises) / 0.8);
        profile.Axis.Write(local, new AxisStroke
        {
            Pitch = pitch,
            Roll = roll,
            Look = 0.35 * air * steer,
            Steer = air * steer,
            Rise = air * state.Path.Value,
            Stream = stream,
            Hover = air * hover,
            Phase = beats,
            Beat = beating,
        });

        var legs = new LegStroke
        {
            Hanging = hover,
            Reaching = Scalar.Clamp(state.Reach.Value, 0, 1),
            Planted = Scalar.Clamp(state.Planted.Value, 0, 1),
            Height = state.Height.Value,
            Swing = beating * PortableMath.Sin((2 * PortableMath.Pi * beats) - 1.2),
        };
        foreach (FlightLegs leg in profile.Legs)
        {
            leg.Write(local, legs, body, chain.BodyPivot, now);
        }
    }
}
