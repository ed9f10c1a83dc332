using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Drives an animator along a course, from standing at the origin.</summary>
internal sealed class CourseSimulation
{
    /// <summary>How far jumps go, part of what the creature can, and how hard blows are, part of what throws its body at √(gℓ).</summary>
    private const float JumpFraction = 0.7f;
    private const float BlowFraction = 0.4f;

    private readonly CourseScript script;
    private readonly IEnumerable<double> steps;

    public CourseSimulation(MotionProfile profile, CourseScript script, CourseGround ground, CourseRate rate)
    {
        this.script = script;
        steps = rate.Steps(new Seed(profile.Subject.Seed).Child("courses"));
        Surface = CourseSurfaces.Lay(ground, profile, script);
        Animator = new CreatureAnimator(profile);
        Animator.Teleport(Animator.Root, Surface.Ground);
    }

    /// <summary>Who goes.</summary>
    public CreatureAnimator Animator { get; }

    /// <summary>What it goes over, as it is at present.</summary>
    public CourseSurface Surface { get; }

    /// <summary>Index of the command that the last update obeyed.</summary>
    public int Command { get; private set; }

    /// <summary>Updates one by one until the script is over; gives the seconds of each when it is done.</summary>
    public IEnumerable<float> Updates()
    {
        double time = 0;
        foreach (double step in steps)
        {
            if (script.IsOver(time))
            {
                yield break;
            }

            int index = script.IndexAt(time);
            CourseCommand command = script.Commands[index];
            if (index != Command || time == 0)
            {
                Tell(command);
            }

            Command = index;
            MotionSettings settings = Animator.Settings;
            settings.Walking = settings.Walking with { Gait = command.Gait };
            settings.Up = Surface.UpAt(Animator.Root.Position);
            Animator.Settings = settings;
            Surface.Advance(step);
            Animator.Update((float)step, command.Input, Surface.Ground);
            time += step;
            yield return (float)step;
        }
    }

    /// <summary>Tells the animator of acts, once as the command begins.</summary>
    private void Tell(in CourseCommand command)
    {
        switch (command.Order)
        {
            case ActOrder.GoOn:
                Animator.GoOn();
                break;
            case ActOrder.Stop:
                Animator.StopAct();
                break;
        }

        if (command.Act != null)
        {
            Animator.Perform(command.Act, command.Target);
        }

        Do(command.Body);
    }

    /// <summary>Does to the body what a command says.</summary>
    private void Do(BodyCommand command)
    {
        switch (command)
        {
            case BodyCommand.GoLimp:
                Animator.GoLimp();
                break;
            case BodyCommand.GetUp:
                Animator.GetUp();
                break;
            case BodyCommand.Jump:
                Animator.Jump(Animator.Root.ToWorld(new Vector3(0f, 0f, JumpFraction * Animator.JumpReach.Length)));
                break;
            case BodyCommand.HitLeft:
                Hit(-Vector3.UnitX);
                break;
            case BodyCommand.HitRight:
                Hit(Vector3.UnitX);
                break;
            case BodyCommand.HitFront:
                Hit(-Vector3.UnitZ);
                break;
            case BodyCommand.HitBehind:
                Hit(Vector3.UnitZ);
                break;
            case BodyCommand.KnockDown:
                Hit(-2f * Vector3.UnitX);
                break;
        }
    }

    /// <summary>Hits the head, or what carries the body.</summary>
    /// <param name="way">Where to in model space, and how many times as hard as usual.</param>
    private void Hit(Vector3 way)
    {
        MotionProfile profile = Animator.Profile;
        float speed = (float)Math.Sqrt(Animator.Settings.Gravity * profile.Fall.Value.Height);
        int head = Math.Max(profile.Subject.Skeleton.FirstOf(Rigging.JointRole.Head), profile.Fall.Value.Body);
        Animator.Hit(head, Rotation.Rotate(Animator.Root.Rotation, way) * (BlowFraction * speed * profile.Fall.Value.Mass));
    }
}
