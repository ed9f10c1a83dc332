using System;
using System.Collections.Generic;
using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>Writes the tracks of a <see cref="CompressedClip"/>, one after the other.</summary>
internal sealed class PackedWriter
{
    private readonly List<byte> bytes = new();
    private readonly int frameBytes;

    private readonly KeyInterpolation interpolation;

    public PackedWriter(int frames, KeyInterpolation interpolation)
    {
        frameBytes = PackedTrack.FrameBytes(frames);
        this.interpolation = interpolation;
    }

    /// <summary>A track of rotations from the skeleton at rest.</summary>
    /// <param name="track">Its frames.</param>
    /// <param name="keys">Those that are kept.</param>
    /// <param name="still">Parts of a unit quaternion that count as rest.</param>
    public void Turns(TrackFrames track, ChosenKeys keys, float still)
    {
        var values = Array.ConvertAll(keys.Frames, frame => track.Values[frame]);
        if (keys.Count == 1 && KeyCurve.SquaredDistance(values[0], new Vector4(0f, 0f, 0f, values[0].W < 0f ? -1f : 1f)) <= still * still)
        {
            bytes.Add(PackedTrack.Rest);
            return;
        }

        float range = 0f;
        foreach (Vector4 q in values)
        {
            range = Math.Max(range, PackedValue.RangeOf(ToQuaternion(q)));
        }

        Header(keys, range);
        foreach (Vector4 q in values)
        {
            Value(PackedValue.Pack(ToQuaternion(q), range));
        }
    }

    /// <summary>A track of positions from the skeleton at rest.</summary>
    /// <param name="track">Its frames.</param>
    /// <param name="keys">Those that are kept.</param>
    /// <param name="still">Metres that count as rest.</param>
    public void Places(TrackFrames track, ChosenKeys keys, float still)
    {
        var values = Array.ConvertAll(keys.Frames, frame => track.Values[frame]);
        if (keys.Count == 1 && KeyCurve.SquaredDistance(values[0], default) <= still * still)
        {
            bytes.Add(PackedTrack.Rest);
            return;
        }

        float range = 0f;
        foreach (Vector4 p in values)
        {
            range = Math.Max(range, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
        }

        Header(keys, range);
        foreach (Vector4 p in values)
        {
            Value(PackedValue.Pack(new Vector3(p.X, p.Y, p.Z), range));
        }
    }

    /// <summary>All tracks.</summary>
    public byte[] ToArray() => bytes.ToArray();

    private static Quaternion ToQuaternion(Vector4 q) => new(q.X, q.Y, q.Z, q.W);

    private void Header(ChosenKeys keys, float range)
    {
        bytes.Add(keys.Count == 1 ? PackedTrack.Constant : PackedTrack.Moving);
        int bits = BitConverter.SingleToInt32Bits(range);
        Number((ushort)bits);
        Number((ushort)(bits >> 16));
        if (keys.Count == 1)
        {
            return;
        }

        Number((ushort)keys.Count);
        foreach (int key in keys.Frames)
        {
            bytes.Add((byte)key);
            if (frameBytes == 2)
            {
                bytes.Add((byte)(key >> 8));
            }
        }

        for (int first = 0; first < 8 * PackedTrack.StraightBytes(keys.Count, interpolation); first += 8)
        {
            int straight = 0;
            for (int k = 0; k < 8; k++)
            {
                straight |= keys.GoesStraight(first + k) ? 1 << k : 0;
            }

            bytes.Add((byte)straight);
        }
    }

    private void Value((ushort A, ushort B, ushort C) value)
    {
        Number(value.A);
        Number(value.B);
        Number(value.C);
    }

    private void Number(ushort number)
    {
        bytes.Add((byte)number);
        bytes.Add((byte)(number >> 8));
    }
}
