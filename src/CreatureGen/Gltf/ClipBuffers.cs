using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>The accessors of a creature's clips: times, and rotations and positions of every joint that any clip moves.</summary>
/// <remarks>Every clip keys the same joints, because players leave joints without keys where the clip before has put them. Equal lists of times and of values are in the file once.</remarks>
internal sealed class ClipBuffers
{
    // A joint moves when it leaves its rest pose by more than rounding.
    private const float Still = 1e-6f;

    /// <summary>Bytes of JSON that tell of an accessor and its view: times of a track's own have to save them.</summary>
    private const int AccessorText = 150;

    private readonly FloatPool pool;
    private readonly GltfOptions options;
    private readonly Skeleton skeleton;
    private readonly List<int> turning = new();
    private readonly List<int> sliding = new();
    private readonly List<ClipChannel[]> channels = new();
    private readonly Dictionary<int, float> ends = new();

    /// <summary>Appends the accessors of clips to a plan.</summary>
    /// <exception cref="InvalidOperationException">A clip is of another skeleton, or two have one name.</exception>
    public ClipBuffers(GltfOptions options, Skeleton skeleton, BufferPlan plan)
    {
        this.options = options;
        this.skeleton = skeleton;
        pool = new FloatPool(plan);
        Require();
        for (int joint = 0; joint < skeleton.Count; joint++)
        {
            if (Moves(joint, (clip, frame) => Distance(clip.RotationsAt(frame)[joint], skeleton.LocalRotations[joint])) || (joint == 0 && Travels))
            {
                turning.Add(joint);
            }

            if (Moves(joint, (clip, frame) => Distance(clip.PositionsAt(frame)[joint], skeleton.LocalPositions[joint])) || (joint == 0 && Travels))
            {
                sliding.Add(joint);
            }
        }

        foreach (Clip clip in options.Clips)
        {
            channels.Add(ChannelsOf(clip));
        }
    }

    /// <summary>The clips.</summary>
    public IReadOnlyList<Clip> Clips => options.Clips;

    /// <summary>The channels of a clip.</summary>
    public IReadOnlyList<ClipChannel> Channels(int clip) => channels[clip];

    /// <summary>The last of the times that an accessor holds, which need their bounds in the file; null if it holds none.</summary>
    public float? LastTime(Accessor accessor) => ends.TryGetValue(accessor.Index, out float end) ? end : null;

    /// <summary>Metres per second to tell of a clip: none of one whose root travels by itself.</summary>
    public float SpeedOf(Clip clip) => options.RootMotion == RootMotionChoice.Travels && clip.Path.Count > 0 ? 0f : clip.Speed;

    /// <summary>Writes all accessors into the binary chunk.</summary>
    public void Write(Span<byte> binary) => pool.Write(binary);

    private static float Distance(Quaternion a, Quaternion b)
    {
        float dot = (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);
        return 1f - Math.Abs(dot) + Math.Max(Math.Abs(a.X - b.X), Math.Max(Math.Abs(a.Y - b.Y), Math.Abs(a.Z - b.Z)));
    }

    private static float Distance(Vector3 a, Vector3 b) => Math.Max(Math.Abs(a.X - b.X), Math.Max(Math.Abs(a.Y - b.Y), Math.Abs(a.Z - b.Z)));

    private bool Travels
    {
        get
        {
            bool travels = false;
            foreach (Clip clip in options.Clips)
            {
                travels |= clip.Path.Count > 0;
            }

            return travels && options.RootMotion == RootMotionChoice.Travels;
        }
    }

    private void Require()
    {
        var names = new HashSet<string>(StringComparer.Ordinal);
        foreach (Clip clip in options.Clips)
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
    }

    private bool Moves(int joint, Func<Clip, int, float> distance)
    {
        foreach (Clip clip in options.Clips)
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

    private ClipChannel[] ChannelsOf(Clip clip)
    {
        KeyedClip whole = options.RootMotion == RootMotionChoice.Travels ? clip.WithRootMotion() : clip.WithPath(Array.Empty<ClipPlace>()).WithRootMotion();
        KeyedClip kept = options.ClipPrecision is { } precision ? ClipCompression.Reduce(clip, skeleton, precision) : whole;
        bool travels = options.RootMotion == RootMotionChoice.Travels && clip.Path.Count > 0;
        var made = new List<ClipChannel>();
        foreach (int joint in turning)
        {
            made.Add(Channel(clip, joint, "rotation", whole.Rotations[joint], joint == 0 && travels ? whole.Rotations[0] : kept.Rotations[joint], ElementShape.Vector4, 4));
        }

        foreach (int joint in sliding)
        {
            made.Add(Channel(clip, joint, "translation", whole.Positions[joint], joint == 0 && travels ? whole.Positions[0] : kept.Positions[joint], ElementShape.Vector3, 3));
        }

        return made.ToArray();
    }

    private ClipChannel Channel(Clip clip, int joint, string path, KeyTrack whole, KeyTrack kept, ElementShape shape, int width)
    {
        int values = kept.Interpolation == KeyInterpolation.Cubic ? 3 : 1;
        if (kept.Count == 1)
        {
            // At the first and the last time: an animation is as long as its keys.
            return Made(new[] { 0f, clip.Duration }, new[] { kept.ValueAt(0), kept.ValueAt(0) }, KeyInterpolation.Linear);
        }

        bool dear = kept.Count * ((values * width) + 1) * sizeof(float) + AccessorText >= whole.Count * width * sizeof(float);
        KeyTrack written = dear ? whole : kept;
        return Made(written.Times.ToArray(), written.Values.ToArray(), written.Interpolation);

        ClipChannel Made(float[] times, Vector4[] vectors, KeyInterpolation interpolation)
        {
            Accessor input = pool.Add(ElementShape.Scalar, times, 1);
            ends[input.Index] = times[times.Length - 1];
            float[] numbers = new float[vectors.Length * width];
            for (int i = 0; i < vectors.Length; i++)
            {
                numbers[i * width] = vectors[i].X;
                numbers[(i * width) + 1] = vectors[i].Y;
                numbers[(i * width) + 2] = vectors[i].Z;
                if (width == 4)
                {
                    numbers[(i * width) + 3] = vectors[i].W;
                }
            }

            return new ClipChannel(joint, path, input, pool.Add(shape, numbers, width), interpolation);
        }
    }
}
