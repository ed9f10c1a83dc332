using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Clips;

public sealed class ClipCompressionTests
{
    /// <summary>Bytes of a joint in a frame as floats: rotation, position and scale, as others count.</summary>
    private const int RawBytes = 40;

    private static readonly Creature cat = SpeciesSubject.Of("feline", RequestedKind.Walking);
    private static readonly IReadOnlyList<Clip> clips = ClipBaker.Bake(cat);

    [Theory]
    [InlineData(KeyInterpolation.Step, Explicit = true)]
    [InlineData(KeyInterpolation.Linear)]
    [InlineData(KeyInterpolation.Cubic, Explicit = true)]
    public void Fewer_keys_keep_within_a_tenth_of_a_millimetre_beside_the_joints(KeyInterpolation interpolation)
    {
        foreach (Clip clip in clips)
        {
            KeyedClip reduced = ClipCompression.Reduce(clip, cat.Skeleton, new ClipPrecision(1e-4f, 0.03f, interpolation));
            ClipError error = ClipError.Between(clip, reduced, cat.Skeleton, clip.Frames);
            Assert.True(error.P99 <= 1e-4f, $"{clip.Name}: {error}");
            Assert.True(interpolation == KeyInterpolation.Step || Keys(reduced) < 0.6 * 2 * clip.Frames * clip.Joints, $"{clip.Name}: {Keys(reduced)} keys");
        }
    }

    [Theory]
    [InlineData(KeyInterpolation.Linear)]
    [InlineData(KeyInterpolation.Cubic, Explicit = true)]
    public void Between_the_frames_fewer_keys_are_as_near(KeyInterpolation interpolation)
    {
        var precision = new ClipPrecision(1e-4f, 0.03f, interpolation);
        foreach (Clip clip in clips)
        {
            foreach (IClip small in new IClip[] { ClipCompression.Reduce(clip, cat.Skeleton, precision), ClipCompression.Compress(clip, cat.Skeleton, precision) })
            {
                ClipError error = ClipError.Between(clip, small, cat.Skeleton, (7 * (clip.Frames - 1)) + 1);
                Assert.True(error.P99 <= 1.05e-4f && error.Worst <= 1e-3f, $"{clip.Name}: {error}");
            }
        }
    }

    [Theory]
    [InlineData("feline", RequestedKind.Walking)]
    [InlineData("cobra", RequestedKind.Walking, Explicit = true)]
    [InlineData("raptor", RequestedKind.Flying, Explicit = true)]
    [InlineData("fish", RequestedKind.Swimming)]
    public void Forty_eight_bits_a_key_keep_within_a_tenth_of_a_millimetre_in_a_tenth_of_the_bytes(string body, RequestedKind kind)
    {
        Creature creature = SpeciesSubject.Of(body, kind);
        int packedBytes = 0;
        int rawBytes = 0;
        foreach (Clip clip in ClipBaker.Bake(creature))
        {
            CompressedClip packed = ClipCompression.Compress(clip, creature.Skeleton, ClipPrecision.Default);
            ClipError error = ClipError.Between(clip, packed, creature.Skeleton, clip.Frames);
            Assert.True(error.P99 <= 1e-4f, $"{clip.Name}: {error}");
            packedBytes += packed.Size;
            rawBytes += RawBytes * clip.Frames * clip.Joints;
        }

        Assert.True(packedBytes < 0.1 * rawBytes, $"{packedBytes} of {rawBytes} bytes");
    }

    [Theory]
    [InlineData(KeyInterpolation.Step, Explicit = true)]
    [InlineData(KeyInterpolation.Cubic)]
    public void Steps_and_curves_in_forty_eight_bits_are_as_near_at_the_frames(KeyInterpolation interpolation)
    {
        foreach (Clip clip in clips)
        {
            CompressedClip packed = ClipCompression.Compress(clip, cat.Skeleton, new ClipPrecision(1e-4f, 0.03f, interpolation));
            ClipError error = ClipError.Between(clip, packed, cat.Skeleton, clip.Frames);
            Assert.True(error.P99 <= 1e-4f, $"{clip.Name}: {error}");
        }
    }

