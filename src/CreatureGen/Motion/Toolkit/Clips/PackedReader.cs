using System;
using System.Buffers.Binary;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>Goes through the tracks of a <see cref="CompressedClip"/>, one after the other.</summary>
internal ref struct PackedReader
{
    private readonly int frameBytes;
    private readonly bool loops;
    private readonly KeyInterpolation interpolation;
    private ReadOnlySpan<byte> rest;

    public PackedReader(ReadOnlySpan<byte> data, int frames, bool loops, KeyInterpolation interpolation)
    {
        rest = data;
        frameBytes = PackedTrack.FrameBytes(frames);
        this.loops = loops;
        this.interpolation = interpolation;
    }

    /// <summary>The rotation of the next track.</summary>
    /// <param name="frame">Where in the clip, frames.</param>
    /// <param name="atRest">Of the joint at rest.</param>
    public Quaternion Rotation(float frame, Quaternion atRest)
    {
        Track track = Next();
        if (track.Count == 0)
        {
            return atRest;
        }

        int key = track.KeyAt(frame);
        Quaternion value = track.Turn(key);
        if (track.Between(frame, key, out float t) && interpolation != KeyInterpolation.Step)
        {
            value = interpolation == KeyInterpolation.Linear || track.GoesStraight(key)
                ? Maths.Rotation.Slerp(value, track.Turn(key + 1), t)
                : track.Curved(key, t, loops);
        }

        return Maths.Rotation.Normalize(Maths.Rotation.Multiply(atRest, value));
    }

    /// <summary>The position of the next track.</summary>
    /// <param name="frame">Where in the clip, frames.</param>
    /// <param name="atRest">Of the joint at rest.</param>
    public Vector3 Position(float frame, Vector3 atRest)
    {
        Track track = Next();
        if (track.Count == 0)
        {
            return atRest;
        }

        int key = track.KeyAt(frame);
        Vector3 value = track.Place(key);
        if (track.Between(frame, key, out float t) && interpolation != KeyInterpolation.Step)
        {
            value = interpolation == KeyInterpolation.Linear || track.GoesStraight(key) ? Vec.Lerp(value, track.Place(key + 1), t) : track.CurvedPlace(key, t, loops);
        }

        return atRest + value;
    }

    private Track Next()
    {
        byte kind = rest[0];
        if (kind == PackedTrack.Rest)
        {
            rest = rest.Slice(1);
            return default;
        }

        float range = BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(rest.Slice(1)));
        int count = 1;
        int at = 5;
        if (kind == PackedTrack.Moving)
        {
            count = BinaryPrimitives.ReadUInt16LittleEndian(rest.Slice(at));
            at += 2;
        }

        int times = kind == PackedTrack.Moving ? count * frameBytes : 0;
        int straight = kind == PackedTrack.Moving ? PackedTrack.StraightBytes(count, interpolation) : 0;
        int values = at + times + straight;
        var track = new Track(range, count, frameBytes, rest.Slice(at, times), rest.Slice(at + times, straight), rest.Slice(values, count * PackedTrack.ValueBytes));
        rest = rest.Slice(values + (count * PackedTrack.ValueBytes));
        return track;
    }

    private readonly ref struct Track
    {
        private readonly float range;
        private readonly int frameBytes;
        private readonly ReadOnlySpan<byte> frames;
        private readonly ReadOnlySpan<byte> straight;
        private readonly ReadOnlySpan<byte> values;

        public Track(float range, int count, int frameBytes, ReadOnlySpan<byte> frames, ReadOnlySpan<byte> straight, ReadOnlySpan<byte> values)
        {
            this.range = range;
            this.frameBytes = frameBytes;
            this.frames = frames;
            this.straight = straight;
            this.values = values;
            Count = count;
        }

        public int Count { get; }

        public Quaternion Turn(int key) => PackedValue.Turn(Number(key, 0), Number(key, 2), Number(key, 4), range);

        public Vector3 Place(int key) => PackedValue.Place(Number(key, 0), Number(key, 2), Number(key, 4), range);

        /// <summary>Whether a cubic track goes straight from a key to the next.</summary>
        public bool GoesStraight(int key) => straight.Length > 0 && (straight[key >> 3] & (1 << (key & 7))) != 0;

        /// <summary>The last key at or before a frame.</summary>
        public int KeyAt(float frame)
        {
            int low = 0;
            int high = Count - 1;
            while (low < high)
            {
                int middle = (low + high + 1) >> 1;
                if (FrameOf(middle) <= frame)
                {
                    low = middle;
                }
                else
                {
                    high = middle - 1;
                }
            }

            return low;
        }

        /// <summary>How far a frame is from its key to the next; false if it is at the key.</summary>
        public bool Between(float frame, int key, out float t)
        {
            t = 0f;
            if (key + 1 >= Count || frame <= FrameOf(key))
            {
                return false;
            }

            int from = FrameOf(key);
            t = (frame - from) / (FrameOf(key + 1) - from);
            return true;
        }

        public Quaternion Curved(int key, float t, bool loops)
        {
            Vector4 a = Signed(key, default);
            Vector4 b = Signed(key + 1, a);
            (int before, int after, int back, int on) = Neighbours(key, loops);
            Vector4 leaving = (b - Signed(before, a)) * (1f / back);
            Vector4 arriving = (Signed(after, b) - a) * (1f / on);
            Vector4 q = KeyCurve.At(a, leaving, arriving, b, t, FrameOf(key + 1) - FrameOf(key));
            return Maths.Rotation.Normalize(new Quaternion(q.X, q.Y, q.Z, q.W));
        }

        public Vector3 CurvedPlace(int key, float t, bool loops)
        {
            var a = new Vector4(Place(key), 0f);
            var b = new Vector4(Place(key + 1), 0f);
            (int before, int after, int back, int on) = Neighbours(key, loops);
            Vector4 leaving = (b - new Vector4(Place(before), 0f)) * (1f / back);
            Vector4 arriving = (new Vector4(Place(after), 0f) - a) * (1f / on);
            Vector4 p = KeyCurve.At(a, leaving, arriving, b, t, FrameOf(key + 1) - FrameOf(key));
            return new Vector3(p.X, p.Y, p.Z);
        }

        /// <summary>The keys before a key and after the next, and the frames from the one before to the next, and from the key to the one after.</summary>
        private (int Before, int After, int Back, int On) Neighbours(int key, bool loops)
        {
            int last = Count - 1;
            bool around = loops && key == 0;
            int before = around ? last - 1 : Math.Max(key - 1, 0);
            int back = FrameOf(key + 1) - FrameOf(before) + (around ? FrameOf(last) : 0);
            around = loops && key + 1 == last;
            int after = around ? 1 : Math.Min(key + 2, last);
            int on = FrameOf(after) - FrameOf(key) + (around ? FrameOf(last) : 0);
            return (before, after, back, on);
        }

        /// <summary>A rotation, of its two signs the one nearer to another.</summary>
        private Vector4 Signed(int key, Vector4 near)
        {
            Quaternion q = Turn(key);
            float dot = (q.X * near.X) + (q.Y * near.Y) + (q.Z * near.Z) + (q.W * near.W);
            return new Vector4(q.X, q.Y, q.Z, q.W) * (dot < 0f ? -1f : 1f);
        }

        private int FrameOf(int key) => Count == 1 ? 0 : frameBytes == 1 ? frames[key] : BinaryPrimitives.ReadUInt16LittleEndian(frames.Slice(2 * key));

        private ushort Number(int key, int offset) => BinaryPrimitives.ReadUInt16LittleEndian(values.Slice((PackedTrack.ValueBytes * key) + offset));
    }
}
