using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>
/// Decides when each foot leaves the ground and where it comes down. A foot on the ground is locked to its place in the world; a swinging one goes to where its home will be
/// in the middle of the coming stance, predicted along the arc that the body follows: that alone gives straight steps, inner and outer legs in turns, and stepping on the spot.
/// </summary>
internal sealed partial class FootPlanner
{
    /// <summary>Part of the leg's length that a foot has to be from its next place before it steps.</summary>
    private const float MinStep = 0.003f;

    /// <summary>Radians that a foot has to be turned from its next heading before it steps.</summary>
    private const float MinTurn = 0.05f;

    /// <summary>Part of the swing after which a foot that stayed down far from home stays for this cycle.</summary>
    private const float LatestRescue = 0.7f;

    /// <summary>Leg lengths from home from which on a foot is far from it.</summary>
    private const float Far = 0.35f;

    /// <summary>How far a foot may be from where it was to come down and still be put there, leg lengths.</summary>
    private const float MaxAstray = 0.004f;

    /// <summary>How far a foot is dragged at most to stay on its tread, leg lengths.</summary>
    private const float MaxDrag = 0.05f;

    /// <summary>How far a place may lie off the plane of another and still be on the same ground, leg lengths.</summary>
    private const float OtherTread = 0.02f;

    /// <summary>How far the gait's own swing may have come for a foot to join it: with less time left it would be hurled.</summary>
    private const float LatestJoin = 0.6f;

    /// <summary>How long before a foot leaves the ground it is decided whether it does, in times between decisions.</summary>
    private const float DecisionsAhead = 1.5f;

    private readonly LeggedBody body;
    private readonly Foot[] feet;
    private readonly SwingClearance[] ways;
    private readonly FootEvents events;
    private readonly FootingSearch search;
    private ExponentialDecay aimDecay;

    public FootPlanner(LeggedBody body, EventQueue events)
    {
        this.body = body;
        this.events = new FootEvents(body, events);
        feet = new Foot[body.Legs.Length];
        ways = new SwingClearance[feet.Length];
        for (int i = 0; i < ways.Length; i++)
        {
            ways[i] = new SwingClearance();
        }

        search = new FootingSearch(body);
    }

    public Foot[] Feet => feet;

    /// <summary>Tells of all feet that stand.</summary>
    public void TellAll(MotionEventKind kind, float speed, float strength) => events.TellAll(feet, kind, speed, strength);

    /// <summary>What is in the way of each foot that swings.</summary>
    public ReadOnlySpan<SwingClearance> Ways => ways;

    /// <summary>Asks memory for what it remembers of each foot.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch()
    {
        int read = MemoryLines.Touch(feet, body.Legs.Length);
        foreach (SwingClearance way in ways)
        {
            read ^= way.Fetch();
        }

        return read;
    }

    /// <summary>Takes over where the feet of another are.</summary>
    public void CopyFrom(FootPlanner other)
    {
        other.feet.CopyTo(feet, 0);
        for (int i = 0; i < ways.Length; i++)
        {
            ways[i].CopyFrom(other.ways[i]);
        }

        aimDecay = other.aimDecay;
    }

    /// <summary>Moves the origin of the world.</summary>
    public void Rebase(Vector3 offset)
    {
        foreach (ref Foot foot in feet.AsSpan())
        {
            foot.Plan.From.Position += offset;
            foot.Plan.To.Position += offset;
            foot.Plan.Wanted += offset;
            foot.Plan.Sought += offset;
        }
    }

    /// <summary>Has a standing body set a foot ahead of its home, metres of the model.</summary>
    public void SetAhead(int leg, float distance) => (feet[leg].Plan.Ahead, feet[leg].Plan.AsNear) = (distance, false);

