using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>The accessors of a creature's clips: times, and rotations and positions of every joint that any clip moves.</summary>
/// <remarks>Every clip keys the same joints, because players leave joints without keys where the clip before has put them.</remarks>
internal sealed class ClipBuffers
{
    // A joint moves when it leaves its rest pose by more than rounding.
    private const float Still = 1e-6f;

    private readonly IReadOnlyList<Clip> clips;
    private readonly List<int> turning = new();
    private readonly List<int> sliding = new();
    private readonly Dictionary<(int Frames, int Rate), Accessor> times = new();
    private readonly List<Accessor> outputs = new();

    /// <summary>Appends the accessors of clips to a plan.</summary>
    /// <exception cref="InvalidOperationException">A clip is of another skeleton, or two have one name.</exception>
    public ClipBuffers(IReadOnlyList<Clip> clips, Skeleton skeleton, BufferPlan plan)
    {
        this.clips = clips;
        var names = new HashSet<string>(StringComparer.Ordinal);
        foreach (Clip clip in clips)
        {
            if (clip.Joints != skeleton.Count)
            {
                throw ExportError.At("clip " + clip.Name, FormattableString.Invariant($"it has {clip.Joints} joints"), FormattableString.Invariant($"the {skeleton.Count} of the skeleton"));
            }

            if (!names.Add(clip.Name))
            {
                throw ExportError.At("clip " + clip.Name, "another clip has its name", "unique names");
            }
        }

        for (int joint = 0; joint < skeleton.Count; joint++)
        {
            if (Moves(joint, (clip, frame) => Distance(clip.RotationsAt(frame)[joint], skeleton.LocalRotations[joint])))
            {
                turning.Add(joint);
            }

            if (Moves(joint, (clip, frame) => Distance(clip.PositionsAt(frame)[joint], skeleton.LocalPositions[joint])))
            {
                sliding.Add(joint);
            }
        }

        foreach (Clip clip in clips)
        {
            if (!times.ContainsKey((clip.Frames, clip.Rate)))
            {
                times.Add((clip.Frames, clip.Rate), plan.Add(ElementShape.Scalar, ComponentFormat.Float, clip.Frames, BufferTarget.None));
            }

            foreach (int _ in turning)
            {
                outputs.Add(plan.Add(ElementShape.Vector4, ComponentFormat.Float, clip.Frames, BufferTarget.None));
            }

            foreach (int _ in sliding)
            {
                outputs.Add(plan.Add(ElementShape.Vector3, ComponentFormat.Float, clip.Frames, BufferTarget.None));
            }
        }
    }

    /// <summary>The clips.</summary>
    public IReadOnlyList<Clip> Clips => clips;

    /// <summary>Joints whose rotation is keyed.</summary>
    public IReadOnlyList<int> Turning => turning;

    /// <summary>Joints whose position is keyed.</summary>
    public IReadOnlyList<int> Sliding => sliding;

    /// <summary>The times of a clip.</summary>
    public Accessor TimesOf(int clip) => times[(clips[clip].Frames, clips[clip].Rate)];

    /// <summary>The last of the times that an accessor holds, which need their bounds in the file; null if it holds none.</summary>
    public float? LastTime(Accessor accessor)
    {
        foreach (Clip clip in clips)
        {
            if (times[(clip.Frames, clip.Rate)] == accessor)
            {
                return clip.Duration;
            }
        }

        return null;
    }

    /// <summary>The rotations of the k-th turning joint in a clip.</summary>
    public Accessor RotationsOf(int clip, int k) => outputs[(clip * (turning.Count + sliding.Count)) + k];

    /// <summary>The positions of the k-th sliding joint in a clip.</summary>
    public Accessor PositionsOf(int clip, int k) => outputs[(clip * (turning.Count + sliding.Count)) + turning.Count + k];

    /// <summary>Writes all accessors into the binary chunk.</summary>
    public void Write(Span<byte> binary)
    {
        for (int c = 0; c < clips.Count; c++)
        {
            Clip clip = clips[c];
            Span<byte> seconds = BufferPlan.Bytes(TimesOf(c), binary);
            for (int frame = 0; frame < clip.Frames; frame++)
            {
                LittleEndian.Write(seconds, 4 * frame, clip.TimeOf(frame));
                for (int k = 0; k < turning.Count; k++)
                {
                    Quaternion q = clip.RotationsAt(frame)[turning[k]];
                    Span<byte> at = BufferPlan.Bytes(RotationsOf(c, k), binary).Slice(16 * frame, 16);
                    LittleEndian.Write(at, 0, q.X);
                    LittleEndian.Write(at, 4, q.Y);
                    LittleEndian.Write(at, 8, q.Z);
                    LittleEndian.Write(at, 12, q.W);
                }

                for (int k = 0; k < sliding.Count; k++)
                {
                    Vector3 p = clip.PositionsAt(frame)[sliding[k]];
                    Span<byte> at = BufferPlan.Bytes(PositionsOf(c, k), binary).Slice(12 * frame, 12);
                    LittleEndian.Write(at, 0, p.X);
                    LittleEndian.Write(at, 4, p.Y);
                    LittleEndian.Write(at, 8, p.Z);
                }
            }
        }
    }

    private static float Distance(Quaternion a, Quaternion b)
    {
        float dot = (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);
        return 1f - Math.Abs(dot) + Math.Max(Math.Abs(a.X - b.X), Math.Max(Math.Abs(a.Y - b.Y), Math.Abs(a.Z - b.Z)));
    }

    private static float Distance(Vector3 a, Vector3 b) => Math.Max(Math.Abs(a.X - b.X), Math.Max(Math.Abs(a.Y - b.Y), Math.Abs(a.Z - b.Z)));

    private bool Moves(int joint, Func<Clip, int, float> distance)
    {
        foreach (Clip clip in clips)
        {
            for (int frame = 0; frame < clip.Frames; frame++)
            {
                if (distance(clip, frame) > Still)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
