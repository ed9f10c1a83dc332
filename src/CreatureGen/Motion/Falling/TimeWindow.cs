using CreatureGen.Maths;

namespace CreatureGen.Motion.Falling;

/// <summary>A part of a time in which something goes from 0 to 1, from rest to rest.</summary>
/// <param name="Begin">Where it begins, 0..1.</param>
/// <param name="End">Where it ends.</param>
internal readonly record struct TimeWindow(float Begin, float End)
{
    /// <summary>How far it has gone, 0..1.</summary>
    public float At(float u) => Scalar.Smoother((u - Begin) / (End - Begin));
}
