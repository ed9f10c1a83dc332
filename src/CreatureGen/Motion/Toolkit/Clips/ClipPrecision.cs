using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How far a clip of fewer keys may be off the motion that it is made of, and how it goes from key to key.</summary>
public readonly record struct ClipPrecision
{
    /// <summary>A tenth of a millimetre, 3 cm from each joint, with straight lines from key to key.</summary>
    public static ClipPrecision Default { get; } = new(1e-4f, 0.03f, KeyInterpolation.Linear);

    /// <summary>Takes a precision.</summary>
    /// <param name="error">Metres in model space by which points beside the joints may be off, in 99 of 100 cases (every joint in every frame is one); above 0.</param>
    /// <param name="distance">Metres from a joint to the points beside it, where skin is: turns of the joint move them. Above 0.</param>
    /// <param name="interpolation">How tracks go from key to key.</param>
    /// <exception cref="ArgumentException">A number is not finite or not above 0, or there is no such interpolation.</exception>
    public ClipPrecision(float error, float distance, KeyInterpolation interpolation)
    {
        Finite.RequireWithin(error, float.Epsilon, float.MaxValue, nameof(error));
        Finite.RequireWithin(distance, float.Epsilon, float.MaxValue, nameof(distance));
        KeyTrack.Require(interpolation);
        Error = error;
        Distance = distance;
        Interpolation = interpolation;
    }

    /// <summary>Metres in model space by which points beside the joints may be off, in 99 of 100 cases.</summary>
    public float Error { get; }

    /// <summary>Metres from a joint to the points beside it.</summary>
    public float Distance { get; }

    /// <summary>How tracks go from key to key.</summary>
    public KeyInterpolation Interpolation { get; }
}
