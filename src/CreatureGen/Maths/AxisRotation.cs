using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Turns about the axes of the model, radians: +X is the creature's left, +Y up, +Z ahead.</summary>
internal static class AxisRotation
{
    /// <summary>About X. Positive tips the front down, and swings what hangs backward.</summary>
    public static Quaternion Pitch(double angle)
    {
        FastTrigonometry.SinCos((float)(0.5 * angle), out float sine, out float cosine);
        return new Quaternion(sine, 0f, 0f, cosine);
    }

    /// <summary>About Y. Positive turns the front to the left, and sweeps what lies out to the left backward.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Yaw(double angle)
    {
        FastTrigonometry.SinCos((float)(0.5 * angle), out float sine, out float cosine);
        return new Quaternion(0f, sine, 0f, cosine);
    }

    /// <summary>About Z. Positive raises the left side.</summary>
    public static Quaternion Roll(double angle)
    {
        FastTrigonometry.SinCos((float)(0.5 * angle), out float sine, out float cosine);
        return new Quaternion(0f, 0f, sine, cosine);
    }

    /// <summary>First about Z, then about X, then about Y.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion YawPitchRoll(float yaw, float pitch, float roll)
    {
        FastTrigonometry.SinCos(0.5f * yaw, out float sy, out float cy);
        FastTrigonometry.SinCos(0.5f * pitch, out float sx, out float cx);
        FastTrigonometry.SinCos(0.5f * roll, out float sz, out float cz);
        return new Quaternion(
            (cy * sx * cz) + (sy * cx * sz),
            (sy * cx * cz) - (cy * sx * sz),
            (cy * cx * sz) - (sy * sx * cz),
            (cy * cx * cz) + (sy * sx * sz));
    }

    /// <summary>About any unit axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion About(Vector3 axis, float angle)
    {
        FastTrigonometry.SinCos(0.5f * angle, out float sine, out float cosine);
        return new Quaternion(axis * sine, cosine);
    }
}