    [Theory]
    [InlineData(KeyInterpolation.Linear, Explicit = true)]
    [InlineData(KeyInterpolation.Cubic)]
    public void Loops_still_close_to_the_bit(KeyInterpolation interpolation)
    {
        var precision = new ClipPrecision(1e-4f, 0.03f, interpolation);
        foreach (Clip clip in clips.Where(clip => clip.End == ClipEnd.Loops))
        {
            foreach (IClip small in new IClip[] { ClipCompression.Reduce(clip, cat.Skeleton, precision), ClipCompression.Compress(clip, cat.Skeleton, precision) })
            {
                (Quaternion[] first, Vector3[] firstPlaces) = Sampled(small, 0f);
                (Quaternion[] last, Vector3[] lastPlaces) = Sampled(small, small.Duration);
                Assert.Equal(first, last);
                Assert.Equal(firstPlaces, lastPlaces);
            }
        }
    }

    [Fact]
    public void A_compressed_clip_is_played_forwards_backwards_and_around_without_garbage()
    {
        Clip walk = clips.First(clip => clip.Name == "Walk");
        CompressedClip packed = ClipCompression.Compress(walk, cat.Skeleton, ClipPrecision.Default);
        (Quaternion[] at, _) = Sampled(packed, 0.3f);
        Assert.Equal(at, Sampled(packed, 0.3f + packed.Duration).Rotations, new Near(1e-4f));
        Assert.Equal(at, Sampled(packed, 0.3f - packed.Duration).Rotations, new Near(1e-4f));
        Assert.Equal((walk.Name, walk.Duration, walk.Speed, walk.End, walk.Events), (packed.Name, packed.Duration, packed.Speed, packed.End, packed.Events));
        var rotations = new Quaternion[packed.Joints];
        var positions = new Vector3[packed.Joints];
        Assert.Equal(0, MovingPose.Allocated(() => packed.Sample(0.41f, new Pose(rotations, positions))));
    }

    [Fact]
    public void A_tighter_bound_takes_more_keys()
    {
        Clip walk = clips.First(clip => clip.Name == "Walk");
        int fine = Keys(ClipCompression.Reduce(walk, cat.Skeleton, new ClipPrecision(2e-5f, 0.03f, KeyInterpolation.Linear)));
        int coarse = Keys(ClipCompression.Reduce(walk, cat.Skeleton, new ClipPrecision(1e-3f, 0.03f, KeyInterpolation.Linear)));
        Assert.True(fine > 1.2 * coarse, $"{fine} and {coarse} keys");
    }

    [Fact]
    public void What_does_not_fit_is_refused_with_one_message()
    {
        Skeleton other = SpeciesSubject.Of("cobra", RequestedKind.Walking).Skeleton;
        Assert.Contains("Idle", Assert.Throws<ArgumentException>(() => ClipCompression.Reduce(clips[0], other, ClipPrecision.Default)).Message, StringComparison.Ordinal);
        Assert.ThrowsAny<ArgumentException>(() => new ClipPrecision(0f, 0.03f, KeyInterpolation.Linear));
        Assert.ThrowsAny<ArgumentException>(() => new ClipPrecision(1e-4f, float.NaN, KeyInterpolation.Linear));
        Assert.ThrowsAny<ArgumentException>(() => new ClipPrecision(1e-4f, 0.03f, (KeyInterpolation)9));
        Assert.Throws<ArgumentException>(() => ClipError.Between(clips[0], clips[0], cat.Skeleton, 1));
        Assert.Throws<ArgumentNullException>(() => ClipCompression.Compress(null!, cat.Skeleton, ClipPrecision.Default));
    }

    private static int Keys(KeyedClip clip) => clip.Rotations.Sum(track => track.Count) + clip.Positions.Sum(track => track.Count);

    private static (Quaternion[] Rotations, Vector3[] Positions) Sampled(IClip clip, float time)
    {
        var rotations = new Quaternion[clip.Joints];
        var positions = new Vector3[clip.Joints];
        clip.Sample(time, new Pose(rotations, positions));
        return (rotations, positions);
    }

    private sealed class Near(float tolerance) : IEqualityComparer<Quaternion>
    {
        public bool Equals(Quaternion a, Quaternion b) => (a - b).Length() < tolerance;

        public int GetHashCode(Quaternion q) => 0;
    }
}
