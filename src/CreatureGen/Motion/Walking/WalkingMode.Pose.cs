using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Motion.Walking.Poses;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking;

/// <content>How it is posed: feet, body, legs, head, arms and tail.</content>
internal sealed partial class WalkingMode
{
    /// <summary>Writes the pose of a body that may rest as it stands and step, or of one that is held.</summary>
    /// <param name="placement">Where the root is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="asked">What can be set.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="ground">Where feet find footing; null where they stay where they are.</param>
    /// <param name="local">Receives the pose.</param>
    private void Pose(in RootPlace placement, float dt, in MotionSettings asked, BodyLayer? layer, IGround? ground, in Pose local)
    {
        MotionSettings settings = asked with { Gravity = GravityOf(asked, placement.Scale) };
        float held = layer?.Still ?? 0f;
        bool free = ground != null && activity < MinActivity && held < MinActivity;
        IdlePose idle = life.Follow(body, dt, activity, settings.Idle * (1f - held), free);
        if (restless.Follow(body, life.Seconds, dt, free && settings.Idle > 0f, out int leg, out float ahead))
        {
            planner.SetAhead(leg, ahead * body.LegLength);
        }

        Span<FootPose> poses = stackalloc FootPose[body.Legs.Length];
        PoseFeet(placement, dt, settings, layer, idle.Rest, poses);
        idle = idle with { Breath = idle.Breath - Sink };
        Raise(dt, settings.Gravity);
        var context = new BodyContext(clock, velocity, settings, dt, activity, idle, acceleration, Raised, Bow, Facing);
        placer.Place(context, layer, planner.Feet, poses);
        poser.PoseTrunk(placer, local);
        PoseLegs(placement, dt, settings, layer, ground, poses, local);
        HeadPosture.Pose(body, turns, placer, context, local);
        ArmSwing.Pose(body, turns, placer, context, local);
        FlipperPosture.Pose(body, turns, placer, context, local);
        TailPosture.Pose(body, turns, placer, context, local);
        if (winged)
        {
            sway.Follow(placer.Bounce, placer.Scissor * activity, acceleration / settings.Gravity, placer.Balance, idle.Wings, (float)Math.Sqrt(body.LegLength / settings.Gravity), dt);
            wings?.Write(layer?.Wings ?? 0f, activity, sway, local);
        }
    }

    /// <summary>Brings the trunk into its posture: down at once, up after the last step.</summary>
    private void Raise(float dt, float gravity)
    {
        float froude = velocity.Speed * velocity.Speed / (gravity * body.LegLength);
        float wanted = StandingPosture.Fraction(activity, froude, Sink / body.LegLength);
        Raised = arrived ? wanted : Raised + ((wanted - Raised) * raiseDecay.Fraction((wanted < Raised ? LowerRate : RaiseRate) * dt));
        arrived = false;
    }

    /// <summary>Finds where feet are, of whom nothing is posed yet.</summary>
    private void PlaceFeet(in RootPlace placement, in MotionSettings settings, BodyLayer? layer)
    {
        Span<FootPose> poses = stackalloc FootPose[body.Legs.Length];
        PoseFeet(placement, 0f, settings, layer, 0f, poses);
    }

    private void PoseFeet(in RootPlace placement, float dt, in MotionSettings settings, BodyLayer? layer, float rest, Span<FootPose> poses)
    {
        GaitNumbers numbers = Numbers(dt, settings, layer);
        for (int i = 0; i < poses.Length; i++)
        {
            FootPoser.Pose(body.Legs[i], ref planner.Feet[i], planner.Ways[i], placement, numbers, rest * body.RestPitch(i), out poses[i]);
            planner.Feet[i].Path.Taken = planner.Feet[i].Path.Aloft = planner.Feet[i].Path.Lean = 0f;
            if (layer != null)
            {
                FootPoser.Add(body.Legs[i], layer.Feet[i], ref planner.Feet[i], ref poses[i]);
            }
        }
    }

    private void PoseLegs(in RootPlace placement, float dt, in MotionSettings settings, BodyLayer? layer, IGround? ground, Span<FootPose> poses, in Pose local)
    {
        float tuck = clock.Shape.Tuck * activity;
        float trail = clock.TrailIn(settings.Gravity) * activity;
        for (int i = 0; i < poses.Length; i++)
        {
            ref Foot foot = ref planner.Feet[i];
            if (layer != null && body.Front.Exists && layer.Feet[i].Loose > 0f && layer.Feet[i].Carried == 0f)
            {
                FootPoser.Trail(body.Legs[i], placer.Trunk, Math.Min(layer.Feet[i].Loose, 1f), ref foot, ref poses[i]);
            }

            if (placer.Trunk.IsRaised && body.Front.Carries(body.Legs[i]))
            {
                FootPoser.Carry(body.Legs[i], placer.Trunk, layer!.Feet[i], ref foot, ref poses[i]);
            }

            // Where no time passes nothing rolls: the pose before it may be of another moment.
            foot.Leg.Turned.Stood &= dt > 0f;
            poser.PoseLeg(i, placer, ref foot, poses[i], tuck, trail, local);
            if (ground != null && FootRelease.IsTorn(foot, body.Legs[i], dt) && planner.TryLetGo(i, new StepContext(placement, velocity, clock, settings, ground, dt, dt, 0f, activity, moving, placer.Climb)))
            {
                FootPoser.Pose(body.Legs[i], ref foot, planner.Ways[i], placement, Numbers(0f, settings, layer), 0f, out poses[i]);
                poser.PoseLeg(i, placer, ref foot, poses[i], tuck, trail, local);
            }
        }

        if (ground != null)
        {
            pace.Bound(dt, planner.Feet, local);
        }
        else
        {
            // Who is held, or put somewhere, is as it is at once.
            pace.Show(local);
        }
    }

    private GaitNumbers Numbers(float dt, in MotionSettings settings, BodyLayer? layer) =>
        new(clock.Duty, clock.Shape.Lift * settings.Walking.Lift * (1f + (layer?.Verve ?? 0f)), clock.Shape.ForceDip, activity, activity * clock.Length * FootRoll.Going(velocity.Speed, settings.Gravity * body.LegLength), clock.Cycle, clock.Swing, dt);
}
