using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Tells of feet that come down and leave the ground.</summary>
internal sealed class FootEvents
{
    private readonly LeggedBody body;
    private readonly EventQueue events;

    public FootEvents(LeggedBody body, EventQueue events)
    {
        this.body = body;
        this.events = events;
    }

    /// <summary>Tells of a foot.</summary>
    /// <param name="kind">Down or up.</param>
    /// <param name="leg">Whose.</param>
    /// <param name="step">The moment.</param>
    /// <param name="place">Where.</param>
    /// <param name="ago">Seconds since, within the step.</param>
    public void Tell(MotionEventKind kind, int leg, in StepContext step, in Foothold place, float ago)
    {
        int feet = body.Legs.Length;
        float speed = (float)Math.Sqrt((step.RootVelocity.Speed * step.RootVelocity.Speed) + (step.RootVelocity.Sideways * step.RootVelocity.Sideways)) * step.Frame.Scale;
        float strength = (float)PortableMath.Pi / (2f * feet * step.Clock.Duty);
        strength = Scalar.Lerp(1f / feet, strength, step.Activity);
        events.Add(new MotionEvent(kind, leg, body.Legs[leg].Ball, place.Position, place.Normal, place.Surface, speed, strength, step.Left + ago));
    }

    /// <summary>Tells of all feet that stand.</summary>
    public void TellAll(ReadOnlySpan<Foot> feet, MotionEventKind kind, float speed, float strength)
    {
        for (int i = 0; i < feet.Length; i++)
        {
            Foothold place = feet[i].Plan.From;
            if (feet[i].Phase == FootPhase.Stance)
            {
                events.Add(new MotionEvent(kind, i, body.Legs[i].Ball, place.Position, place.Normal, place.Surface, speed, strength, 0f));
            }
        }
    }
}
