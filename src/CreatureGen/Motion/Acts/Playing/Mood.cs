using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How an emotion shows in posture, face and tail, all the time: it comes and goes slowly.</summary>
internal sealed class Mood
{
    /// <summary>How quickly it comes and goes, per second.</summary>
    private const float Rate = 3f;

    private const float Nothing = 1e-4f;

    /// <summary>How often a tail goes to and fro, per time unit, and how much slower that of one who dozes.</summary>
    private const float Wags = 0.4f;
    private const float Drowsy = 0.6f;

    private readonly float[] goal = new float[Act.ChannelCount];
    private readonly float[] shown = new float[Act.ChannelCount];
    private readonly float turnRate;
    private readonly float stance;
    private (float Goal, float Shown) wag;
    private (float Goal, float Shown) verve;
    private float wagPace = 1f;
    private float turn;

    /// <param name="timeUnit">√(leg length / gravity), seconds.</param>
    /// <param name="build">How the body carries itself: insects have no face, and tell by how they stand.</param>
    public Mood(float timeUnit, BodyBuild build)
    {
        turnRate = Wags / timeUnit;
        stance = build == BodyBuild.ManyLegged ? 1f : 0f;
    }

    /// <summary>Factor on the speed of acts.</summary>
    public float Pace { get; private set; } = 1f;

    /// <summary>How springy its steps are (<see cref="Modes.BodyLayer.Verve"/>): who plays prances, the sad drag their feet.</summary>
    public float Verve => verve.Shown;

    /// <summary>Whether anything is shown, or is to be.</summary>
    public bool IsShown { get; private set; }

    /// <summary>Feels something from now on.</summary>
    public void Feel(Emotion emotion)
    {
        float aroused = Math.Max(emotion.Arousal, 0f);
        float drowsy = Math.Max(-emotion.Arousal, 0f);
        float good = Math.Max(emotion.Valence, 0f);
        float bad = Math.Max(-emotion.Valence, 0f);
        float threat = aroused * bad * Math.Max(emotion.Boldness, 0f);
        float fear = aroused * bad * Math.Max(-emotion.Boldness, 0f);
        float play = aroused * good;
        float calm = drowsy * good;
        float sad = drowsy * bad;
        float alert = aroused * Math.Max(1f - threat - fear, 0f);
        Set(ActChannel.NeckPitch, (0.45f * alert) - (0.2f * play) - (0.15f * threat) - (0.35f * fear) - (0.6f * sad) - (0.12f * calm));
        float foreStance = (0.3f * fear) + (0.35f * sad) + (0.25f * calm) - (0.3f * threat) - (0.2f * alert);
        float hindStance = (0.25f * fear) + (0.4f * sad) + (0.3f * calm) + (0.15f * threat) - (0.1f * alert) - (0.15f * play);
        Set(ActChannel.ForeDown, (0.16f * play) + (0.08f * threat) + (0.18f * fear) + (0.07f * sad) + (stance * foreStance));
        Set(ActChannel.HindDown, (0.3f * fear) + (0.04f * sad) + (stance * hindStance));

        // Far ahead, a body stands between stretched legs and is no taller than before.
        Set(ActChannel.Ahead, (0.08f * threat) - (0.14f * fear) - (stance * ((0.05f * threat) + (0.2f * fear))));
        Set(ActChannel.HeadRoll, 0.2f * play);
        Set(ActChannel.Ears, (-0.5f * alert) + (0.9f * threat) + fear + (0.5f * sad) + (0.2f * calm));
        Set(ActChannel.Lids, (-0.1f * aroused) + (0.35f * threat) + (0.5f * calm) + (0.65f * sad) - (0.05f * fear));
        Set(ActChannel.TailPitch, (0.3f * aroused) + (0.2f * threat) - (1.2f * fear) - (0.4f * sad) + (0.1f * calm) + (0.4f * play));
        Set(ActChannel.Jaw, (0.4f * threat) + (0.3f * play));
        Set(ActChannel.Wings, (0.5f * threat) + (0.2f * play));
        wag.Goal = (0.6f * play) + (0.3f * calm);
        verve.Goal = (0.8f * play) + (0.3f * alert) + (0.25f * threat) - (0.4f * fear) - (0.5f * sad) - (0.2f * calm);
        wagPace = 1f - (Drowsy * calm);
        Pace = 1f + (0.35f * emotion.Arousal) - (0.15f * sad);
        IsShown = true;
    }

    /// <summary>Goes on, and adds what is shown to values.</summary>
    public void Advance(float dt, float[] values)
    {
        float fraction = 1f - (float)PortableMath.Exp(-Rate * dt);
        IsShown = false;
        for (int i = 0; i < shown.Length; i++)
        {
            shown[i] += (goal[i] - shown[i]) * fraction;
            IsShown |= goal[i] != 0f || Math.Abs(shown[i]) > Nothing;
        }

        wag.Shown += (wag.Goal - wag.Shown) * fraction;
        verve.Shown += (verve.Goal - verve.Shown) * fraction;
        turn += turnRate * wagPace * dt;
        turn -= (float)Math.Floor(turn);
        AddTo(values);
    }

    /// <summary>Shows at once what it feels.</summary>
    public void Settle()
    {
        goal.CopyTo(shown, 0);
        wag.Shown = wag.Goal;
        verve.Shown = verve.Goal;
        IsShown = Array.Exists(shown, value => value != 0f);
    }

    /// <summary>Adds what is shown to values.</summary>
    public void AddTo(float[] values)
    {
        for (int i = 0; i < shown.Length; i++)
        {
            values[i] += shown[i];
        }

        values[(int)ActChannel.TailSide] += wag.Shown * (float)PortableMath.Sin(PortableMath.Tau * turn);
    }

    /// <summary>Takes over what another feels.</summary>
    public void CopyFrom(Mood other)
    {
        other.goal.CopyTo(goal, 0);
        other.shown.CopyTo(shown, 0);
        (wag, verve, wagPace, turn) = (other.wag, other.verve, other.wagPace, other.turn);
        Pace = other.Pace;
        IsShown = other.IsShown;
    }

    private void Set(ActChannel channel, float value) => goal[(int)channel] = value;
}
