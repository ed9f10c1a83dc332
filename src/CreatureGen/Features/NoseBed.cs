using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The skin below a nose of leather, filled up to an even curved face, so that what is laid on it has an even edge.</summary>
internal readonly struct NoseBed
{
    /// <summary>Where the skin is measured, in half widths and half heights of the pad from its middle.</summary>
    private const float Probe = 0.6f;

    /// <summary>How far it falls back at the edge at most, in half widths.</summary>
    private const float Steepest = 0.6f;

    private readonly Func<Vector3, float> skin;
    private readonly float middle;
    private readonly float slope;
    private readonly float aside;
    private readonly float above;

    /// <summary>Measures it.</summary>
    /// <param name="pad">The pad.</param>
    /// <param name="skin">How far the skin is ahead of a place of the pad's plane, metres.</param>
    public NoseBed(NosePad pad, Func<Vector3, float> skin)
    {
        Pad = pad;
        this.skin = skin;
        middle = skin(pad.Centre);
        float steepest = Steepest * pad.HalfWidth;
        float side = skin(pad.Centre + (Vector3.UnitX * (Probe * pad.HalfWidth))) - middle;
        float up = skin(pad.Centre + (pad.Up * (Probe * pad.HalfHeight))) - middle;
        float down = skin(pad.Centre - (pad.Up * (Probe * pad.HalfHeight))) - middle;
        slope = Scalar.Clamp((up - down) / (2f * Probe), -steepest, steepest);
        aside = Scalar.Clamp(side / (Probe * Probe), -steepest, 0f);
        above = Scalar.Clamp((up + down) / (2f * Probe * Probe), -steepest, 0f);
    }

    /// <summary>Where the nose is and how large.</summary>
    public NosePad Pad { get; }

    /// <summary>How far it is ahead of the pad's plane, metres: nowhere behind the skin.</summary>
    /// <param name="x">Half widths from the middle.</param>
    /// <param name="y">Half heights from the middle.</param>
    public float At(float x, float y) => Math.Max(
        middle + (slope * y) + (aside * x * x) + (above * y * y),
        skin(Pad.Centre + (Vector3.UnitX * (x * Pad.HalfWidth)) + (Pad.Up * (y * Pad.HalfHeight))));
}
