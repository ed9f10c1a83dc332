using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>How the body moves over the ground, in its own axes, and what it is going over to.</summary>
internal struct RootVelocity
{
    /// <summary>Seconds ahead for which turns are kept within bounds.</summary>
    private const float Foresight = 0.25f;

    /// <summary>How often what is left of a way with a turn is cut as it comes to a stand, for speed and turn fall differently and each piece is an arc; each is so much longer than the one before it.</summary>
    private const int Arcs = 20;
    private const float FirstArc = 0.02f;
    private const float ArcGrowth = 1.2f;

    /// <summary>Seconds after which it stands.</summary>
    private const float AtRest = 20f;

    private IntendedSpeed ahead;
    private IntendedSpeed aside;
    private IntendedSpeed yaw;

    /// <summary>How quickly it may change.</summary>
    public VelocityBounds Bounds;

    /// <summary>Metres per second ahead.</summary>
    public readonly float Speed => ahead.Speed;

    /// <summary>Metres per second to the left.</summary>
    public readonly float Sideways => aside.Speed;

    /// <summary>Radians per second to the left.</summary>
    public readonly float Turn => yaw.Speed;

    /// <summary>Metres per second ahead that it is going over to.</summary>
    public readonly float GoalSpeed => ahead.Goal;

    /// <summary>Metres per second squared ahead.</summary>
    public readonly float Acceleration => ahead.IsSteady ? 0f : ahead.Acceleration(Bounds.Along);

    /// <summary>Whether it is to stand.</summary>
    public readonly bool IsToStand => ahead.Goal == 0f && aside.Goal == 0f && yaw.Goal == 0f;

    /// <summary>Whether it comes to a stand on its way to going the other way.</summary>
    public readonly bool TurnsBack => ahead.Speed * ahead.Goal < 0f;

    /// <summary>Whether it comes to a stand, and does not stand yet.</summary>
    public readonly bool Stops => IsToStand && !(ahead.IsSteady && aside.IsSteady && yaw.IsSteady);

    /// <summary>Steady motion.</summary>
    public static RootVelocity At(float speed, float sideways, float turn) => new() { ahead = IntendedSpeed.At(speed), aside = IntendedSpeed.At(sideways), yaw = IntendedSpeed.At(turn) };

    /// <summary>Asks for another motion. Turns are no sharper than the grip allows at the present speed and at that of a moment later.</summary>
    public void Ask(float speed, float sideways, float turn)
    {
        ahead.Ask(speed);
        aside.Ask(sideways);
        float fastest = Math.Max(Math.Abs(Speed), Math.Abs(SpeedAfter(Foresight)));
        float sharpest = fastest > 0f ? Bounds.Aside / fastest : float.MaxValue;
        yaw.Ask(Scalar.Clamp(turn, -sharpest, sharpest));
    }

    /// <summary>Changes it at once; what it is going over to stays.</summary>
    public void Push(float ahead, float aside, float yaw)
    {
        this.ahead.Push(ahead);
        this.aside.Push(aside);
        this.yaw.Push(yaw);
    }

    /// <summary>Goes on for a time, and tells the way gone meanwhile.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="turned">Turn in that time, radians.</param>
    /// <returns>Displacement in the axes at the start.</returns>
    public Vector3 Advance(float dt, out float turned)
    {
        float forward = ahead.Advance(dt, Bounds.Along);
        float left = aside.Advance(dt, Bounds.Along);
        float turn = yaw.Advance(dt, Bounds.Yaw);
        turned = turn * dt;
        return Along(forward, left, turn, dt);
    }

    /// <summary>Where the body will be after a time.</summary>
    public readonly Vector3 Predict(float dt, out float turned)
    {
        RootVelocity later = this;
        return later.Advance(dt, out turned);
    }

    /// <summary>Where the body will come to rest, of one that stops.</summary>
    /// <param name="turned">Turn until then, radians.</param>
    /// <returns>Displacement in the axes at present.</returns>
    public readonly Vector3 PredictRest(out float turned)
    {
        RootVelocity later = this;
        Vector3 way = Vector3.Zero;
        turned = 0f;
        float seconds = FirstArc;
        for (int i = 0; i < Arcs && later.Turn != 0f; i++)
        {
            way += Rotation.Rotate(AxisRotation.Yaw(turned), later.Advance(seconds, out float more));
            turned += more;
            seconds *= ArcGrowth;
        }

        way += Rotation.Rotate(AxisRotation.Yaw(turned), later.Advance(AtRest, out float last));
        turned += last;
        return way;
    }

    /// <summary>How far it would go if it were to stop now, straight on.</summary>
    /// <returns>Displacement in the axes at present.</returns>
    public readonly Vector3 StoppingWay()
    {
        RootVelocity later = At(0f, 0f, 0f);
        (later.ahead, later.aside, later.Bounds) = (ahead, aside, Bounds);
        later.ahead.Ask(0f);
        later.aside.Ask(0f);
        return later.Advance(AtRest, out _);
    }

    /// <summary>Speed ahead after a time.</summary>
    public readonly float SpeedAfter(float dt)
    {
        IntendedSpeed later = ahead;
        later.Advance(dt, Bounds.Along);
        return later.Speed;
    }

    /// <summary>Turn after a time, radians per second to the left.</summary>
    public readonly float TurnAfter(float dt)
    {
        IntendedSpeed later = yaw;
        later.Advance(dt, Bounds.Yaw);
        return later.Speed;
    }

    /// <summary>Displacement along an arc at steady speeds.</summary>
    private static Vector3 Along(float ahead, float left, float turn, float dt)
    {
        float angle = turn * dt;
        float a;
        float b;
        if (Math.Abs(angle) < 1e-3f)
        {
            a = dt;
            b = 0.5f * angle * dt;
        }
        else
        {
            PortableMath.SinCos(angle, out double sine, out double cosine);
            a = (float)(sine / turn);
            b = (float)((1 - cosine) / turn);
        }

        return new Vector3((left * a) + (ahead * b), 0f, (ahead * a) - (left * b));
    }
}
