namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>What the first byte of a track in a <see cref="CompressedClip"/> says.</summary>
internal static class PackedTrack
{
    /// <summary>It stays as the skeleton is at rest; nothing follows.</summary>
    public const byte Rest = 0;

    /// <summary>It stays at one value, which follows with its range.</summary>
    public const byte Constant = 1;

    /// <summary>It moves: range, number of keys, the frame of each key, of cubic tracks a bit for each key after which they go straight, the value of each key.</summary>
    public const byte Moving = 2;

    /// <summary>Bytes of a value.</summary>
    public const int ValueBytes = 6;

    /// <summary>Bytes of the bits that say after which of so many keys a track goes straight.</summary>
    public static int StraightBytes(int keys, KeyInterpolation interpolation) => interpolation == KeyInterpolation.Cubic ? (keys + 7) / 8 : 0;

    /// <summary>Bytes of a frame's number.</summary>
    public static int FrameBytes(int frames) => frames <= 256 ? 1 : 2;
}
