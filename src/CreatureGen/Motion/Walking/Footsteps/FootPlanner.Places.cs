using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <content>Where feet are put without a step, and where they stand next.</content>
internal sealed partial class FootPlanner
{
    /// <summary>Sets all feet down at home.</summary>
    public void PlaceAll(in StepContext step)
    {
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i] = default;
            ref Foot foot = ref feet[i];
            foot.Leg = LegOutcome.AtRest(body.Legs[i]);
            Target(i, step, 0f, body.Legs[i].Home, body.Legs[i].Home, 0f, step.Frame.Rotation);
            feet[i].Plan.To.Attach(step.Ground as IMovingGround);
            foot.Plan.From = foot.Plan.To;
            foot.Plan.Stance = 0.5f;
        }
    }

    /// <summary>Sets all feet where they would be in their stride at the speed and place in the cycle.</summary>
    public void PlaceInStride(in StepContext step)
    {
        float duty = step.Clock.Duty;
        float cycle = 1f / step.Clock.Frequency;
        for (int i = 0; i < feet.Length; i++)
        {
            float p = step.Clock.LegPhase(i);
            feet[i] = default;
            feet[i].Leg = LegOutcome.AtRest(body.Legs[i]);
            Aim(i, step, ((0.5f * duty) - p) * cycle, 0f);
            feet[i].Plan.From = feet[i].Plan.To;
            feet[i].Plan.Stance = Math.Min(p / duty, 1f);
            if (p >= duty)
            {
                feet[i].Plan.Phase = FootPhase.Swing;
                feet[i].Plan.Swing = StepPhase.Swing(p, duty);
                feet[i].Plan.Aimed = false;
                Aim(i, step, (1f - p + (0.5f * duty)) * cycle, (1f - p) * cycle);
            }
        }
    }

    /// <summary>Whether a foot is in the air or away from its home.</summary>
    public bool IsUnsettled(in RootPlace frame, float activity, GaitClock clock)
    {
        for (int i = 0; i < feet.Length; i++)
        {
            if (feet[i].Plan.Phase == FootPhase.Swing)
            {
                return true;
            }

            if (feet[i].Plan.AsNear)
            {
                continue;
            }

            Vector3 away = frame.ToModel(feet[i].Plan.From.Position) - GaitFootholds.Under(body, i, activity, clock, 0f, 0f) - (Offset(i) * (1f - activity)) - Shift(i);
            away.Y = 0f;
            if (Vec.LengthSquared(away) > Scalar.Square(MinStep * body.LegLength) || Math.Abs(feet[i].Plan.From.YawFrom(frame)) > 2f * MinTurn)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Where a foot will stand next: for good once the body comes to a stand, as soon as its leg reaches that and while there is time for it.</summary>
    private NextStance Next(int leg, in StepContext step, float ahead, float flight, out bool forGood)
    {
        if (!step.Stops)
        {
            forGood = false;
            return NextStance.Going(body, leg, step, Offset(leg), ahead);
        }

        // What is received may be what the plan remembers: it is written last.
        ref readonly FootPlan plan = ref feet[leg].Plan;
        NextStance last = NextStance.Last(body, leg, step, Offset(leg));
        bool stays = plan.ForGood || ((plan.Phase == FootPhase.Stance || plan.Swing < StepPhase.LatestLift) && last.IsReached(body, leg, step, flight));
        forGood = stays;
        return stays ? last : NextStance.Going(body, leg, step, Offset(leg), ahead);
    }
}