    /// <summary>Decides what standing feet do next: whether they leave the ground when the gait has them do so, and whether they do so at once.</summary>
    public void Decide(in StepContext step)
    {
        float duty = step.Clock.Duty;
        float cycle = 1f / step.Clock.Frequency;
        var onward = Onward.From(step);
        for (int i = 0; i < feet.Length; i++)
        {
            ref Foot foot = ref feet[i];
            if (foot.Plan.Phase != FootPhase.Stance)
            {
                continue;
            }

            float p = step.Clock.LegPhase(i);
            float u = StepPhase.Swing(p, duty);
            float flight = (1f - p) * cycle;
            float ahead = step.Moving ? StepPhase.ToMidstance(flight, duty, cycle) : flight;
            foot.Plan.Steps = false;
            foot.Plan.AsNear &= !step.Moving && step.RootVelocity.IsToStand;
            bool dragged = foot.Plan.Shift != 0f && FootRelease.IsDragged(foot, body.Legs[i]);
            if (FootRelease.IsDue(ref foot, body, body.Legs[i], step, onward) && (step.Moving || dragged || Wants(i, step, ahead, flight)))
            {
                Release(i, step, (1f - duty) * cycle);
            }
            else if (p < duty)
            {
                foot.Plan.Steps = (duty - p) * cycle < DecisionsAhead * DecisionClock.Period && Wants(i, step, ahead, flight);
            }
            else if (u < (IsFar(i, step) ? LatestRescue : StepPhase.LatestLift) && Wants(i, step, ahead, flight))
            {
                Lift(i, step, u);
                foot.Path.Posture.Begin();
                Aim(i, step, ahead, flight);
            }
        }
    }

    /// <summary>Lets a foot take a step of its own at once: by the turning of the body, a push, or a platform it stands out of reach.</summary>
    private void Release(int leg, in StepContext step, float swing)
    {
        Lift(leg, step, 0f);
        feet[leg].Path.Posture.Begin();
        feet[leg].Plan.Correcting = true;
        feet[leg].Plan.Flight = FootRelease.Flight(swing);
        Aim(leg, step, feet[leg].Plan.Flight, feet[leg].Plan.Flight);
    }

    /// <summary>Lets a foot go that an update has taken from its place: when it was decided last nobody knew how its trunk would lie. It is on its way for half of the update already.</summary>
    /// <param name="leg">Whose, as it has been posed.</param>
    /// <param name="step">The update.</param>
    /// <returns>Whether it goes: it has to be posed anew.</returns>
    public bool TryLetGo(int leg, in StepContext step)
    {
        ref Foot foot = ref feet[leg];
        float swing = (1f - step.Clock.Duty) / step.Clock.Frequency;
        if (!step.Moving && !Wants(leg, step, swing, swing))
        {
            return false;
        }

        Release(leg, step, swing);
        foot.Plan.Swing = Math.Min(0.5f * step.Step / foot.Plan.Flight, LatestJoin);
        return true;
    }

    /// <summary>Moves all feet on by a step of time; the clock has been moved already.</summary>
    public void Advance(in StepContext step)
    {
        float duty = step.Clock.Duty;
        float cycle = 1f / step.Clock.Frequency;
        for (int i = 0; i < feet.Length; i++)
        {
            ref Foot foot = ref feet[i];
            float p = step.Clock.LegPhase(i);
            if (foot.Plan.Arrived && step.Since <= step.Step)
            {
                foot.Plan.Arrived = false;
                StandWhereItIs(i, step);
                foot.Plan.From = foot.Plan.To;
            }

            if (!foot.Plan.Correcting && TakenBack(foot, p, duty))
            {
                foot.Plan.Correcting = true;
                foot.Plan.Flight = FootRelease.Flight((1f - duty) * cycle);
            }

            if (foot.Plan.Correcting)
            {
                Correct(i, step, p, duty, cycle);
            }
            else if (p < duty)
            {
                if (foot.Plan.Phase == FootPhase.Swing)
                {
                    Land(i, step, Math.Min(p * cycle, step.Step));
                }

                else if (step.Step > (1f - duty) * cycle && foot.Plan.Stance > p / duty && !foot.Plan.Held && Wants(i, step, ((0.5f * duty) - p) * cycle, 0f))
                {
                    // Steps so quick that a whole swing has passed unseen: it stepped all the same.
                    Lift(i, step, 0f);
                    Aim(i, step, ((0.5f * duty) - p) * cycle, 0f);
                    Land(i, step, Math.Min(p * cycle, step.Step));
                }

                foot.Plan.Rest(step.Step, p / duty);
            }
            else
            {
                Swing(i, step, StepPhase.Swing(p, duty), duty, cycle);
            }
        }
    }

