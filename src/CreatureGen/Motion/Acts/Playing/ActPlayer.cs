using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Plays acts one after the other: values of channels that go over from one to the next without a jump, whenever that begins.</summary>
internal sealed class ActPlayer
{
    /// <summary>Rates at which what is left of another act dies away, times √(gravity / leg length), and their bounds per second.</summary>
    private const float FadeRate = 1.6f;
    private const float SlowestFade = 4f;
    private const float FastestFade = 14f;

    /// <summary>What of a foot's way dies away sooner than its height, a factor: it comes down where it belongs.</summary>
    private const float FootRate = 2f;

    /// <summary>What counts as nothing.</summary>
    private const float Nothing = 1e-4f;

    private const int MaxMarks = 16;

    private readonly float[] played = new float[Act.ChannelCount];
    private readonly float[] before = new float[Act.ChannelCount];
    private readonly float[] left = new float[Act.ChannelCount];
    private readonly float[] leaving = new float[Act.ChannelCount];
    private readonly (Act Act, ActMark Mark, float SecondsAgo)[] marks = new (Act, ActMark, float)[MaxMarks];
    private int markCount;
    private int phase;
    private double into;
    private ActGain gain;
    private ReachPlan plan;
    private float side = 1f;
    private float timeUnit;
    private float tempo;
    private float fade;
    private float lastStep;
    private bool waits;
    private bool goesOn;

    /// <summary>What it plays; null for nothing.</summary>
    public Act? Act { get; private set; }

    /// <summary>The phase that it is in.</summary>
    public ActPhase? Phase => Act == null || waits ? null : Act.AllPhases[phase];

    /// <summary>Whether it plays, or something of an act is left.</summary>
    public bool IsActive { get; private set; }

    /// <summary>Whether it waits for the creature to stand.</summary>
    public bool Waits => waits;

    /// <summary>Values of all channels, to be shown.</summary>
    public float[] Values { get; } = new float[Act.ChannelCount];

    /// <summary>What of the reach is that of the act, and not of the one before.</summary>
    public float OwnReach => played[(int)ActChannel.Reach];

    /// <summary>What of it is that of the act before.</summary>
    public float LeftReach => left[(int)ActChannel.Reach];

    /// <summary>What happened in the last step.</summary>
    public ReadOnlySpan<(Act Act, ActMark Mark, float SecondsAgo)> Marks => marks.AsSpan(0, markCount);

    /// <summary>Begins an act, whatever was played before.</summary>
    /// <param name="act">Which.</param>
    /// <param name="gain">Factor on what the body does.</param>
    /// <param name="help">How the trunk helps a tool to its target.</param>
    /// <param name="toSide">1 for an act to the left, −1 to the right.</param>
    /// <param name="seconds">√(leg length / gravity), at its tempo.</param>
    public void Begin(Act act, ActGain gain, in ReachPlan help, float toSide, float seconds)
    {
        BreakOff();
        Act = act;
        phase = 0;
        into = 0;
        this.gain = gain;
        plan = help;
        side = toSide;
        timeUnit = seconds;
        tempo = 1f;
        fade = Scalar.Clamp(FadeRate / seconds, SlowestFade, FastestFade);
        waits = true;
        goesOn = false;
        IsActive = true;
        Leave();
    }

    /// <summary>Leaves a phase that lasts, this one or the next.</summary>
    public void GoOn() => goesOn = true;

    /// <summary>Ends the act where it is.</summary>
    public void Stop()
    {
        if (Act != null)
        {
            BreakOff();
            Act = null;
            Leave();
        }
    }

    /// <summary>Turns what is left of another act over to the other side.</summary>
    public void Mirror()
    {
        for (int i = 0; i < left.Length; i++)
        {
            if (IsOfSide((ActChannel)i))
            {
                left[i] = -left[i];
                leaving[i] = -leaving[i];
            }
        }
    }

    /// <summary>Forgets everything.</summary>
    public void Reset()
    {
        Act = null;
        IsActive = false;
        markCount = 0;
        Array.Clear(played, 0, played.Length);
        Array.Clear(left, 0, left.Length);
        Array.Clear(leaving, 0, leaving.Length);
        Array.Clear(Values, 0, Values.Length);
        Array.Clear(before, 0, before.Length);
    }

    /// <summary>Takes over what another plays.</summary>
    public void CopyFrom(ActPlayer other)
    {
        other.played.CopyTo(played, 0);
        other.before.CopyTo(before, 0);
        other.left.CopyTo(left, 0);
        other.leaving.CopyTo(leaving, 0);
        other.Values.CopyTo(Values, 0);
        other.marks.CopyTo(marks, 0);
        markCount = other.markCount;
        phase = other.phase;
        into = other.into;
        gain = other.gain;
        plan = other.plan;
        side = other.side;
        timeUnit = other.timeUnit;
        tempo = other.tempo;
        fade = other.fade;
        lastStep = other.lastStep;
        waits = other.waits;
        goesOn = other.goesOn;
        Act = other.Act;
        IsActive = other.IsActive;
    }

