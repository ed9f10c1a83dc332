using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A piece of motion as a track of rotations and one of positions for each joint, each with keys of its own. Immutable.</summary>
public sealed class KeyedClip : IClip
{
    private readonly KeyTrack[] rotations;
    private readonly KeyTrack[] positions;

    /// <summary>Takes the tracks.</summary>
    /// <param name="name">Not empty.</param>
    /// <param name="end">What becomes of it at its end.</param>
    /// <param name="duration">Seconds, above 0.</param>
    /// <param name="speed">Metres per second ahead at which the creature has to be moved for its feet not to slide.</param>
    /// <param name="rotations">One for each joint, in the order of the skeleton.</param>
    /// <param name="positions">One for each joint.</param>
    /// <param name="events">What happens in it.</param>
    /// <exception cref="ArgumentException">A name or a list is empty, lists differ in length, or a number is outside its range.</exception>
    public KeyedClip(string name, ClipEnd end, float duration, float speed, IReadOnlyList<KeyTrack> rotations, IReadOnlyList<KeyTrack> positions, IReadOnlyList<ClipEvent> events)
    {
        if (string.IsNullOrEmpty(name))
        {
            throw new ArgumentException("a clip has no name; expected one", nameof(name));
        }

        _ = rotations ?? throw new ArgumentNullException(nameof(rotations));
        _ = positions ?? throw new ArgumentNullException(nameof(positions));
        if (rotations.Count == 0 || rotations.Count != positions.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {name} has {rotations.Count} tracks of rotations and {positions.Count} of positions; expected one of each per joint"), nameof(rotations));
        }

        if (!(duration > 0f && duration <= float.MaxValue && float.IsFinite(speed)))
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {name} lasts {duration} s at {speed} m/s; expected a time above 0 and a finite speed"), nameof(duration));
        }

        Name = name;
        End = end;
        Duration = duration;
        Speed = speed;
        this.rotations = new List<KeyTrack>(rotations).ToArray();
        this.positions = new List<KeyTrack>(positions).ToArray();
        Events = ClipTime.Ordered(events ?? throw new ArgumentNullException(nameof(events)), duration, name);
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
    public int Joints => rotations.Length;

    /// <inheritdoc/>
    public IReadOnlyList<ClipEvent> Events { get; }

    /// <inheritdoc/>
    public float EventSpan => Duration;

    /// <summary>The rotations of each joint.</summary>
    public IReadOnlyList<KeyTrack> Rotations => rotations;

    /// <summary>The positions of each joint.</summary>
    public IReadOnlyList<KeyTrack> Positions => positions;

    /// <inheritdoc/>
    public void Sample(float time, in Pose local)
    {
        float within = ClipTime.Within(time, Duration, End);
        if (local.Rotations.Length != rotations.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"a pose of {local.Rotations.Length} joints; expected the {rotations.Length} of clip {Name}"), nameof(local));
        }

        KeyTrack last = rotations[0];
        int key = last.KeyAt(within, 0);
        for (int i = 0; i < rotations.Length; i++)
        {
            Find(rotations[i], within, ref last, ref key);
            local.Rotations[i] = rotations[i].RotationAt(within, key);
            Find(positions[i], within, ref last, ref key);
            local.Positions[i] = positions[i].PositionAt(within, key);
        }
    }

    private static void Find(KeyTrack track, float time, ref KeyTrack last, ref int key)
    {
        if (!track.SharesTimes(last))
        {
            key = track.KeyAt(time, key);
            last = track;
        }
    }
}