    /// <summary>Whether the gait has taken back the swing of a foot that has just left the ground: its stances have become longer. Put down at once it would be thrown to its next place; it takes a step of its own.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TakenBack(in Foot foot, float p, float duty) => foot.Plan.Phase == FootPhase.Swing && foot.Plan.Swing < 0.5f && p < duty && p > 0.5f * duty;

    private void Correct(int leg, in StepContext step, float p, float duty, float cycle)
    {
        ref Foot foot = ref feet[leg];
        float u = StepPhase.Swing(p, duty);
        float joined = (u - foot.Plan.Swing) / Math.Max(1f - foot.Plan.Swing, 0.05f);
        if (p >= duty && joined <= LatestJoin)
        {
            // Its own swing has come: it goes on in step with the gait, from where it is.
            foot.Plan.Correcting = false;
            foot.Plan.LiftAt = joined;
            Swing(leg, step, u, duty, cycle);
            return;
        }

        foot.Plan.Swing += step.Step / foot.Plan.Flight;
        if (foot.Plan.Swing >= 1f)
        {
            Land(leg, step, Math.Min((foot.Plan.Swing - 1f) * foot.Plan.Flight, step.Step));
            foot.Plan.Held = p < 0.5f * duty || p >= duty;
            foot.Plan.Stance = foot.Plan.Held ? 0.5f : p / duty;
            foot.Path.Posture.Begin();
            return;
        }

        float flight = (1f - foot.Plan.Swing) * foot.Plan.Flight;
        if (foot.Plan.Swing < StepPhase.Frozen)
        {
            // For the middle of what is left of its stance, or of the next one.
            float stance = Math.Max(((p < duty ? duty - p : 1f - p + duty) * cycle) - flight, 0f);
            Aim(leg, step, flight + (step.Moving ? 0.5f * stance : 0f), flight);
        }
        else
        {
            ComeRound(leg, step, flight);
        }
    }

    private void Swing(int leg, in StepContext step, float u, float duty, float cycle)
    {
        ref Foot foot = ref feet[leg];
        float flight = (1f - u) * (1f - duty) * cycle;
        float ahead = step.Moving ? StepPhase.ToMidstance(flight, duty, cycle) : flight;
        if (foot.Plan.Phase == FootPhase.Swing && u - foot.Plan.LiftAt < (foot.Plan.Swing - 0.5f) * (1f - foot.Plan.LiftAt))
        {
            // Steps so quick that a whole stance has passed unseen: it stood all the same.
            Land(leg, step, Math.Min((duty + (u * (1f - duty))) * cycle, step.Step));
        }

        if (foot.Plan.Phase == FootPhase.Stance)
        {
            if (!foot.Plan.Steps)
            {
                foot.Plan.Held = true;
                foot.Plan.Rest(step.Step, 0f);
                return;
            }

            Lift(leg, step, 0f);
        }

        // A step of its own that the gait has caught up with goes on to the place of the gait's, however far it has come.
        foot.Plan.Swing = (u - foot.Plan.LiftAt) / (1f - foot.Plan.LiftAt);
        if ((foot.Plan.LiftAt < 0f ? u : foot.Plan.Swing) < StepPhase.Frozen)
        {
            Aim(leg, step, ahead, flight);
        }
        else
        {
            ComeRound(leg, step, flight);
        }
    }

    private bool IsFar(int leg, in StepContext step)
    {
        Vector3 away = step.Frame.ToModel(feet[leg].Plan.From.Position) - body.Legs[leg].Home;
        away.Y = 0f;
        return Vec.LengthSquared(away) > Scalar.Square(Far * body.LegLength);
    }

