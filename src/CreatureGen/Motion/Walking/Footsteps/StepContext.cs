using System.Numerics;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What the feet are told in a step of time.</summary>
internal readonly struct StepContext
{
    /// <summary>Activity of a body below which it counts as still.</summary>
    public const float MinActivity = 0.02f;

    public StepContext(in RootPlace frame, in RootVelocity velocity, GaitClock clock, in MotionSettings settings, IGround ground, float step, float since, float left, float activity, bool moving, float slope)
    {
        Frame = frame;
        RootVelocity = velocity;
        Clock = clock;
        Up = settings.Up;
        Ground = ground;
        Step = step;
        Since = since;
        Left = left;
        Activity = activity;
        Moving = moving;
        Slope = slope;
        Stops = velocity.Stops;
        if (Stops)
        {
            Rest = velocity.PredictRest(out float yaw);
            RestYaw = yaw;
        }
    }

    /// <summary>Where the creature is at the end of the step. A field, as the velocity is: both are called upon, and a property would be copied for it.</summary>
    public readonly RootPlace Frame;

    public readonly RootVelocity RootVelocity;

    public GaitClock Clock { get; }

    /// <summary>Against gravity, unit, world space.</summary>
    public Vector3 Up { get; }

    public IGround Ground { get; }

    /// <summary>Seconds.</summary>
    public float Step { get; }

    /// <summary>Seconds from the last pose to the end of this step.</summary>
    public float Since { get; }

    /// <summary>Seconds from the end of this step to the end of the update.</summary>
    public float Left { get; }

    /// <summary>0 stands, 1 walks.</summary>
    public float Activity { get; }

    /// <summary>Whether it goes or turns.</summary>
    public bool Moving { get; }

    /// <summary>Whether it stands still: what comes down then stands for good.</summary>
    public bool Rests => !Moving && Activity < MinActivity;

    /// <summary>Rise of the ground along the way, over some steps.</summary>
    public float Slope { get; }

    /// <summary>Whether it comes to a stand.</summary>
    public bool Stops { get; }

    /// <summary>Where the root will come to rest then, model space.</summary>
    public Vector3 Rest { get; }

    /// <summary>How far it will turn until then, radians.</summary>
    public float RestYaw { get; }
}
