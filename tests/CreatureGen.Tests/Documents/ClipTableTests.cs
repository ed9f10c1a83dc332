using System;
using System.Globalization;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Documents;

public sealed class ClipTableTests
{
    // As the table counts: ten floats of a joint in a frame, and the time and the floats of a key.
    private const int RawBytes = 40;
    private const int TurnBytes = 20;
    private const int PlaceBytes = 16;

    /// <summary>Of the six creatures of the table; what rounds and what a new way of moving adds is a twentieth.</summary>
    [Fact(Explicit = true)]
    public void The_table_of_sizes_and_errors_of_clips_says_what_is_so()
    {
        long raw = 0, reduced = 0, packed = 0;
        float worst = 0f;
        foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming })
        {
            for (ulong seed = 0; seed < 2; seed++)
            {
                Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, MinScale = 1, MaxScale = 1 });
                foreach (Clip clip in ClipBaker.Bake(creature).Concat(ClipBaker.BakeActs(creature)))
                {
                    raw += (long)RawBytes * clip.Frames * clip.Joints;
                    KeyedClip few = ClipCompression.Reduce(clip, creature.Skeleton, ClipPrecision.Default);
                    reduced += few.Rotations.Sum(track => (long)TurnBytes * track.Count) + few.Positions.Sum(track => (long)PlaceBytes * track.Count);
                    CompressedClip small = ClipCompression.Compress(clip, creature.Skeleton, ClipPrecision.Default);
                    packed += small.Size;
                    worst = Math.Max(worst, ClipError.Between(clip, small, creature.Skeleton, clip.Frames).P99);
                }
            }
        }

        Assert.Equal(Ratio("reduced, linear (as files have them)"), (double)raw / reduced, 0.05 * raw / reduced);
        Assert.Equal(Ratio("48 bits, linear"), (double)raw / packed, 0.05 * raw / packed);
        Assert.True(worst <= ClipPrecision.Default.Error, $"{worst} m");
    }

    private static double Ratio(string row)
    {
        string line = RepositoryFiles.Text("docs/animation-blocks.md").Split('\n').Single(one => one.StartsWith($"| {row} |", StringComparison.Ordinal));
        return double.Parse(line.Split('|')[3], CultureInfo.InvariantCulture);
    }
}
