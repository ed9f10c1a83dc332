using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion.Toolkit.Clips;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// A clip in a few kilobytes: as few keys as its precision allows, rotations and positions in 48 bits each. It is sampled as it lies, without being unpacked. Immutable; any number of threads may sample it. Made by <see cref="ClipCompression"/>.
/// </summary>
/// <remarks>
/// The bytes hold a track of rotations and one of positions for each joint in turn, as what they differ by from the skeleton at rest: a track that stays at rest takes one byte. Of a rotation the component of the largest
/// magnitude is left out, the others take 15 bits each within the range of their track; of a position each takes 16.
/// </remarks>
public sealed class CompressedClip : IClip
{
    /// <summary>Of a frame, by which times of frames are rounded: a step falls at its frame, not behind it.</summary>
    private const float Rounding = 1e-3f;

    private readonly Skeleton skeleton;
    private readonly byte[] data;
    private readonly int frames;
    private readonly KeyInterpolation interpolation;

    internal CompressedClip(IClip source, Skeleton skeleton, int frames, KeyInterpolation interpolation, byte[] data)
    {
        Name = source.Name;
        End = source.End;
        Duration = source.Duration;
        Speed = source.Speed;
        Events = source.Events;
        EventSpan = source.EventSpan;
        this.skeleton = skeleton;
        this.frames = frames;
        this.interpolation = interpolation;
        this.data = data;
    }

    /// <inheritdoc/>
    public string Name { get; }

    /// <inheritdoc/>
    public ClipEnd End { get; }

    /// <inheritdoc/>
    public float Duration { get; }

    /// <inheritdoc/>
    public float Speed { get; }

    /// <inheritdoc/>
    public int Joints => skeleton.Count;

    /// <inheritdoc/>
    public IReadOnlyList<ClipEvent> Events { get; }

    /// <inheritdoc/>
    public float EventSpan { get; }

    /// <summary>Bytes that its motion takes.</summary>
    public int Size => data.Length;

    /// <inheritdoc/>
    public void Sample(float time, in Pose local)
    {
        float within = ClipTime.Within(time, Duration, End);
        local.Require(skeleton);
        float frame = Math.Min(within / Duration * (frames - 1), frames - 1);
        frame = interpolation == KeyInterpolation.Step ? (float)Math.Floor(frame + Rounding) : frame;
        var reader = new PackedReader(data, frames, End == ClipEnd.Loops, interpolation);
        for (int i = 0; i < skeleton.Count; i++)
        {
            local.Rotations[i] = reader.Rotation(frame, skeleton.LocalRotations[i]);
            local.Positions[i] = reader.Position(frame, skeleton.LocalPositions[i]);
        }
    }
}
