using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking;

/// <summary>How far a standing body shifts its weight: as far as its hips and ankles go without a foot being drawn along.</summary>
internal static class WeightShift
{
    /// <summary>How far a foot that stands may be off, parts of its leg.</summary>
    private const float MaxSlip = 0.003f;

    // Shares of the usual shift that are tried, and moments of a period at which the weight is on a side.
    private static readonly float[] fractions = { 1f, 0.7f, 0.5f, 0.35f, 0.2f, 0.1f };
    private static readonly float[] moments = { 0.2f, 0.45f, 0.7f, 0.95f };

    /// <summary>The share of the usual shift, 0..1.</summary>
    /// <param name="body">Whose; its share is set on the way.</param>
    /// <param name="gaits">Its gaits.</param>
    public static void Find(LeggedBody body, GaitSet gaits)
    {
        var legs = new WalkingMode(body, gaits, new EventQueue(0));
        int count = body.Skeleton.Count;
        var local = new Pose(new Quaternion[count], new Vector3[count]);
        var model = new Pose(new Quaternion[count], new Vector3[count]);
        MotionSettings settings = MotionSettings.Default;
        settings.Idle = 0f;
        local.SetToRest(body.Skeleton);
        legs.Stand(RootPlace.Identity, settings, FlatGround.Level, null, local);
        ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        var stands = new (Vector3 Ball, Vector3 Sole)[body.Legs.Length];
        for (int i = 0; i < stands.Length; i++)
        {
            stands[i] = (model.Positions[body.Legs[i].Ball], SoleMiddle.Of(body.Legs[i], body.Skeleton, model));
        }

        settings.Idle = 1f;
        double seconds = 0;
        foreach (float fraction in fractions)
        {
            body.ShiftWeight = fraction;
            float slip = 0f;
            foreach (float moment in moments)
            {
                // On to the same moment of the next period.
                double past = seconds / body.Idle.Period;
                double step = (moment - (past - Math.Floor(past)) + 1) * body.Idle.Period;
                seconds += (float)step;
                local.SetToRest(body.Skeleton);
                legs.Hold(RootPlace.Identity, (float)step, settings, null, local);
                ForwardKinematics.LocalToModel(body.Skeleton, local, model);
                for (int i = 0; i < stands.Length; i++)
                {
                    LegRig leg = body.Legs[i];
                    if (moment < 0.5f && body.RestPitch(i) > 0f)
                    {
                        // It rests on its tip.
                        continue;
                    }

                    float off = Math.Min(Vec.Distance(model.Positions[leg.Ball], stands[i].Ball), Vec.Distance(SoleMiddle.Of(leg, body.Skeleton, model), stands[i].Sole));
                    slip = Math.Max(slip, off / leg.Length);
                }
            }

            if (slip <= MaxSlip)
            {
                return;
            }
        }
    }
}
