using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Table;

/// <summary>Sizes and errors of clips as they are kept, over all clips of creatures of all kinds.</summary>
internal static class ClipTable
{
    /// <summary>Bytes of a joint in a frame as ten floats: rotation, position and scale, as ACL counts its raw size.</summary>
    private const int RawBytes = 40;

    /// <summary>Bytes of a key in a file: its time and four floats, or three.</summary>
    private const int TurnBytes = 20;
    private const int PlaceBytes = 16;

    /// <summary>Moments measured from frame to frame, so that errors between frames count.</summary>
    private const int MomentsPerFrame = 3;

    /// <summary>Measures and prints.</summary>
    public static void Print(TextWriter output, int seeds)
    {
        string[] names = ["every frame, as floats", "reduced, step", "reduced, linear", "reduced, cubic", "48 bits, step", "48 bits, linear", "48 bits, cubic"];
        var bytes = new long[names.Length];
        var errors = new List<float>[names.Length];
        var worst = new float[names.Length];
        int over = 0, count = 0;
        long raw = 0;
        double seconds = 0;
        for (int i = 0; i < names.Length; i++)
        {
            errors[i] = [];
        }

        foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming })
        {
            for (ulong seed = 0; seed < (ulong)seeds; seed++)
            {
                Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, MinScale = 1, MaxScale = 1 });
                foreach (Clip clip in ClipBaker.Bake(creature).Concat(ClipBaker.BakeActs(creature)))
                {
                    raw += (long)RawBytes * clip.Frames * clip.Joints;
                    bytes[0] += (long)(28 * clip.Joints + 4) * clip.Frames;
                    count++;
                    seconds += clip.Duration;
                    foreach (KeyInterpolation interpolation in Enum.GetValues<KeyInterpolation>())
                    {
                        var precision = new ClipPrecision(1e-4f, 0.03f, interpolation);
                        KeyedClip reduced = ClipCompression.Reduce(clip, creature.Skeleton, precision);
                        CompressedClip packed = ClipCompression.Compress(clip, creature.Skeleton, precision);
                        int row = 1 + (int)interpolation;
                        int values = interpolation == KeyInterpolation.Cubic ? 3 : 1;
                        bytes[row] += reduced.Rotations.Sum(track => Key(track, TurnBytes, values)) + reduced.Positions.Sum(track => Key(track, PlaceBytes, values));
                        bytes[row + 3] += packed.Size;
                        Measure(clip, reduced, row);
                        Measure(clip, packed, row + 3);
                        over += interpolation == KeyInterpolation.Linear && ClipError.Between(clip, packed, creature.Skeleton, clip.Frames).P99 > precision.Error ? 1 : 0;
                    }

                    void Measure(IClip original, IClip kept, int row)
                    {
                        int moments = IsStep(row) ? clip.Frames : (MomentsPerFrame * (clip.Frames - 1)) + 1;
                        ClipError error = ClipError.Between(original, kept, creature.Skeleton, moments);
                        errors[row].Add(error.P99);
                        worst[row] = Math.Max(worst[row], error.Worst);
                    }
                }
            }
        }

        output.WriteLine(Line($"{count} clips of {3 * seeds} creatures, {seconds:F0} s; raw: 10 floats a joint and frame, {raw / 1e6:F1} MB; errors 3 cm beside joints in model space, against the frames and two moments between them (steps: the frames)"));
        output.WriteLine();
        output.WriteLine("| kept as | bytes | raw : kept | median of the clips' p99, mm | worst p99, mm | worst case, mm |");
        output.WriteLine("| --- | ---: | ---: | ---: | ---: | ---: |");
        for (int i = 0; i < names.Length; i++)
        {
            errors[i].Sort();
            string middle = i == 0 ? "0 | 0 | 0" : Line($"{1e3 * errors[i][errors[i].Count / 2]:F3} | {1e3 * errors[i][^1]:F3} | {1e3 * worst[i]:F2}");
            output.WriteLine(Line($"| {names[i]} | {bytes[i] / 1e6:F2} MB | {(double)raw / bytes[i]:F1} | {middle} |"));
        }

        output.WriteLine();
        output.WriteLine(Line($"clips whose p99 in 48 bits, linear, is above 0.1 mm at the frames: {over}"));

        static bool IsStep(int row) => row is 1 or 4;
        static long Key(KeyTrack track, int one, int values) => track.Count * (4L + ((track.Count == 1 ? 1 : values) * (one - 4L)));
    }

    private static string Line(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
