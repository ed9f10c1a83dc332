using System;

namespace CreatureGen.Rigging;

/// <summary>Where the surface is cut open as a mouth.</summary>
internal sealed class MouthSeam
{
    /// <summary>Takes the ring of the lip corners and the vertices of both lips from the left corner to the right; the corners themselves are in both.</summary>
    /// <exception cref="ArgumentException">The lips differ in length or the ring does not fit them.</exception>
    public MouthSeam(int cornerRing, int[] upperLip, int[] lowerLip)
    {
        if (upperLip.Length != lowerLip.Length || (cornerRing > 0) != (upperLip.Length > 2))
        {
            throw new ArgumentException(FormattableString.Invariant($"lips of {upperLip.Length} and {lowerLip.Length} vertices with corners at ring {cornerRing}; expected equal lips, and none exactly when the ring is 0"), nameof(lowerLip));
        }

        CornerRing = cornerRing;
        UpperLip = upperLip;
        LowerLip = lowerLip;
    }

    /// <summary>A head without a mouth slit.</summary>
    public static MouthSeam None { get; } = new(0, Array.Empty<int>(), Array.Empty<int>());

    /// <summary>Ring of the lip corners; 0 without a mouth.</summary>
    public int CornerRing { get; }

    /// <summary>The ring about whose flank the jaw turns.</summary>
    public int HingeRing => Math.Min(CornerRing + 3, 14);

    /// <summary>Whether there is a mouth.</summary>
    public bool Opens => CornerRing > 0;

    public int[] UpperLip { get; }

    public int[] LowerLip { get; }
}
