using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>Moves the body, the legs and the fins of a swimmer.</summary>
/// <remarks>
/// The speed decides tempo and width of the beat so that the Strouhal number stays that of the style: f = f₀·u^¾ and width u^¼, with u the speed in cruising speeds; standing still, the
/// body sways slowly. All oscillations are whole multiples of one phase: under steady input the motion repeats exactly after each cycle.
/// </remarks>
internal static class SwimMotion
{
    /// <summary>Sharpness with which the motion follows its input, in cycles at cruise.</summary>
    private const double Response = 5;

    private const double IdleTempo = 0.35;
    private const double IdleAmplitude = 0.28;
    private const double FastestTempo = 2.6;

    /// <summary>Greatest width of the beat, 1 at cruise.</summary>
    internal const double WidestBeat = 1.15;

    /// <summary>Cruises above which legs begin to lie back, and from which on they do.</summary>
    private const double SlowestTrail = 0.1;
    private const double FullTrail = 0.85;

    /// <summary>Width of the beat of a body that glides at speed, 1 at cruise.</summary>
    private const double GlideAmplitude = 0.06;

    /// <summary>Cruises that are missing at which it works its hardest to get faster, and how much harder that is, cruises; and cruises too many at which it only glides.</summary>
    private const double PushingGap = 0.5;
    private const double PushEffort = 0.8;
    private const double GlidingGap = 0.3;

    /// <summary>How far the whole body bends with each beat, from nose to tail, as it gets faster as hard as it can, radians: it leaves with a stroke that is more than its wave.</summary>
    private const double StrokeBend = 0.35;

    /// <summary>Part of its thrust from which on that is as hard as it can, and how much more sharply than the rest of its motion it comes to that.</summary>
    private const double StrokePart = 0.6;
    private const double StrokeSharpness = 2;

    /// <summary>How far the body bends from nose to tail as it pushes off, radians, and how much of that more towards the tail.</summary>
    private const double PushBend = 1.2;
    private const double PushInTail = 1.2;

    /// <summary>Where the body keeps its heading as it bends with its strokes, body lengths behind the nose: heads are steadier than tails.</summary>
    private const double SteadyPart = 0.35;

    /// <summary>Part of a cycle from when it begins to push off until it strikes: there its wave is to have its tail where the strike ends.</summary>
    private const double StrikePhase = 0.25;

    /// <summary>Sharpness with which it comes to turn, in cycles at cruise: the body bends first.</summary>
    private const double YawResponse = 3.5;

    /// <summary>Body lengths that it goes before its tail bends as its head does: the rear follows the way of the front.</summary>
    private const double TailWay = 0.25;

    /// <summary>Most that a steady turn bends the body from nose to tail, radians.</summary>
    private const double DeepestTurn = 1.25;

    private const double SteepestPitch = 1.1;

    /// <summary>Part of its thrust with which it keeps off the ground.</summary>
    private const double Cushion = 0.8;

    /// <summary>What a C-start adds to the speed at its height, cruises.</summary>
    private const double DartCruises = 2.2;

    /// <summary>How far a body between the halves of a disc goes up as they go down, body lengths, and how it pitches with them, radians.</summary>
    private const double DiscHeave = 0.018;
    private const double DiscPitch = 0.04;

    /// <summary>Steps for each stage of a C-start, and most in one update.</summary>
    private const int StepsPerStage = 8;
    private const int MaxSteps = 64;

