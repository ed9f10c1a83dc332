using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>What becomes of a clip at its end.</summary>
public enum ClipEnd
{
    /// <summary>It begins anew: its last frame is its first, bit for bit.</summary>
    Loops,

    /// <summary>It stays at its last frame.</summary>
    Stays,
}

/// <summary>
/// A piece of motion as poses of all joints in their parents' space, at a fixed rate and in place: the root joint does not travel. Immutable.
/// </summary>
/// <remarks>Frames follow one another; each holds one entry per joint in the order of the skeleton. Rotations are unit quaternions that never jump to the other sign from frame to frame; positions are metres.</remarks>
public sealed class Clip : IClip
{
    /// <summary>Frames per second of a clip whose joints turn slowly enough; quick wings take more.</summary>
    public const int UsualRate = 30;

    /// <summary>Most that a rotation may be off unit length.</summary>
    private const float UnitLength = 1e-4f;

    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;

    /// <summary>Takes ownership of the arrays; turns signs of rotations so that none jumps.</summary>
    /// <param name="name">ASCII letters, digits and underscores.</param>
    /// <param name="end">What becomes of it at its end.</param>
    /// <param name="rate">Frames per second, at least 1.</param>
    /// <param name="speed">Metres per second ahead at which the creature has to be moved for its feet not to slide; 0 for a clip on the spot.</param>
    /// <param name="joints">Number of joints.</param>
    /// <param name="rotations">Frames × joints, at least two frames.</param>
    /// <param name="positions">Frames × joints.</param>
    /// <exception cref="ArgumentOutOfRangeException">The rate is below 1.</exception>
    /// <exception cref="ArgumentException">A length, a number or the name is wrong, or a loop does not close.</exception>
    public Clip(string name, ClipEnd end, int rate, float speed, int joints, Quaternion[] rotations, Vector3[] positions)
    {
        if (string.IsNullOrEmpty(name))
        {
            throw new ArgumentException("a clip has no name; expected letters, digits and underscores", nameof(name));
        }

        foreach (char c in name)
        {
            if (!(c is (>= 'A' and <= 'Z') or (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_'))
            {
                throw new ArgumentException($"clip name \"{name}\"; expected letters, digits and underscores", nameof(name));
            }
        }

        if (joints < 1 || rotations.Length != positions.Length || rotations.Length % joints != 0 || rotations.Length < 2 * joints)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {name} has {rotations.Length} rotations and {positions.Length} positions of {joints} joints; expected one of each for every joint of at least two frames"), nameof(rotations));
        }

        if (rate < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(rate), rate, "expected at least 1 frame per second");
        }

        if (!float.IsFinite(speed))
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {name} has the speed {speed}; expected a finite number"), nameof(speed));
        }

        Name = name;
        End = end;
        Rate = rate;
        Speed = speed;
        Joints = joints;
        this.rotations = rotations;
        this.positions = positions;
        for (int i = 0; i < rotations.Length; i++)
        {
            Check(i);
        }
    }

    /// <inheritdoc/>
    public string Name { get; }

    /// <inheritdoc/>
    public ClipEnd End { get; }

    /// <inheritdoc/>
    public IReadOnlyList<ClipEvent> Events { get; private init; } = Array.Empty<ClipEvent>();

    /// <inheritdoc/>
    public float EventSpan => Duration;

    /// <summary>Where the creature is in each frame, for games that let a clip carry it (<see cref="WithRootMotion"/>); empty for a clip on the spot. The poses themselves are in place.</summary>
    public IReadOnlyList<ClipPlace> Path { get; private init; } = Array.Empty<ClipPlace>();

    /// <summary>Frames per second.</summary>
    public int Rate { get; }

    /// <inheritdoc/>
    public float Speed { get; }

    /// <inheritdoc/>
    public int Joints { get; }

    /// <summary>Number of frames, the last included.</summary>
    public int Frames => rotations.Length / Joints;

    /// <inheritdoc/>
    public float Duration => TimeOf(Frames - 1);

    /// <summary>Seconds from the first to another frame.</summary>
    public float TimeOf(int frame) => frame / (float)Rate;

    /// <inheritdoc/>
    public void Sample(float time, in Pose local)
    {
        float at = ClipTime.Within(time, Duration, End) * Rate;
        if (local.Rotations.Length != Joints)
        {
            throw new ArgumentException(FormattableString.Invariant($"a pose of {local.Rotations.Length} joints; expected the {Joints} of clip {Name}"), nameof(local));
        }

        int frame = Math.Min((int)at, Frames - 2);
        float fraction = at - frame;
        ReadOnlySpan<Quaternion> turnsBefore = RotationsAt(frame);
        ReadOnlySpan<Quaternion> turnsAfter = RotationsAt(frame + 1);
        ReadOnlySpan<Vector3> placesBefore = PositionsAt(frame);
        ReadOnlySpan<Vector3> placesAfter = PositionsAt(frame + 1);
        if (fraction <= 0f || fraction >= 1f)
        {
            (fraction <= 0f ? turnsBefore : turnsAfter).CopyTo(local.Rotations);
            (fraction <= 0f ? placesBefore : placesAfter).CopyTo(local.Positions);
            return;
        }

        for (int i = 0; i < Joints; i++)
        {
            local.Rotations[i] = Rotation.Slerp(turnsBefore[i], turnsAfter[i], fraction);
            local.Positions[i] = Vec.Lerp(placesBefore[i], placesAfter[i], fraction);
        }
    }

