using System;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>The longest way that feet can go along the ground in a stance of a gait without drawing the body down too far or running into one another: measured on the level and on one slope each way, and in proportion between.</summary>
internal readonly struct SlopeStance
{
    /// <summary>Rise of the slopes that are measured (22°).</summary>
    private const float Measured = 0.4f;

    private readonly float up;
    private readonly float down;

    private SlopeStance(float level, float up, float down)
    {
        Level = level;
        this.up = up;
        this.down = down;
    }

    /// <summary>The longest on level ground, metres.</summary>
    public float Level { get; }

    /// <summary>Measures it.</summary>
    public static SlopeStance Of(LeggedBody body, Gait gait)
    {
        float level = OnLevel(body, gait);
        return new SlopeStance(level, Math.Min(level, Reaching(body, gait, Measured)), Math.Min(level, Reaching(body, gait, -Measured)));
    }

    /// <summary>Measures the longest on level ground alone, metres.</summary>
    public static float OnLevel(LeggedBody body, Gait gait) => Math.Min(FootInterference.LongestStance(body, gait), Reaching(body, gait, 0f));

    /// <summary>The longest on a slope, metres.</summary>
    /// <param name="slope">Rise along the way.</param>
    public float At(float slope) => Level + (((slope < 0f ? down : up) - Level) * Math.Min(Math.Abs(slope) / Measured, 1f));

    /// <summary>The longest that all legs reach.</summary>
    private static float Reaching(LeggedBody body, Gait gait, float slope)
    {
        float max = float.MaxValue;
        for (int i = 0; i < body.Legs.Length; i++)
        {
            LegRig leg = body.Legs[i];
            bool front = body.Rows > 1 && leg.Row == body.Rows - 1;
            float bias = body.Rows == 2 ? (front ? gait.ForeBias : gait.HindBias) : body.IsBiped ? gait.HindBias : 0f;
            float along = body.IsBiped || leg.Lateral ? 0f : slope;

            // The hip hangs below the trunk, which lies along the slope.
            float shift = SlopeShift.Ahead(leg, body.Rows, 0f, along) - (along * (body.TrunkRest[leg.TrunkSlot].Y - leg.HipRest.Y));
            TrunkTraits traits = body.Traits;
            max = Math.Min(max, leg.LongestStance(new LegSteps(body.GoingHomes[i], bias, gait.Crouch, front ? traits.ForeSlide : traits.HindSlide, body.IsBiped ? gait.Track : 1f, front ? traits.ChestYaw : traits.PelvisYaw, along, shift)));
        }

        return max;
    }
}
