using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// How a body shows what speeds it up or slows it down: it crouches and leans into a start, chest down and neck stretched ahead, and sits back on its hind legs, which brace, as it brakes, with chest and
/// head up.
/// </summary>
/// <param name="HindDrop">How far its rear comes down, metres.</param>
/// <param name="ForeDrop">The same of its front, negative for up.</param>
/// <param name="Shift">How far it goes ahead over its feet, metres.</param>
/// <param name="Lean">How far two-legged ones lean ahead, radians.</param>
/// <param name="Tuck">How far hips come under it, part of how far its back bends with its feet.</param>
/// <param name="Neck">How far the neck is stretched ahead, radians; negative for up and back.</param>
internal readonly record struct Effort(float HindDrop, float ForeDrop, float Shift, float Lean, float Tuck, float Neck)
{
    /// <summary>Most that counts, parts of gravity.</summary>
    private const float Max = 0.5f;

    // Leg lengths for each part of gravity.
    private const float CrouchOfStart = 0.16f;
    private const float DropOfStart = 0.33f;
    private const float SitOfBraking = 0.24f;
    private const float RiseOfBraking = 0.10f;
    private const float ShiftOfStart = 0.14f;
    private const float ShiftOfBraking = 0.20f;

    // Radians, and parts of a bend, for each part of gravity.
    private const float LeanOfStart = 0.40f;
    private const float LeanOfBraking = 0.45f;
    private const float UprightLean = 1.8f;
    private const float TuckOfStart = 0.6f;
    private const float TuckOfBraking = 1.2f;
    private const float NeckOfStart = 0.9f;
    private const float NeckOfBraking = 0.9f;

    /// <summary>Rise of the ground along the way at which nothing of it is shown: legs that climb have no room left to crouch.</summary>
    private const float Steep = 0.7f;

    // What of it low bodies and pillars show.
    private const float LateralFraction = 0.3f;
    private const float ColumnarFraction = 0.6f;

    /// <summary>Height of the belly below which a body on legs under it comes down less, leg lengths: long low ones would dive at each start.</summary>
    private const float LowBelly = 0.68f;

    // The front of bodies that fly stays up, for the room that their wings need; necks and backs of such show nothing.
    private const float WingedRiseOfStart = 0.02f;
    private const float WingedRiseOfBraking = 0.04f;

    /// <summary>The effort of an acceleration.</summary>
    /// <param name="body">Gives build and size.</param>
    /// <param name="acceleration">Ahead, parts of gravity.</param>
    /// <param name="climb">Rise of the ground along the way: uphill the weight brakes, downhill it speeds up, and what it does the legs need not.</param>
    public static Effort Of(LeggedBody body, float acceleration, float climb)
    {
        float push = Scalar.Clamp(acceleration < 0f ? Math.Min(acceleration + Math.Max(climb, 0f), 0f) : Math.Max(acceleration + Math.Min(climb, 0f), 0f), -Max, Max);
        push *= Math.Max(1f - (Math.Abs(climb) / Steep), 0f);
        float shown = body.LegLength * (body.Legs[0].Lateral ? LateralFraction : body.Subject.Plan == BodyPlan.Columnar ? ColumnarFraction : 1f);
        float leaning = push * (body.Subject.Plan == BodyPlan.Upright ? UprightLean : 1f);
        if (body.Subject.Plan is BodyPlan.Flapping or BodyPlan.Buzzing)
        {
            return push > 0f
                ? new Effort(CrouchOfStart * push * shown, -WingedRiseOfStart * push * shown, ShiftOfStart * push * shown, LeanOfStart * leaning, 0f, 0f)
                : new Effort(-SitOfBraking * push * shown, WingedRiseOfBraking * push * shown, ShiftOfBraking * push * shown, LeanOfBraking * leaning, 0f, 0f);
        }

        float drop = push * shown * (body.Legs[0].Lateral ? 1f : Math.Min(body.BellyHeight / (LowBelly * body.LegLength), 1f));
        return push > 0f
            ? new Effort(CrouchOfStart * drop, DropOfStart * drop, ShiftOfStart * push * shown, LeanOfStart * leaning, TuckOfStart * push, NeckOfStart * push)
            : new Effort(-SitOfBraking * drop, RiseOfBraking * push * shown, ShiftOfBraking * push * shown, LeanOfBraking * leaning, -TuckOfBraking * push, NeckOfBraking * push);
    }
}