    /// <summary>Moves on and writes the body's root, the axis of the body, the legs and the fins of a local pose; other joints are left alone.</summary>
    /// <param name="profile">How the creature swims.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="state">Where it is in its motion.</param>
    /// <param name="dt">Seconds, not negative; longer steps than 0.25 s count as that.</param>
    /// <param name="local">Pose in the parents' space, one entry per joint of the creature's skeleton.</param>
    /// <returns>How the root moves in the mean of the step: towards what is asked, as fast as its build lets it get faster, slower and round; faster and round in a C-start.</returns>
    /// <exception cref="ArgumentException">The pose does not fit, or a number is not finite.</exception>
    public static BodyVelocity Update(SwimProfile profile, in SwimInput input, ref SwimState state, float dt, in Pose local)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        local.Require(profile.Skeleton);
        BodyVelocity root = Advance(profile, input, ref state, StepCheck.Step(dt));
        Write(profile, state, local);
        return root;
    }

    /// <summary>Tempo and width of the beat.</summary>
    /// <param name="effort">How hard it works, as the speed that it would keep up by that, cruises.</param>
    /// <param name="cruises">How fast it goes.</param>
    /// <param name="tempo">Receives the tempo, 1 at cruise.</param>
    /// <param name="width">Receives the width, 1 at cruise.</param>
    internal static void Beat(double effort, double cruises, out double tempo, out double width)
    {
        double quarter = Math.Sqrt(Math.Sqrt(effort));
        tempo = Math.Min(Math.Max(quarter * quarter * quarter, IdleTempo), FastestTempo);
        double idle = Scalar.Lerp(IdleAmplitude, GlideAmplitude, Scalar.Smooth(2 * Math.Abs(cruises)));
        width = Scalar.Lerp(idle, Math.Min(quarter, WidestBeat), Scalar.Smooth(effort / 0.25));
    }

    /// <summary>How hard it works, cruises: as hard as its speed asks, harder while it gets faster, not at all while it glides.</summary>
    private static double Effort(double cruises, double goal)
    {
        double u = Math.Abs(cruises);
        double missing = Math.Abs(goal) - u;
        return missing > 0 ? u + (PushEffort * Scalar.Smooth(missing / PushingGap)) : u * (1 - Scalar.Smooth(-missing / GlidingGap));
    }

    private static BodyVelocity Advance(SwimProfile profile, in SwimInput input, ref SwimState state, double dt)
    {
        StepCheck.Finite(input.Speed, "Speed");
        StepCheck.Finite(input.YawRate, "YawRate");
        StepCheck.Finite(input.ClimbRate, "ClimbRate");
        StartEscape(input.Escape, ref state);
        double stages = StagesPerSecond(profile) * dt;
        return state.EscapeSide == 0 || dt <= 0 ? Step(profile, input, ref state, dt) : Dart(profile, input, ref state, dt, Math.Min((int)Math.Ceiling(stages * StepsPerStage), MaxSteps));
    }

    /// <summary>A C-start is over in a few frames, turning and darting at once: it is stepped finely, and the velocity is that which leads along the chord.</summary>
    private static BodyVelocity Dart(SwimProfile profile, in SwimInput input, ref SwimState state, double dt, int steps)
    {
        double step = dt / steps;
        Vector3 way = Vector3.Zero;
        double turn = 0;
        for (int k = 0; k < steps; k++)
        {
            BodyVelocity velocity = Step(profile, input, ref state, step);
            double turned = velocity.YawRate * step;
            way += Rotation.Rotate(AxisRotation.Yaw(turn + (0.5 * turned)), velocity.Linear) * (float)step;
            turn += turned;
        }

        return new BodyVelocity(Rotation.Rotate(AxisRotation.Yaw(-0.5 * turn), way) / (float)dt, (float)(turn / dt));
    }

    private static BodyVelocity Step(SwimProfile profile, in SwimInput input, ref SwimState state, double dt)
    {
        double cruise = profile.CruiseSpeed;
        double cycle = profile.CruiseFrequency;
        double sharpness = Response * cycle;
        SwimmingSettings settings = input.Settings ?? SwimmingSettings.Default;
        MomentumLimits limits = profile.Momentum.Quickened(settings.SpeedResponse).Braked(settings.Braking);
        double goal = Math.Max(input.Speed, -cruise);
        double gained = state.Ahead.Acceleration;
        double way = state.Ahead.Step(goal, limits, dt);
        gained = 0.5 * (gained + state.Ahead.Acceleration);
        double climbed = state.Rise.Step(Math.Max(input.ClimbRate, MinClimb(input.Room, limits)), limits, dt);
        double speed = state.Ahead.Speed;
        double climb = state.Rise.Speed;
        double fastest = profile.FastestTurn(speed);
        double yaw = Scalar.Clamp(input.YawRate, -fastest, fastest);
        double turned = state.Turn.Step(yaw, YawResponse * cycle * settings.YawResponse, dt);
        double side = state.EscapeSide;
        double before = state.EscapeAge;
        double age = side == 0 ? 0 : Math.Min(before + (dt * StagesPerSecond(profile)), EscapeCurve.Duration);
        double drive = side == 0 ? 0 : EscapeCurve.Drive(0.5 * (before + age));
        bool over = age >= EscapeCurve.Duration;
        state.EscapeAge = over ? 0 : age;
        state.EscapeSide = over ? 0 : side;

        // What is integrated goes by the mean of the step, so that frame rates agree.
        double cruises = (dt > 0 ? way / dt : speed) / cruise;
        Beat(Effort(cruises, goal / cruise), cruises, out double tempo, out double width);
        double pushing = Scalar.Smooth(Math.Sign(goal) * gained / (StrokePart * limits.Thrust));
        tempo += 1.2 * drive;
        width = Math.Min((width + (0.5 * drive)) * settings.BeatAmplitude, WidestBeat);
        state.Lean = settings.Bank;
        bool backwards = goal < 0 && profile.Style == SwimStyle.Anguilliform;
        state.Phase += state.Frequency.Step(backwards ? -tempo * cycle : tempo * cycle, sharpness, dt);
        state.Phase -= Math.Floor(state.Phase);
        state.Amplitude.Step(width, sharpness, dt);
        state.Stroke.Step(profile.IsStiff ? 0 : pushing * settings.BeatAmplitude, StrokeSharpness * sharpness, dt);
        double missing = side == 0 ? (goal / cruise) - Math.Abs(cruises) : 0;
        state.Push.Step(Scalar.Smooth(missing / PushingGap) * Math.Min(settings.BeatAmplitude, 1), missing, cruises, PushSide(profile, yaw, state.Phase), dt * StagesPerSecond(profile));

        // The body lies along the arc that it swims.
        double arc = yaw * profile.BodyLength / Math.Max(Math.Abs(speed), 0.4 * cruise);
        double bent = state.Bend.Value;
        state.Bend.Step(Curve.Bounded(arc, DeepestTurn), sharpness, dt);
        double follows = 2 * Math.Max(Math.Abs(speed), 0.4 * cruise) / (TailWay * profile.BodyLength);
        state.TailBend.Step(0.5 * (bent + state.Bend.Value), Math.Min(follows, sharpness), dt);
        state.Climb.Step(Curve.Bounded(PortableMath.Atan2(climb, Math.Max(Math.Abs(speed), 0.35 * cruise)), SteepestPitch), 0.7 * sharpness, dt);
        double brake = Scalar.Clamp((Math.Abs(speed) - Math.Abs(goal)) / (0.5 * cruise), 0, 1);
        state.Brake.Step(brake, 2 * sharpness, dt);
        if (dt <= 0)
        {
            return default;
        }

        double turn = turned / dt;
        double ahead = way / dt;
        if (side != 0)
        {
            turn += side * EscapeCurve.TurnAngle * (EscapeCurve.Turned(age) - EscapeCurve.Turned(before)) / dt;
            ahead += DartCruises * cruise * (EscapeCurve.Driven(age) - EscapeCurve.Driven(before)) / (dt * StagesPerSecond(profile));
        }

        return new BodyVelocity(new Vector3(0f, (float)(climbed / dt), (float)ahead), (float)turn);
    }

    /// <summary>To which side it curls up to push off: into its turn, or so that its tail strikes to where its wave goes on.</summary>
    private static double PushSide(SwimProfile profile, double yaw, double phase)
    {
        if (profile.IsVertical || profile.IsStiff)
        {
            return 1;
        }

        PortableMath.SinCos(2 * PortableMath.Pi * (phase + StrikePhase), out double sine, out double cosine);
        return (yaw != 0 ? yaw : -profile.Wave.Displacement(profile.Chain.Count, cosine, sine)) < 0 ? -1 : 1;
    }

    /// <summary>The least climb with so much room below it: it comes to rest above the ground, and rises out of what comes up towards it.</summary>
    private static double MinClimb(double room, in MomentumLimits limits)
    {
        double steady = Math.Sqrt(Cushion * limits.Thrust * Math.Abs(room));
        return room > 0 ? -steady : steady;
    }

    private static double StagesPerSecond(SwimProfile profile) => profile.CruiseFrequency / EscapeCurve.StageFraction;

    private static void StartEscape(EscapeTurn asked, ref SwimState state)
    {
        if (asked != EscapeTurn.None && state.LastEscape == EscapeTurn.None && state.EscapeSide == 0)
        {
            state.EscapeSide = asked == EscapeTurn.Left ? 1 : -1;
            state.EscapeAge = 0;
        }

        state.LastEscape = asked;
    }

    private static void Write(SwimProfile profile, in SwimState state, in Pose local)
    {
        AxialChain chain = profile.Chain;
        Span<Quaternion> turns = stackalloc Quaternion[chain.Count];
        Span<Vector3> pivots = stackalloc Vector3[chain.Count];
        bool vertical = profile.IsVertical;
        bool escaping = state.EscapeSide != 0;
        double calm = (escaping ? EscapeCurve.Wave(state.EscapeAge) : 1) * (profile.IsStiff ? 1 : state.Push.Wave);
        double amplitude = state.Amplitude.Value * calm;
        double bend = (0.5 * (state.Bend.Value + state.TailBend.Value)) + (escaping ? state.EscapeSide * profile.Curl * EscapeCurve.Bend(state.EscapeAge) : 0);
        double ahead = state.Bend.Value - state.TailBend.Value;
        double push = profile.IsStiff ? 0 : PushBend * state.Push.Bend;
        PortableMath.SinCos(2 * PortableMath.Pi * state.Phase, out double sine, out double cosine);

        // With the tail, which it takes to where its wave has it.
        double stroke = StrokeBend * state.Stroke.Value * calm * profile.Wave.Displacement(chain.Count, cosine, sine) / profile.Wave.TailReach;
        for (int b = 0; b < chain.Count; b++)
        {
            ref readonly AxialBone bone = ref chain.Bones[b];
            double along = (bone.Middle.Z - chain.Centre.Z) / chain.Length;
            double behind = SteadyPart - ((chain.Nose.Z - bone.Middle.Z) / chain.Length);
            double heading = profile.Wave.Heading(b, amplitude, cosine, sine) + (stroke * behind) + Bent(push, -PushInTail * push, behind);
            double round = Bent(bend, ahead, along);
            turns[b] = vertical ? Rotation.Multiply(AxisRotation.Yaw(round), AxisRotation.Pitch(-heading)) : AxisRotation.Yaw(round + heading);
        }

        // The body's root lies as the axis does there, or the joints next to it would have to turn by all of it.
        Quaternion there = Rotation.Slerp(turns[chain.BeforeRoot], turns[chain.BehindRoot], 0.5);
        for (int b = 0; b < chain.Count; b++)
        {
            turns[b] = Rotation.Multiply(Rotation.Inverse(there), turns[b]);
        }

        chain.Write(local, turns, pivots);
        Place(profile, state, there, bend, amplitude, turns, pivots, local);
        SwimStroke moment = StrokeOf(profile, state, amplitude, calm);
        foreach (SwimLeg leg in profile.Legs)
        {
            leg.Write(local, moment, turns);
        }

        foreach (SwimFin fin in profile.Fins)
        {
            fin.Write(local, profile.Style, moment);
        }

        foreach (SwimDisc row in profile.Rows)
        {
            row.Write(local, moment);
        }

        foreach (MedianFin fin in profile.MedianFins)
        {
            fin.Write(local, moment);
        }
    }

    /// <summary>Heading of a bone of a bent body.</summary>
    /// <param name="bend">Between nose and tail, radians.</param>
    /// <param name="ahead">How much more the head is bent than the tail, as the bends that they would give the whole body, radians.</param>
    /// <param name="along">How far the bone is in front of the middle, body lengths.</param>
    private static double Bent(double bend, double ahead, double along) => along * (bend + (0.5 * ahead * along));

    /// <summary>Hangs the body on its centre of mass, which sways by what the recoil leaves of the wave's mean.</summary>
    private static void Place(SwimProfile profile, in SwimState state, Quaternion there, double bend, double amplitude, ReadOnlySpan<Quaternion> turns, ReadOnlySpan<Vector3> pivots, in Pose local)
    {
        AxialChain chain = profile.Chain;
        SwimKinematics kinematics = profile.Kinematics;
        PortableMath.SinCos(2 * PortableMath.Pi * state.Phase, out double sine, out double cosine);
        double pitch = -state.Climb.Value;
        double roll = -kinematics.Banking * bend * state.Lean;
        double heave = 0;
        double mean = amplitude * profile.Wave.Mean(cosine, sine);
        switch (profile.Style)
        {
            case SwimStyle.Flippers:
                double flying = amplitude * (1 - Hover(profile, state));
                heave = -0.035 * flying * chain.Length * ((sine * 0.62) - (cosine * 0.78));
                pitch += 0.07 * flying * ((cosine * 0.83) + (sine * 0.56));
                break;
            case SwimStyle.Cetacean:
                break;
            case SwimStyle.Disc:
                heave = -DiscHeave * amplitude * chain.Length * ((cosine * 0.93) + (sine * 0.36));
                pitch += DiscPitch * amplitude * ((cosine * 0.6) + (sine * 0.8));
                break;
            default:
                roll += 0.05 * amplitude * ((sine * 0.88) + (cosine * 0.48));
                break;
        }

        // Standing still it hangs in the water and floats up and down a little.
        heave += 0.008 * chain.Length * Hover(profile, state) * sine;
        Quaternion body = Rotation.Multiply(Rotation.Multiply(AxisRotation.Pitch(pitch), AxisRotation.Roll(roll)), there);
        Vector3 centre = chain.CentreOf(turns, pivots);
        Vector3 rest = chain.Centre - chain.BodyPivot;
        Vector3 sway = profile.IsVertical ? new Vector3(0f, (float)(heave + mean), 0f) : new Vector3((float)mean, (float)heave, 0f);
        local.Rotations[chain.Body] = Rotation.Normalize(Rotation.Multiply(body, profile.Skeleton.LocalRotations[chain.Body]));
        local.Positions[chain.Body] = profile.Skeleton.LocalPositions[chain.Body] + rest - Rotation.Rotate(body, centre) + sway;
    }

    private static double Hover(SwimProfile profile, in SwimState state) => 1 - Scalar.Smooth(Math.Abs(state.Ahead.Speed) / (0.5 * profile.CruiseSpeed));

    private static SwimStroke StrokeOf(SwimProfile profile, in SwimState state, double amplitude, double calm)
    {
        double u = state.Ahead.Speed / profile.CruiseSpeed;
        return new SwimStroke
        {
            Phase = state.Phase,
            Amplitude = amplitude,
            Wavelength = profile.Kinematics.Wavelength,
            Sideways = profile.IsVertical ? 0 : 1,
            Hover = Hover(profile, state),
            Fast = Scalar.Smooth(Math.Abs(u) - 1),
            Trail = 1 - (calm * (1 - Scalar.Smooth((u - SlowestTrail) / (FullTrail - SlowestTrail)))),
            Steer = Curve.Bounded(state.Bend.Value / 0.7, 1),
            Rise = Curve.Bounded(state.Climb.Value / 0.6, 1),
            Brake = state.Brake.Value,
            Back = Scalar.Smooth(-u / 0.3),
            Push = state.Push.Bend,
        };
    }
}
