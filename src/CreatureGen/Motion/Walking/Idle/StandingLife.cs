using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Idle;

/// <summary>The idle life of one body: how long it has been, and how calm it is. It calms down while it has nothing to do, and is soon ready when it has; only who is calm rests a foot.</summary>
internal struct StandingLife
{
    /// <summary>Seconds with nothing to do after which it rests a foot as far as it does, and in which that foot is ready again.</summary>
    private const float CalmSeconds = 3f;
    private const float AlertSeconds = 0.3f;

    private float calm;

    /// <summary>How long it has been, seconds.</summary>
    public double Seconds { get; private set; }

    /// <summary>Is put somewhere else.</summary>
    public void Wake() => calm = 0f;

    /// <summary>Lets time pass.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="weight">A factor on all of it.</param>
    /// <param name="free">Whether it stands with nothing to do.</param>
    public IdlePose Follow(LeggedBody body, float dt, float activity, float weight, bool free)
    {
        Seconds += dt;
        calm = Scalar.Clamp(calm + (free ? dt / CalmSeconds : -dt / AlertSeconds), 0f, 1f);
        IdlePose pose = IdleLife.At(body, Seconds, activity, weight);
        return pose with { Rest = pose.Rest * Scalar.Smooth(calm) };
    }
}
