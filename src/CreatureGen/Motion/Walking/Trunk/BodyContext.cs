using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>What the body goes by in an update. What is large is in fields: what is read of a property is read of a copy of all of it.</summary>
internal readonly struct BodyContext
{
    public BodyContext(GaitClock clock, in RootVelocity velocity, in MotionSettings settings, float step, float activity, in IdlePose idle, float acceleration, float upright, float bow, float facing)
    {
        Clock = clock;
        RootVelocity = velocity;
        Settings = settings;
        Step = step;
        Activity = activity;
        Idle = idle;
        Acceleration = acceleration;
        Upright = upright;
        Bow = bow;
        Facing = facing;
    }

    public GaitClock Clock { get; }

    public readonly RootVelocity RootVelocity;

    public readonly MotionSettings Settings;

    /// <summary>Seconds.</summary>
    public float Step { get; }

    /// <summary>0 stands, 1 walks.</summary>
    public float Activity { get; }

    public readonly IdlePose Idle;

    /// <summary>Metres per second squared ahead.</summary>
    public float Acceleration { get; }

    /// <summary>How much of its posture for standing the trunk is in, 0..1.</summary>
    public float Upright { get; }

    /// <summary>How much farther the fore body is let down than the hind body, metres.</summary>
    public float Bow { get; }

    /// <summary>Yaw of what head and chest turn to, seen from the root, radians; 0 for nothing.</summary>
    public float Facing { get; }
}