    /// <summary>Whether a foot's next place is far enough from where it stands.</summary>
    private bool Wants(int leg, in StepContext step, float ahead, float flight)
    {
        if (feet[leg].Plan.AsNear && !step.Moving)
        {
            return false;
        }

        NextStance next = Next(leg, step, ahead, flight, out _);
        Vector3 away = step.Frame.ToModel(feet[leg].Plan.From.Position) - next.Place - Rotation.Rotate(AxisRotation.Yaw(next.Yaw), Shift(leg));
        away.Y = 0f;
        return Vec.LengthSquared(away) > Scalar.Square(MinStep * body.LegLength) || Math.Abs(feet[leg].Plan.From.YawFrom(step.Frame) - next.Yaw) > MinTurn;
    }

    private void Lift(int leg, in StepContext step, float at)
    {
        ref Foot foot = ref feet[leg];
        foot.Plan.Phase = FootPhase.Swing;
        foot.Plan.Arrived = false;
        foot.Plan.AsNear = step.Rests;
        foot.Plan.Steps = false;
        foot.Plan.Held = false;
        foot.Plan.Correcting = false;
        foot.Plan.LiftAt = at;
        foot.Plan.Aimed = false;
        foot.Plan.ForGood = false;
        foot.Plan.Swing = 0f;
        foot.Plan.Shift = 0f;
        foot.Plan.Left = Vector3.Zero;
        foot.Plan.Ahead = step.Moving ? 0f : foot.Plan.Ahead;
        events.Tell(MotionEventKind.FootUp, leg, step, foot.Plan.From, 0f);
    }

    private void Land(int leg, in StepContext step, float ago)
    {
        ref Foot foot = ref feet[leg];
        foot.Plan.Phase = FootPhase.Stance;
        foot.Plan.Correcting = false;
        StandWhereItIs(leg, step);
        foot.Plan.From = foot.Plan.To;
        foot.Plan.Arrived = true;
        foot.Plan.AsNear &= step.Rests;
        foot.Plan.Swing = 0f;
        foot.Plan.Reached = float.MaxValue;
        foot.Plan.Missed = foot.Leg.Residual;
        if (foot.Plan.HasTarget)
        {
            events.Tell(MotionEventKind.FootDown, leg, step, foot.Plan.From, ago);
        }
    }

    /// <summary>Lets a foot that its leg did not bring to where it was to come down stand where it is: it would be dragged there.</summary>
    private void StandWhereItIs(int leg, in StepContext step)
    {
        ref Foot foot = ref feet[leg];
        var astray = new Vector3(foot.Leg.Astray.X, 0f, foot.Leg.Astray.Z);
        if (!foot.Plan.HasTarget || Vec.LengthSquared(astray) < Scalar.Square(MaxAstray * body.Legs[leg].Length))
        {
            return;
        }

        // It stays on the tread that it was to come down on if it is not dragged far for that: where it is, as high as that. Its place is off edges already.
        Foothold meant = foot.Plan.To;
        foot.Plan.Shift = 0f;
        Place(leg, step, step.Frame.ToModel(meant.Position) + astray, body.Legs[leg].Home, meant.YawFrom(step.Frame), null, meant.Heading);
        bool isNear = Vec.LengthSquared(astray) < Scalar.Square(MaxDrag * body.Legs[leg].Length);
        if (!foot.Plan.HasTarget || (isNear && Math.Abs(Vec.Dot(foot.Plan.To.Position - meant.Position, meant.Normal)) > OtherTread * body.Legs[leg].Length * step.Frame.Scale))
        {
            foot.Plan.To = meant;
            foot.Plan.To.Position += isNear ? Vec.Reject(Rotation.Rotate(step.Frame.Rotation, astray * step.Frame.Scale), meant.Normal) : Vector3.Zero;
            foot.Plan.HasTarget = true;
        }

        foot.Plan.To.Attach(step.Ground as IMovingGround);
    }

    /// <summary>What a standing body has set a foot away from its home, metres of the model.</summary>
    private Vector3 Offset(int leg) => new(0f, 0f, feet[leg].Plan.Ahead);

    /// <summary>How far a foot is set off an edge, metres of the model.</summary>
    private Vector3 Shift(int leg) => new(0f, 0f, feet[leg].Plan.Shift);
}
