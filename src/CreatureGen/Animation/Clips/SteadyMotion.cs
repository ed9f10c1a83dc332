using System.Numerics;
using CreatureGen.Animation.Aiming;
using CreatureGen.Animation.Grounds;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Clips;

/// <summary>A creature that goes straight ahead in one movement until it repeats itself.</summary>
internal sealed class SteadyMotion
{
    /// <summary>Seconds of a movement that has no cycle.</summary>
    public const float IdleSeconds = 4f;

    /// <summary>Seconds into a movement without a cycle at which the eyes blink.</summary>
    private const float BlinkAt = 1.4f;

    private const float MeasureStep = 1f / 480f;
    private const float LongestCycle = 6f;

    private readonly Movement movement;
    private readonly IGround ground;

    /// <summary>Starts from standing.</summary>
    public SteadyMotion(MotionProfile profile, Movement movement, IGround ground)
    {
        this.movement = movement;
        this.ground = ground;
        Animator = movement.Begin(profile, ground);
        Animator.HoldLids(0f);
    }

    /// <summary>What moves it.</summary>
    public CreatureAnimator Animator { get; }

    /// <summary>Goes on for a time.</summary>
    public void Settle(float seconds)
    {
        for (float time = 0f; time < seconds; time += 1f / 60f)
        {
            Advance(1f / 60f);
        }
    }

    /// <summary>Goes on by one update.</summary>
    public void Advance(float step)
    {
        // It looks straight ahead: glances would not repeat.
        float height = Animator.Profile.Creature.StandingHeight;
        Animator.LookAt = Animator.Root.Position + Rotation.Rotate(Animator.Root.Rotation, new Vector3(0f, height, 100f * height));
        Animator.Update(step, movement.Input, ground);
    }

    /// <summary>Holds the lids as they are so many seconds into a recording: one blink of a creature that stands, none in a cycle, where it would come at every round.</summary>
    public void Blink(float seconds) => Animator.HoldLids(movement.IsCyclic ? 0f : Blinks.Once(seconds - BlinkAt));

    /// <summary>Goes on to the next beginning of the cycle and from there to the one after.</summary>
    /// <returns>Seconds between the two; <see cref="IdleSeconds"/> where nothing repeats.</returns>
    public float CycleSeconds()
    {
        if (!movement.IsCyclic)
        {
            return IdleSeconds;
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

        return IdleSeconds;
    }
}