    /// <summary>Forgets what happened.</summary>
    public void ClearMarks() => markCount = 0;

    /// <summary>Seconds from the beginning to the end of a phase, at a body's time unit.</summary>
    public static float SecondsOf(ActPhase phase, float timeUnit) => Math.Max(phase.Duration * timeUnit, phase.MinSeconds);

    /// <summary>Seconds from the beginning of an act to the end of each of its phases.</summary>
    public static float[] EndsOf(Act act, float timeUnit)
    {
        var ends = new float[act.Phases.Count];
        float sum = 0f;
        for (int i = 0; i < ends.Length; i++)
        {
            ends[i] = sum += SecondsOf(act.Phases[i], timeUnit);
        }

        return ends;
    }

    /// <summary>Goes on.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="pace">Factor on the act's speed.</param>
    /// <param name="stands">Whether the creature stands on its feet.</param>
    public void Advance(float dt, float pace, bool stands)
    {
        tempo = pace;
        Values.CopyTo(before, 0);
        lastStep = dt;
        if (Act != null && waits && (stands || Act.Footing == ActFooting.Free))
        {
            waits = false;
            Mark(ActMark.Begin, dt);
        }

        float own = waits ? 0f : dt * tempo;
        into += own;
        while (Act != null && !waits && Ends(out double seconds))
        {
            ActPhase ended = Act.AllPhases[phase];
            into -= seconds;
            Mark(ended.Mark, (float)into / tempo);
            phase++;
            if (phase == Act.AllPhases.Length)
            {
                Mark(ActMark.End, (float)into / tempo);
                phase--;
                Act = Finish();
            }
        }

        Write();
        IsActive = Act != null || markCount > 0;
        for (int i = 0; i < Values.Length; i++)
        {
            CriticallyDampedSpring.Advance(ref left[i], ref leaving[i], 0f, IsOfFootWay((ActChannel)i) ? FootRate * fade : fade, dt);
            Values[i] = played[i] + left[i];
            IsActive |= Math.Abs(left[i]) > Nothing || Math.Abs(leaving[i]) > Nothing;
        }
    }

    /// <summary>Whether a channel has a sign for the side. Those of one foot or arm have none: what is left of them goes over to the other.</summary>
    private static bool IsOfSide(ActChannel channel) => channel is ActChannel.Aside or ActChannel.Yaw or ActChannel.Roll or ActChannel.BackSide or ActChannel.BackTwist
        or ActChannel.NeckSide or ActChannel.NeckTwist or ActChannel.HeadSide or ActChannel.HeadRoll or ActChannel.TailSide or ActChannel.OnFlank;

    private static bool IsOfFootWay(ActChannel channel) => channel is ActChannel.ForeFeetAhead or ActChannel.ForeFeetOut or ActChannel.ForeFootAhead or ActChannel.ForeFootOut
        or ActChannel.HindFeetAhead or ActChannel.HindFeetOut or ActChannel.HindFootAhead or ActChannel.HindFootOut;

    /// <summary>Whether the phase is over; one that lasts ends when it is told to, and its successor begins at once.</summary>
    private bool Ends(out double seconds)
    {
        ActPhase now = Act!.AllPhases[phase];
        seconds = SecondsOf(now, timeUnit);
        if (!now.Lasts)
        {
            return into >= seconds;
        }

        if (!goesOn || into < seconds)
        {
            return false;
        }

        // What its waves are at goes over.
        goesOn = false;
        seconds = into;
        Leave();
        Play(Act, 1);
        for (int i = 0; i < left.Length; i++)
        {
            left[i] -= played[i];
        }

        return true;
    }

    /// <summary>The act is over: where its channels are dies away.</summary>
    private Act? Finish()
    {
        Play(Act!, 1);
        for (int i = 0; i < left.Length; i++)
        {
            left[i] += played[i];
        }

        return null;
    }

    private void Write()
    {
        if (Act == null || waits)
        {
            Array.Clear(played, 0, played.Length);
        }
        else
        {
            Play(Act, into / SecondsOf(Act.AllPhases[phase], timeUnit));
        }
    }

    /// <summary>Writes what the act comes to, with the help of the trunk.</summary>
    private void Play(Act act, double at)
    {
        ActCurve.Write(act, phase, at, gain, played);
        plan.AddTo(played, played[(int)ActChannel.Reach], side);
    }

    /// <summary>What is shown at present is left behind, with its speed.</summary>
    private void Leave()
    {
        for (int i = 0; i < Values.Length; i++)
        {
            left[i] = Values[i];
            leaving[i] = lastStep > 0f ? (Values[i] - before[i]) / lastStep : 0f;
        }

        Array.Clear(played, 0, played.Length);
    }

    private void BreakOff()
    {
        if (Act != null)
        {
            Mark(ActMark.End, 0f);
        }
    }

    private void Mark(ActMark mark, float secondsAgo)
    {
        if (mark != ActMark.None && markCount < marks.Length)
        {
            marks[markCount++] = (Act!, mark, secondsAgo);
        }
    }
}
