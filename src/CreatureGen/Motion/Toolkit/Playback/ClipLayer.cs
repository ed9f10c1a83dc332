using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How a layer lies on what is below it.</summary>
public enum LayerKind
{
    /// <summary>It takes the place of what is below, as far as its weight goes.</summary>
    Covers,

    /// <summary>What it differs by from its clip's first moment comes on top of what is below.</summary>
    Adds,
}

/// <summary>A clip on top of others, on some joints or all: a wave of the hand on a walk, a breath on everything. Belongs to a <see cref="ClipPlayer"/>.</summary>
public sealed class ClipLayer
{
    private readonly float[] mask;
    private ClipCursor cursor;
    private float weight;

    internal ClipLayer(IClip clip, LayerKind kind, ReadOnlySpan<float> mask)
    {
        cursor = new ClipCursor(clip);
        Kind = kind;
        this.mask = mask.ToArray();
        weight = 1f;
    }

    /// <summary>How it lies on what is below.</summary>
    public LayerKind Kind { get; }

    /// <summary>The part of it that shows on each joint, 0..1; empty for all of it on every joint.</summary>
    public ReadOnlySpan<float> Mask => mask;

    /// <summary>What plays in it.</summary>
    public IClip Clip => cursor.Clip;

    /// <summary>Seconds from the beginning of its clip.</summary>
    public float Time => cursor.Time;

    /// <summary>Whether a clip that stays at its end has come there.</summary>
    public bool IsFinished => cursor.IsFinished;

    /// <summary>Seconds of the clip for each that passes; below 0 backwards. Default: 1.</summary>
    public float Speed { get; set; } = 1f;

    /// <summary>How much of it shows, 0..1. At 0 it costs nothing and its clip stands. Default: 1.</summary>
    /// <exception cref="ArgumentException">It is set to a number that is not finite or out of its range.</exception>
    public float Weight
    {
        get => weight;
        set
        {
            Finite.RequireWithin(value, 0f, 1f, nameof(value));
            weight = value;
        }
    }

    /// <summary>Goes to a time of its clip; nothing on the way there happens.</summary>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public void Seek(float time) => cursor.Seek(time);

    internal ClipPassage Advance(float seconds) => cursor.Advance(seconds * Speed);
}
