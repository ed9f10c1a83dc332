using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion.Falling;

/// <summary>To which side a body on legs under it rolls as it goes limp: without that it would come to stand on its folded legs, its rump up, and its head would come down below its chest.</summary>
internal struct Topple
{
    /// <summary>Longest time of an update that counts, τ: what falls in slow motion rolls no faster for it.</summary>
    private const float LongestStep = 0.3f;

    /// <summary>Cosines of how far it is tipped over: up to the first it rolls as hard, from the second on it only falls, so that it does not roll onto its back.</summary>
    private const float Upright = 0.94f;
    private const float Tipped = 0.4f;

    /// <summary>How its flank holds it, which is flat where what the ground feels of it is round: what of the roll it takes away, 1/τ, and how fast it brings back a body that is on its back, 1/τ²; sines of how far that is beyond the flank as it begins and as all of it is there; and how long it lasts, τ.</summary>
    private const float Brake = 4f;
    private const float Back = 4f;
    private const float OnFlank = -0.1f;
    private const float BeyondFlank = 0.4f;
    private const float HeldTime = 8f;

    /// <summary>Speed to a side that decides to which it falls, √(gℓ).</summary>
    private const float Deciding = 0.05f;

    /// <summary>Part of a blow across the body from which on it decides instead.</summary>
    private const float Across = 0.2f;

    private ToppleManner manner;
    private bool decided;
    private Vector3 left;
    private Vector3 ahead;
    private Vector3 axis;

    /// <summary>Goes limp.</summary>
    /// <param name="left">Unit, world space, where its left is.</param>
    /// <param name="ahead">Unit, world space, where it faces.</param>
    /// <param name="usual">How it rolls, and to which side if nothing else decides.</param>
    /// <param name="velocity">World m/s.</param>
    /// <param name="unit">√(gℓ), m/s.</param>
    public void Begin(Vector3 left, Vector3 ahead, in ToppleManner usual, Vector3 velocity, float unit)
    {
        float aside = Vec.Dot(velocity, left) / unit;
        (manner, this.left, this.ahead) = (usual, left, ahead);
        decided = Math.Abs(aside) > Deciding;
        bool sinks = !usual.Topples || Vec.Length(velocity) < usual.Least * unit;

        // To the left its back turns from up to left, about what is behind it.
        axis = sinks ? Vector3.Zero : ahead * (aside > Deciding ? -1f : aside < -Deciding ? 1f : -usual.Side);
    }

    /// <summary>Is struck as it goes limp: who did not go to a side topples away from the blow, or to its usual side from one along the body.</summary>
    /// <param name="impulse">World N·s.</param>
    public void Push(Vector3 impulse)
    {
        if (!decided && manner.Topples)
        {
            float across = Vec.Dot(impulse, left);
            float side = Math.Abs(across) < Across * Vec.Length(impulse) ? manner.Side : across;
            axis = ahead * (side > 0f ? -1f : 1f);
        }
    }

    /// <summary>Rolls on.</summary>
    /// <param name="body">What is limp.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="seconds">Since it went limp.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    /// <param name="up">Unit, world space.</param>
    public readonly void Turn(RagdollState body, float dt, float seconds, float tau, Vector3 up)
    {
        if (axis == Vector3.Zero || body.IsAsleep)
        {
            return;
        }

        float step = Math.Min(dt, LongestStep * tau) / tau;
        float upright = Vec.Dot(Rotation.Rotate(body.FirstTurn, Vector3.UnitY), up);
        float share = (float)Scalar.Clamp((upright - Tipped) / (Upright - Tipped), 0, 1) * (1f - Scalar.Smooth(seconds / (manner.Time * tau)));
        if (share > 0f)
        {
            body.Turn(axis * (share * manner.Roll * step / tau));
        }

        float held = Scalar.Smooth((-upright - OnFlank) / (BeyondFlank - OnFlank)) * (1f - Scalar.Smooth(seconds / (HeldTime * tau)));
        if (held > 0f)
        {
            // About its own length, along which its left goes down as its back comes up on that side.
            Vector3 nose = Rotation.Rotate(body.FirstTurn, Vector3.UnitZ);
            float side = Vec.Dot(Rotation.Rotate(body.FirstTurn, Vector3.UnitX), up);
            body.Turn(nose * (held * step * (-Back * side / tau - (Brake * Vec.Dot(body.FirstSpin, nose)))));
        }
    }
}
