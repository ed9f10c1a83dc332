using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Steps;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <content>Where a swing goes. What is asked is followed smoothly; the place on the ground that belongs to it may be another tread from one moment to the next, and the swing comes round to that until its target stays where it is.</content>
internal sealed partial class FootPlanner
{
    /// <summary>How quickly a swing takes up a change of what is asked, per second.</summary>
    private const float AimRate = 15f;

    /// <summary>Seconds in which a foot is brought to a place that changes late at least: after a long update it may change by a sixth of a leg in the last moment.</summary>
    private const float LastSeconds = 0.03f;

    /// <summary>How far the place that is asked for goes on until ground is sought anew, leg lengths.</summary>
    private const float SeekAgain = 0.03f;

    /// <summary>Sets the target of a swing.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="step">The moment.</param>
    /// <param name="ahead">Seconds to the middle of the stance to come.</param>
    /// <param name="flight">Seconds until it comes down.</param>
    private void Aim(int leg, in StepContext step, float ahead, float flight)
    {
        ref Foot foot = ref feet[leg];
        NextStance stance = Next(leg, step, ahead, flight, out foot.Plan.ForGood);
        Quaternion heading = UnitRotation.Renormalize(Rotation.Multiply(step.Frame.Rotation, AxisRotation.Yaw(stance.Yaw)));

        // Who stands shifts its weight, and on level ground its feet go home whatever its hips do.
        Vector3 next = step.Frame.ToWorld(step.Moving || step.Ground is not IPlaneGround ? LandingRange.Within(body, body.Legs[leg], foot.Leg, step.RootVelocity, flight, stance.Place) : stance.Place);
        bool goesOn = foot.Plan.Swing > 0f && foot.Plan.Aimed;
        Foothold before = foot.Plan.To;
        Vector3 moved = next - foot.Plan.Wanted;
        if (goesOn)
        {
            float fraction = TakenUp(foot.Plan.Swing, flight, foot.Plan.ForGood, step);
            moved *= fraction;
            heading = fraction < 1f ? UnitRotation.Nlerp(before.Heading, heading, fraction) : heading;
        }

        foot.Plan.Wanted += moved;
        Target(leg, step, flight, step.Frame.ToModel(foot.Plan.Wanted), stance.Home, stance.Yaw, heading);
        foot.Plan.Left = Vector3.Zero;
        if (goesOn && step.Ground is not IPlaneGround)
        {
            Vector3 goal = foot.Plan.To.Position;
            foot.Plan.To.Approach(before, moved - (step.Up * Vec.Dot(moved, step.Up)), TakenUp(foot.Plan.Swing, flight, true, step));
            foot.Plan.Left = goal - foot.Plan.To.Position;
        }

        foot.Plan.To.Attach(step.Ground as IMovingGround);
        search.Survey(step, leg, foot, ways[leg]);
        foot.Plan.Aimed = true;
    }

    /// <summary>Brings a swing whose target stays where it is to what is left of the way there; one that moves it follows as it is.</summary>
    private void ComeRound(int leg, in StepContext step, float flight)
    {
        ref FootPlan plan = ref feet[leg].Plan;
        if (plan.Left != Vector3.Zero && plan.To.Platform == 0)
        {
            plan.Near(Math.Min(step.Step / Math.Max(flight, step.Step), 1f));
        }
    }

    /// <summary>How much of a change of the target is taken up in a step of time; where it is to be there by then, all by the time at which the target stays where it is.</summary>
    private float TakenUp(float swing, float flight, bool arrives, in StepContext step)
    {
        float fraction = aimDecay.Fraction(AimRate * step.Step);
        float left = flight * (StepPhase.Frozen - swing) / (1f - swing);
        return arrives && left > 0f ? Math.Max(fraction, Math.Min(step.Step / Math.Max(left, LastSeconds), 1f)) : fraction;
    }

    /// <summary>Sets a foot on the ground under where it goes, off edges and out of walls: all of that is found at once, and anew only as what is asked for goes on or the place comes to be in a wall.</summary>
    private void Target(int leg, in StepContext step, float flight, Vector3 wanted, Vector3 home, float yaw, Quaternion heading)
    {
        ref Foot foot = ref feet[leg];
        bool inWall = foot.Plan.To.InWall;
        Vector3? before = foot.Plan.Aimed ? foot.Plan.Goal : null;
        bool seeks = !foot.Plan.Aimed || Vec.LengthSquared(foot.Plan.Wanted - foot.Plan.Sought) > Scalar.Square(SeekAgain * body.Legs[leg].Length * step.Frame.Scale);
        if (!seeks)
        {
            Place(leg, step, wanted, home, yaw, before, heading);
            seeks = foot.Plan.To.InWall && !inWall;
        }

        if (seeks)
        {
            foot.Plan.Shift = search.OffEdges(step, leg, foot, before, flight, wanted, home, yaw);
            foot.Plan.Sought = foot.Plan.Wanted;
            Place(leg, step, wanted, home, yaw, before, heading);
        }
    }

    /// <summary>Sets a foot on the ground under a place.</summary>
    private void Place(int leg, in StepContext step, Vector3 wanted, Vector3 home, float yaw, Vector3? before, Quaternion heading)
    {
        ref Foot foot = ref feet[leg];
        foot.Plan.HasTarget = search.Find(step, leg, wanted, home, yaw, foot.Plan.Shift, before, out foot.Plan.To);
        foot.Plan.To.Heading = heading;
    }
}
