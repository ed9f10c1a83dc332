using System;

namespace CreatureGen.Motion;

/// <content>What it does beside going.</content>
public sealed partial class CreatureAnimator
{
    private Emotion emotion;

    /// <summary>What the creature can do beside going; see <see cref="MotionProfile.Acts"/>.</summary>
    public CreatureActs Acts => Profile.Acts;

    /// <summary>The act that it performs at present; null for none.</summary>
    public Act? Act => actor?.Performer.Act;

    /// <summary>The phase of the act; null for none, and while it waits until the creature stands.</summary>
    public ActPhase? ActPhase => actor?.Performer.Phase;

    /// <summary>What it feels: it shows in posture, ears, lids, tail, jaw and wings, and in the tempo of acts, and comes and goes within about a second.</summary>
    /// <exception cref="ArgumentException">A number is not finite or not within −1..1.</exception>
    public Emotion Emotion
    {
        get => emotion;
        set
        {
            value.ThrowIfInvalid();
            if (value != emotion)
            {
                emotion = value;
                actor ??= new Actor(Acts);
                actor.Performer.Feel(value);
            }
        }
    }

    /// <summary>Moments of acts in the last update.</summary>
    public ReadOnlySpan<ActEvent> ActEvents => actor == null ? default : actor.Events;

    /// <summary>Begins an act that comes with the library, in place of what it performs; see <see cref="Perform(ActAbility, in ActTarget)"/>.</summary>
    /// <param name="act">Its name, whatever its case.</param>
    /// <param name="target">What it goes for.</param>
    /// <exception cref="ArgumentException">There is no act of that name; the message lists all.</exception>
    public ActStart Perform(string act, in ActTarget target = default) => Perform(Acts.Find(act), target);

    /// <summary>Begins an act in place of what it performs: on top of whatever it does, from whatever pose it is in. Acts that need standing feet stop it first. The first act of an animator allocates what it needs; those after it, and all updates, nothing.</summary>
    /// <param name="act">One of <see cref="Acts"/>, or of the game's own (<see cref="CreatureActs.Rehearse"/>).</param>
    /// <param name="target">What it goes for; acts without a target take no notice.</param>
    /// <returns>Whether it has begun, or why not: nothing has changed then.</returns>
    /// <exception cref="ArgumentNullException">There is no act.</exception>
    public ActStart Perform(ActAbility act, in ActTarget target = default)
    {
        if (act == null)
        {
            throw new ArgumentNullException(nameof(act));
        }

        if (act.Refusal != null)
        {
            return new ActStart(ActStatus.Refused, act.Refusal, act.SecondsToContact, 0f);
        }

        actor ??= new Actor(Acts);
        ActStart start = actor.Begin(act, target, root, settings.Gravity);
        if (start.Status == ActStatus.Started && act.Act.FallsFromAir && Mode is { IsInAir: true } falls)
        {
            actor.Performer.GoLimp();
            falls.GoLimp();
        }

        return start;
    }

    /// <summary>Leaves a phase that lasts, as of sitting or sleeping: the act goes on to its end; who fell limp by it gets up. Others take no notice.</summary>
    public void GoOn()
    {
        actor?.Performer.GoOn();
        if (actor is { Performer.IsLimp: true })
        {
            GetUp();
        }
    }

    /// <summary>Breaks the act off where it is: what is left of it dies away. Who fell limp by it stays so until <see cref="GetUp"/>.</summary>
    public void StopAct() => actor?.Performer.Stop();

    /// <summary>How readily it does something by itself: not at all while it is asked to go, attends to something, or is afraid or angry.</summary>
    private float IdlesOf(in MotionInput input)
    {
        bool calm = !(emotion.Arousal > 0f && emotion.Valence < 0f);
        return calm && lookAt == null && input == default ? settings.IdleActs : 0f;
    }
}
