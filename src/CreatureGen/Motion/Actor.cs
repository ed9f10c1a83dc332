using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Acts.Rehearsing;
using CreatureGen.Motion.Falling;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>One creature on the scene that performs: it tries on a stage of its own how its trunk helps to reach a target, then plays.</summary>
internal sealed class Actor
{
    /// <summary>How far to the right a target is, units, before the right side takes it.</summary>
    private const float RightOf = 0.02f;

    /// <summary>Moments of acts in an update at most.</summary>
    private const int MaxEvents = 16;

    private readonly ActBody body;
    private readonly ActStage stage;
    private readonly ActEvent[] events = new ActEvent[MaxEvents];
    private Performer kept;
    private bool keptAll;
    private int eventCount;

    public Actor(CreatureActs acts)
    {
        body = acts.Body;
        stage = acts.Stage();
        Performer = new Performer(body, acts.Room);
        kept = new Performer(body, acts.Room);
    }

    /// <summary>What it shows.</summary>
    public Performer Performer { get; private set; }

    /// <summary>What it does by itself; null for nothing.</summary>
    public IdleActs? IdleActs { get; set; }

    /// <summary>What its acts ask of trunk, feet and wings; null for nothing.</summary>
    public BodyLayer? Layer => Performer.Trunk;

    /// <summary>Goes back to what it performed before the update that failed.</summary>
    public void Undo()
    {
        (Performer, kept) = (kept, Performer);
        keptAll = false;
        IdleActs?.Undo();
    }

    /// <summary>Moments of acts in the last update.</summary>
    public ReadOnlySpan<ActEvent> Events => events.AsSpan(0, eventCount);

    /// <summary>Forgets these.</summary>
    public void ClearEvents() => eventCount = 0;

    /// <summary>Lets acts go on.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="locomotion">How it moves.</param>
    /// <param name="input">What it is asked to do.</param>
    /// <param name="settings">Gravity.</param>
    /// <param name="idles">How readily it does something by itself; 0 not at all.</param>
    /// <returns>What it is to do: to stand, where an act needs that.</returns>
    public MotionInput Begin(float dt, in RootPlace root, in Locomotion locomotion, in MotionInput input, in MotionSettings settings, float idles)
    {
        Keep();
        FallingMode? mode = locomotion.Mode;
        if (mode == null)
        {
            return input;
        }

        Idle(dt, root, locomotion, settings, idles);

        if (Performer.IsLimp && !mode.IsLimp)
        {
            // It is up, or on its way there: what it would have done lying is over.
            Performer.Reset();
        }
        else if (mode.State != BodyState.Supported && !Performer.IsLimp)
        {
            Performer.Stop();
        }

        bool holds = Performer.HoldsFeet;
        if (Performer.IsActive)
        {
            bool stands = locomotion.Legs is { Stands: true } && mode.StandsOnFeet;
            Performer.Advance(dt, locomotion.Legs == null || stands, root);
            if (stands)
            {
                Performer.LayFeetAlong(ActGround.Under(locomotion.Legs!.Feet, root));
            }
        }

        return holds ? new MotionInput(0f) : input;
    }

    /// <summary>Breaks off what it performs, as the creature is put somewhere else.</summary>
    public void Reset()
    {
        kept.CopyFrom(Performer);
        keptAll = false;
        Performer.Reset();
    }

    /// <summary>Tells what happened, once the pose is written.</summary>
    public void Tell(in RootPlace root, in Pose model)
    {
        foreach ((Act act, ActMark mark, float ago) in Performer.Marks)
        {
            if (eventCount < events.Length)
            {
                Vector3 place = Performer.PlaceOf(act, model, root, out int joint);
                events[eventCount++] = new ActEvent(act, mark, joint, place, ago);
            }
        }

        Performer.ClearMarks();
    }

    /// <summary>Begins an act, or says why not.</summary>
    /// <param name="ability">What.</param>
    /// <param name="target">Where.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="gravity">Metres per second squared, of the world.</param>
    public ActStart Begin(ActAbility ability, in ActTarget target, in RootPlace root, float gravity)
    {
        Act act = ability.Act;
        float unit = body.TimeUnit(gravity / root.Scale) * ActTempo.Of(act, body);
        float? toContact = SecondsToContact(act, unit);
        ActAim aim = ability.UsualAim;
        if (act.Reaches && target.Point is not Vector3)
        {
            aim = aim with { Target = root.ToWorld(aim.Target), Own = aim.Target };
        }
        else if (act.Reaches)
        {
            Vector3 there = root.ToModel(target.Point!.Value);
            aim = new ActAim(act.Tool, there.X < -RightOf * body.Unit, there, act.SnoutDown, default);
            float missing = ReachSearch.Find(stage, body, act, ability.Parts, ref aim);
            if (missing > Rehearsal.MaxMiss * Rehearsal.ReachLength(act, body))
            {
                string reason = FormattableString.Invariant($"the target is out of reach: {act.Name} would miss it by {missing * root.Scale:0.00} m");
                return new ActStart(ActStatus.OutOfReach, reason, toContact, missing * root.Scale);
            }

            aim = aim with { Target = root.ToWorld(there) };
        }

        Performer.Begin(act, aim, ability.Parts, unit);
        return new ActStart(ActStatus.Started, null, toContact, 0f);
    }

    /// <summary>Keeps what was before. What performs nothing stays as it is, and is kept once.</summary>
    private void Keep()
    {
        if (Performer.IsActive || !keptAll)
        {
            kept.CopyFrom(Performer);
            keptAll = !Performer.IsActive;
        }

        IdleActs?.Keep();
    }

    /// <summary>Begins, leaves and breaks off what it does by itself.</summary>
    private void Idle(float dt, in RootPlace root, in Locomotion locomotion, in MotionSettings settings, float idles)
    {
        if (IdleActs == null)
        {
            return;
        }

        FallingMode mode = locomotion.Mode!;
        bool stands = mode.State == BodyState.Supported && (locomotion.Legs == null ? body.Build != BodyBuild.Airborne : locomotion.Legs.Stands && mode.StandsOnFeet);
        switch (IdleActs.Advance(dt, stands ? idles : 0f, Performer.Act, out ActAbility? next))
        {
            case IdleChange.Begins:
                Begin(next!, default, root, settings.Gravity);
                break;
            case IdleChange.GoesOn:
                Performer.GoOn();
                break;
            case IdleChange.BreaksOff:
                Performer.Stop();
                break;
        }
    }

    private static float? SecondsToContact(Act act, float unit)
    {
        int told = act.ToldIn;
        if (told < 0)
        {
            return null;
        }

        float sum = 0f;
        for (int i = 0; i <= told; i++)
        {
            sum += ActPlayer.SecondsOf(act.AllPhases[i], unit);
        }

        return sum;
    }
}
