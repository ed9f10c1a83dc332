using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Gaze;

namespace CreatureGen.Motion.Clips;

/// <summary>A creature that goes straight ahead in one movement until it repeats itself, or that comes to where a movement begins that happens once.</summary>
internal sealed class SteadyMotion
{
    /// <summary>Seconds of a movement that has no cycle, of a creature without legs.</summary>
    private const float IdleSeconds = 4f;

    /// <summary>Seconds after which a movement has come to repeat itself.</summary>
    public const float SettleSeconds = 5f;

    private const float MeasureStep = 1f / 480f;
    private const float LongestCycle = 6f;

    /// <summary>Leg lengths above the ground where a landing begins and a take-off ends.</summary>
    private const float PassageHeight = 3f;

    private const float LongestPassage = 20f;

    private readonly Movement movement;
    private readonly IGround ground;
    private readonly float idleSeconds;
    private LookAngles look;

    /// <summary>Starts from standing.</summary>
    public SteadyMotion(MotionProfile profile, Movement movement, IGround ground)
    {
        this.movement = movement;
        this.ground = ground;
        Animator = movement.Begin(profile, ground);
        Animator.Hold(default(StandingAct));
        idleSeconds = (float?)profile.Legs?.Idle.Period ?? IdleSeconds;
    }

    /// <summary>Whether it begins anew after a time: all but what leads from one movement to another.</summary>
    public bool Closes => movement.Kind == ClipKind.Lasting;

    /// <summary>What moves it.</summary>
    public CreatureAnimator Animator { get; }

    /// <summary>Goes on for a time: in the movement, or in what comes before one that happens once.</summary>
    public void Settle(float seconds)
    {
        MotionInput before = movement.Kind switch
        {
            ClipKind.TakeOff => default,
            ClipKind.Landing => movement.Input with { ClimbRate = -movement.Input.ClimbRate, Medium = MotionMedium.Air },
            ClipKind.Escape => movement.Input with { Escape = EscapeTurn.None },
            _ => movement.Input,
        };
        for (float time = 0f; time < seconds; time += 1f / 60f)
        {
            Advance(1f / 60f, before);
        }

        if (movement.Act != null)
        {
            // What lasts is there for its least time.
            Animator.Perform(movement.Act);
            Animator.GoOn();
        }

        for (float time = 0f; movement.Kind == ClipKind.Landing && Height > PassageHeight && time < LongestPassage; time += 1f / 60f)
        {
            Advance(1f / 60f);
        }
    }

    /// <summary>Whether a movement happens once and is over.</summary>
    private bool IsOver => movement.Kind switch
    {
        ClipKind.TakeOff => Height > PassageHeight,
        ClipKind.Escape => !Animator.Escapes,
        ClipKind.Act => Animator.Act == null,
        _ => Animator.IsAtRest,
    };

    /// <summary>Leg lengths above the origin.</summary>
    private float Height => Animator.Root.Position.Y / Math.Max(Animator.Profile.LegLength, 1e-3f);

    /// <summary>Goes on by one update.</summary>
    public void Advance(float step) => Advance(step, movement.Kind == ClipKind.Landing && Animator.StandsOnFeet ? default : movement.Input);

    private void Advance(float step, in MotionInput input)
    {
        // It looks straight ahead, or where the recording has it look: glances of its own would not repeat.
        float height = Animator.Profile.Subject.StandingHeight;
        Vector3 ahead = Rotation.Rotate(look.Turn(), new Vector3(0f, 0f, 100f * height));
        Animator.LookAt = Animator.Root.Position + Rotation.Rotate(Animator.Root.Rotation, ahead + new Vector3(0f, height, 0f));
        Animator.Update(step, input, ground);
    }

    /// <summary>Holds head, lids and ears as they are so many seconds into a recording: a creature that stands looks about and blinks; in a cycle that would come at every round.</summary>
    /// <param name="seconds">Into the recording.</param>
    /// <param name="whole">Its length, seconds.</param>
    public void Live(float seconds, float whole)
    {
        bool stands = Closes && !movement.IsCyclic && movement.Input.Speed == 0f;
        look = stands ? StandingScript.LookAt(seconds / whole, movement.Glances) : default;
        Animator.Hold(movement.IsCyclic ? default : StandingScript.ActAt(seconds, whole));
    }

    /// <summary>Goes on to the next beginning of the cycle and from there to the one after. A movement that happens once stays at its beginning.</summary>
    /// <returns>Seconds between the two, or from beginning to end; the period of its rest where nothing repeats.</returns>
    public float CycleSeconds()
    {
        if (!Closes)
        {
            return PassageSeconds();
        }

        if (!movement.IsCyclic)
        {
            return idleSeconds;
        }

        float began = -1f;
        float before = Animator.Phase;
        for (float time = MeasureStep; time < 2f * LongestCycle; time += MeasureStep)
        {
            Advance(MeasureStep);
            float phase = Animator.Phase;
            if (phase < before - 0.5f)
            {
                // Where between the two updates the cycle began.
                float beyond = phase / (phase + 1f - before);
                float at = time - (MeasureStep * beyond);
                if (began >= 0f)
                {
                    return at - began;
                }

                began = at;
            }

            before = phase;
        }

        return idleSeconds;
    }

    /// <summary>How long the movement takes a creature of the same kind.</summary>
    private float PassageSeconds()
    {
        var trial = new SteadyMotion(Animator.Profile, movement, ground);
        trial.Settle(SettleSeconds);
        float time = 0f;
        do
        {
            trial.Advance(MeasureStep);
            time += MeasureStep;
        }
        while (!trial.IsOver && time < LongestPassage);

        return time;
    }
}
