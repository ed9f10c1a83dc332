namespace CreatureGen.Inspection;

/// <summary>Two creatures of a study and how alike their outlines are.</summary>
/// <param name="First">Number of the one, counted from 0 as they were added.</param>
/// <param name="Second">Number of the other.</param>
/// <param name="Likeness">0..1.</param>
public sealed record LikePair(int First, int Second, double Likeness);