    /// <summary>The same motion with other events.</summary>
    /// <exception cref="ArgumentException">An event lies outside the clip.</exception>
    public Clip WithEvents(IReadOnlyList<ClipEvent> events) => new(Name, End, Rate, Speed, Joints, rotations, positions)
    {
        Events = ClipTime.Ordered(events ?? throw new ArgumentNullException(nameof(events)), Duration, Name),
        Path = Path,
    };

    /// <summary>The same motion with a way over the ground.</summary>
    /// <param name="path">Where the creature is in each frame; the first is where the clip begins. Empty for a clip on the spot.</param>
    /// <exception cref="ArgumentNullException">There is no path.</exception>
    /// <exception cref="ArgumentException">It has another number of places than the clip has frames, or a number is not finite.</exception>
    public Clip WithPath(IReadOnlyList<ClipPlace> path)
    {
        _ = path ?? throw new ArgumentNullException(nameof(path));
        if (path.Count != 0 && path.Count != Frames)
        {
            throw new ArgumentException(FormattableString.Invariant($"a path of {path.Count} places for clip {Name}; expected {Frames}, one for each frame, or none"), nameof(path));
        }

        var kept = new ClipPlace[path.Count];
        for (int i = 0; i < kept.Length; i++)
        {
            Finite.Require(path[i].Position, nameof(path));
            Finite.Require(path[i].Heading, nameof(path));
            kept[i] = path[i];
        }

        return new Clip(Name, End, Rate, Speed, Joints, rotations, positions) { Events = Events, Path = kept };
    }

    /// <summary>The same motion as keys, in which joint 0 goes along the <see cref="Path"/>: root motion. Its speed is 0, because it travels by itself.</summary>
    public KeyedClip WithRootMotion()
    {
        float[] times = new float[Frames];
        for (int frame = 0; frame < times.Length; frame++)
        {
            times[frame] = TimeOf(frame);
        }

        var turns = new KeyTrack[Joints];
        var places = new KeyTrack[Joints];
        var turn = new Quaternion[Frames];
        var place = new Vector3[Frames];
        for (int joint = 0; joint < Joints; joint++)
        {
            for (int frame = 0; frame < times.Length; frame++)
            {
                int at = (frame * Joints) + joint;
                (turn[frame], place[frame]) = (rotations[at], positions[at]);
                if (joint == 0 && Path.Count > 0)
                {
                    Quaternion heading = AxisRotation.Yaw(Path[frame].Heading);
                    turn[frame] = Rotation.Normalize(Rotation.Multiply(heading, turn[frame]));
                    place[frame] = Path[frame].Position + Rotation.Rotate(heading, place[frame]);
                }
            }

            turns[joint] = KeyTrack.OfRotations(times, turn, KeyInterpolation.Linear);
            places[joint] = KeyTrack.OfPositions(times, place, KeyInterpolation.Linear);
        }

        return new KeyedClip(Name, End, Duration, Path.Count > 0 ? 0f : Speed, turns, places, Events);
    }

    /// <summary>The rotations of a frame, one per joint.</summary>
    public ReadOnlySpan<Quaternion> RotationsAt(int frame) => rotations.AsSpan(frame * Joints, Joints);

    /// <summary>The positions of a frame, one per joint.</summary>
    public ReadOnlySpan<Vector3> PositionsAt(int frame) => positions.AsSpan(frame * Joints, Joints);

    private void Check(int i)
    {
        Quaternion q = rotations[i];
        Vector3 p = positions[i];
        float squared = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
        if (!(Math.Abs(squared - 1f) <= 2f * UnitLength) || !float.IsFinite(p.X + p.Y + p.Z))
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {Name}, frame {i / Joints}, joint {i % Joints}: rotation {q}, position {p}; expected a unit quaternion and finite numbers"), "rotations");
        }

        if (i >= Joints)
        {
            Quaternion before = rotations[i - Joints];
            float dot = (q.X * before.X) + (q.Y * before.Y) + (q.Z * before.Z) + (q.W * before.W);
            rotations[i] = dot < 0f ? new Quaternion(-q.X, -q.Y, -q.Z, -q.W) : q;
        }

        int first = i - (rotations.Length - Joints);
        if (first >= 0 && End == ClipEnd.Loops && (rotations[i] != rotations[first] || positions[i] != positions[first]))
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {Name}, joint {first}: the last frame is not the first; expected a loop that closes exactly"), "rotations");
        }
    }
}
