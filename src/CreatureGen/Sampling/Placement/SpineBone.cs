namespace CreatureGen.Sampling.Placement;

/// <summary>A bone of the spine as the attachment rules see it. Metres at scale 1, model space; values are those at the bone's middle.</summary>
/// <param name="Index">Place in the measured spine, 0 nearest the head.</param>
/// <param name="Ring">Ring of the body grid at its middle.</param>
/// <param name="HipWidth">Distance between the left and the right attachment point: how wide the body is.</param>
/// <param name="Length">Length of the bone.</param>
/// <param name="Height">Height of the spine above the ground.</param>
/// <param name="Thickness">Height of the body's section from back to belly.</param>
/// <param name="Z">Place along the ground; the front has the greatest.</param>
internal readonly record struct SpineBone(int Index, double Ring, double HipWidth, double Length, double Height, double Thickness, double Z);

/// <summary>The body at any ring, between the middles of two bones. Metres at scale 1.</summary>
/// <param name="Ring">Ring of the body grid.</param>
/// <param name="Along">Distance along the spine from the front end of the measured bones.</param>
/// <param name="Z">Place along the ground.</param>
/// <param name="Height">Height of the spine above the ground.</param>
/// <param name="HipWidth">Width of the body.</param>
/// <param name="Thickness">Height of the section from back to belly.</param>
/// <param name="RingSpacing">Distance along the spine from one ring to the next.</param>
/// <param name="Level">Cosine of the spine's pitch: 1 level, 0 upright.</param>
internal readonly record struct SpineSection(
    double Ring,
    double Along,
    double Z,
    double Height,
    double HipWidth,
    double Thickness,
    double RingSpacing,
    double Level);

/// <summary>A point of the sagittal plane x = 0, metres at scale 1.</summary>
/// <param name="Y">Height above the ground.</param>
/// <param name="Z">Place along the ground; the front has the greatest.</param>
internal readonly record struct SagittalPoint(double Y, double Z);
