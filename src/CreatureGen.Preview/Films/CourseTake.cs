using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Clips;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Films;

/// <summary>A creature on a course, recorded 60 times a second, and the camera that goes along with it.</summary>
internal sealed class CourseTake
{
    /// <summary>Moments a second.</summary>
    public const int Rate = 60;

    // Moments before and after over which the camera's way is evened out.
    private const int Evening = 15;

    // Places between the creature and the edge of the floor at which its height is looked at; the nearest is left out, as a single step hides little.
    private const int RiseSamples = 8;

    private readonly Creatures.Creature creature;
    private readonly List<Moment> moments = [];
    private readonly List<ClipEvent> events = [];
    private readonly CourseSurface surface;

    /// <summary>Records a course from standing at the origin.</summary>
    public CourseTake(MotionProfile profile, CourseScript script, CourseGround ground)
    {
        creature = profile.Subject.Creature!;
        Script = script;
        var simulation = new CourseSimulation(profile, script, ground, CourseRate.Of(Rate));
        surface = simulation.Surface;
        Record(simulation);
        foreach (float _ in simulation.Updates())
        {
            Record(simulation);
            Listen(simulation.Animator);
        }
    }

    /// <summary>What was asked.</summary>
    public CourseScript Script { get; }

    /// <summary>Moments, the first before anything was asked.</summary>
    public int Moments => moments.Count;

    /// <summary>What happened, seconds from the first moment.</summary>
    public IReadOnlyList<ClipEvent> Events => events;

    /// <summary>Number of feet.</summary>
    public int Feet => moments[0].Feet.Length;

    /// <summary>Which command it obeys.</summary>
    public int CommandAt(int moment) => moments[moment].Command;

    /// <summary>Where its root is, world space.</summary>
    public RootPlace PlaceAt(int moment) => moments[moment].Place;

    /// <summary>Metres per second ahead.</summary>
    public float SpeedAt(int moment) => moments[moment].Speed;

    /// <summary>What its gait is called; null without one.</summary>
    public string? GaitAt(int moment) => moments[moment].Gait;

    /// <summary>How a foot is.</summary>
    public FootReport FootAt(int moment, int foot) => moments[moment].Feet[foot];

    /// <summary>The ground's own axes.</summary>
    public RootPlace FrameAt(int moment) => moments[moment].Frame;

    /// <summary>Which way is up at a place.</summary>
    public Vector3 UpAt(Vector3 place) => surface.UpAt(place);

    /// <summary>The water on the ground; null where there is none.</summary>
    public IWaterGround? Water => surface.Ground as IWaterGround;

    /// <summary>A floor of checks around the camera.</summary>
    public IFloor Floor(float check, int patches, float reach) => surface is PipeSurface pipe
        ? new PipeFloor(pipe.Radius, check, reach)
        : new CheckedFloor(surface, check, patches, reach, -reach, reach);

    /// <summary>Where the camera is: it goes along, evened out.</summary>
    /// <param name="moment">When.</param>
    /// <param name="turning">Whether it turns along too, so that it sees the same side at all times.</param>
    public RootPlace CameraAt(int moment, CameraTurn turning)
    {
        Vector3 position = Vector3.Zero;
        Vector3 ahead = Vector3.Zero;
        int count = 0;
        for (int i = Math.Max(0, moment - Evening); i <= Math.Min(Moments - 1, moment + Evening); i++)
        {
            position += moments[i].Place.Position;
            ahead += Rotation.Rotate(moments[i].Place.Rotation, Vector3.UnitZ);
            count++;
        }

        ahead.Y = 0f;
        Quaternion rotation = turning == CameraTurn.Along && surface.IsLevel && Vec.Length(ahead) > 1e-3f * count ? Rotation.FromTo(Vector3.UnitZ, Vec.Normalize(ahead)) : Quaternion.Identity;
        return new RootPlace(position / count, rotation);
    }

    /// <summary>How steeply the ground rises at most from where the creature is towards a camera, degrees.</summary>
    /// <param name="azimuthDegrees">Of the camera, in its axes.</param>
    /// <param name="turning">Whether it turns along.</param>
    /// <param name="reach">How far the ground is drawn, metres.</param>
    /// <param name="every">Every so manieth moment is looked at.</param>
    public double SteepestRise(double azimuthDegrees, CameraTurn turning, float reach, int every)
    {
        Vector3 towards = new CameraAngle(azimuthDegrees, 0).TowardsCamera;
        double steepest = 0;
        for (int moment = 0; moment < Moments; moment += every)
        {
            RootPlace camera = CameraAt(moment, turning);
            for (int i = 2; i <= RiseSamples; i++)
            {
                float away = reach * i / RiseSamples;
                if (surface.HeightAt(camera.Position, reach) is float here && surface.HeightAt(camera.ToWorld(towards * away), 2f * reach) is float there)
                {
                    steepest = Math.Max(steepest, PortableMath.Atan2(there - here, away));
                }
            }
        }

        return steepest * 180 / PortableMath.Pi;
    }

    /// <summary>Skin and normals in a camera's axes, metres.</summary>
    public (Vector3[] Positions, Vector3[] Normals) SkinAt(int moment, in RootPlace camera) => MovedSkin.Of(creature, moments[moment].Place, moments[moment].Local, camera);

    /// <summary>Where the feet stand, and above which places they swing, in a camera's axes.</summary>
    public ContactMark[] MarksAt(int moment, in RootPlace camera)
    {
        Moment at = moments[moment];
        return ContactMark.Of(at.Feet, MovedSkin.Joints(creature.Skeleton, at.Place, at.Local), surface.Below, camera);
    }

    private void Listen(CreatureAnimator animator)
    {
        float now = (Moments - 1) / (float)Rate;
        foreach (MotionEvent one in animator.Events)
        {
            if (ClipEvents.NameOf(one.Kind) is { } name)
            {
                events.Add(new ClipEvent(Math.Max(now - one.SecondsAgo, 0f), name, creature.Skeleton.Joints[one.Joint].Name, Math.Max(one.Strength, 0f)));
            }
        }

        foreach (ActEvent one in animator.ActEvents)
        {
            if (ClipEvents.NameOf(one.Act, one.Mark) is { } name)
            {
                events.Add(new ClipEvent(Math.Max(now - one.SecondsAgo, 0f), name, one.Joint < 0 ? string.Empty : creature.Skeleton.Joints[one.Joint].Name, 1f));
            }
        }
    }

    private void Record(CourseSimulation simulation)
    {
        CreatureAnimator animator = simulation.Animator;
        var feet = new FootReport[animator.FootCount];
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i] = animator.Foot(i);
        }

        moments.Add(new Moment(animator.Root, animator.LocalPose.Rotations.ToArray(), animator.LocalPose.Positions.ToArray(), feet, simulation.Command, animator.Speed, animator.StandsOnFeet ? animator.Gait?.Name : null, simulation.Surface.Frame));
    }

    private sealed record Moment(RootPlace Place, Quaternion[] Rotations, Vector3[] Positions, FootReport[] Feet, int Command, float Speed, string? Gait, RootPlace Frame)
    {
        public Pose Local => new(Rotations, Positions);
    }
}
