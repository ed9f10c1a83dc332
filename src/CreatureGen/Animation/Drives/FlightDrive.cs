using System.Numerics;
using CreatureGen.Animation.Events;
using CreatureGen.Animation.Grounds;
using CreatureGen.Animation.RootMotion;
using CreatureGen.Animation.Strokes;
using CreatureGen.Animation.Strokes.Flight;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Drives;

/// <summary>Drives a flier: on its legs, if it has legs that walk, while it is on the ground, on its wings else.</summary>
internal sealed class FlightDrive : IBodyMotion
{
    /// <summary>How far down the ground is looked for, metres of the model.</summary>
    private const float Lookout = 200f;

    private readonly FlightProfile profile;
    private readonly Locomotion.LeggedMotion? legs;
    private readonly EventQueue events;
    private FlightState state;

    public FlightDrive(FlightProfile profile, Locomotion.LeggedMotion? legs, EventQueue events)
    {
        this.profile = profile;
        this.legs = legs;
        this.events = events;
    }

    /// <summary>Most beats of wings in the longest update.</summary>
    public const int MostBeats = 8;

    public float Speed { get; private set; }

    public float Phase => Walks ? legs!.Phase : (float)state.Cycle;

    public float Frequency => Walks ? legs!.Frequency : state.BeatFrequency;

    /// <summary>Whether it is on its legs.</summary>
    public bool Walks => legs != null && state.Phase == FlightPhase.Grounded && state.Airborne == 0f;

    public RootPlace Drive(RootPlace place, float dt, in MotionInput input, LocomotionSettings settings, IGround ground, in Pose local)
    {
        if (Walks && input.Medium == MotionMedium.Ground)
        {
            // The walk writes over all that standing wings left to it.
            Fly(place, dt, input, settings, ground, local);
            place = legs!.Drive(place, dt, input, settings, ground, local);
            Speed = legs.Speed;
            return place;
        }

        RootVelocity velocity = Fly(place, dt, input, settings, ground, local);
        Speed = velocity.Forward;
        RootPlace next = RootStep.Advance(place, new RootVelocity(velocity.Forward * place.Scale, velocity.Up * place.Scale, velocity.YawRate), dt);
        if (Walks)
        {
            legs!.Stand(next, settings, ground, local);
        }

        return next;
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, LocomotionSettings settings, IGround ground, in Pose local)
    {
        float height = HeightOf(goal, settings, ground);
        MotionMedium medium = height > 0.3f ? MotionMedium.Air : MotionMedium.Ground;
        Fly(goal, dt, RootStep.Asked(place, dt, goal, medium), settings, ground, local);
        if (Walks && medium == MotionMedium.Ground)
        {
            legs!.Follow(place, dt, goal, settings, ground, local);
        }
    }

    public void Stand(in RootPlace place, LocomotionSettings settings, IGround ground, in Pose local)
    {
        state = default;
        Fly(place, 0f, default, settings, ground, local);
        legs?.Stand(place, settings, ground, local);
    }

    public void Rebase(Vector3 offset) => legs?.Rebase(offset);

    private RootVelocity Fly(in RootPlace place, float dt, in MotionInput input, in LocomotionSettings settings, IGround ground, in Pose local)
    {
        FlightIntent intent = input.Medium == MotionMedium.Air ? FlightIntent.Air : FlightIntent.Ground;
        float scale = place.Scale;
        var asked = new FlightInput(intent, input.Speed / scale, input.TurnRate, input.ClimbRate / scale, HeightOf(place, settings, ground));
        RootVelocity velocity = FlightMotion.Update(profile, asked, ref state, dt, local);
        for (int k = state.BeatsBegun - 1; k >= 0; k--)
        {
            float ago = state.SecondsSinceBeat + (k / state.BeatFrequency);
            events.Add(new MotionEvent(MotionEventKind.WingBeat, -1, profile.Shoulder, place.Position, Rotation.Rotate(place.Rotation, Vector3.UnitY), 0, velocity.Forward * scale, state.BeatWidth, ago));
        }

        return velocity;
    }

    /// <summary>Height of the root above the ground, metres of the model.</summary>
    private static float HeightOf(in RootPlace place, in LocomotionSettings settings, IGround ground)
    {
        float above = place.Scale;
        return ground.Cast(place.Position + (settings.Up * above), -settings.Up, (Lookout * place.Scale) + above, out GroundHit hit)
            ? Vec.Dot(place.Position - hit.Point, settings.Up) / place.Scale
            : Lookout;
    }
}
