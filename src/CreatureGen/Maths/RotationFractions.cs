using System;
using System.Numerics;

namespace CreatureGen.Maths;

/// <summary>Shares of one turn, the shorter way: as <see cref="Rotation.Slerp"/> from the identity, with what concerns the whole turn worked out once.</summary>
internal readonly struct RotationFractions
{
    private const double MinSine = 1e-9;

    private readonly Vector3 axis;
    private readonly float half;

    /// <summary>Takes a turn.</summary>
    /// <param name="turn">Unit quaternion.</param>
    public RotationFractions(Quaternion turn)
    {
        double x = turn.X;
        double y = turn.Y;
        double z = turn.Z;
        double sine = Math.Sqrt((x * x) + (y * y) + (z * z));
        if (sine < MinSine)
        {
            axis = Vector3.Zero;
            half = 0;
            return;
        }

        half = FastTrigonometry.Of((float)sine, Math.Abs(turn.W));
        double inverse = turn.W < 0f ? -1 / sine : 1 / sine;
        axis = new Vector3((float)(x * inverse), (float)(y * inverse), (float)(z * inverse));
    }

    /// <summary>The turn by a share of its angle.</summary>
    public Quaternion At(float fraction)
    {
        FastTrigonometry.SinCos(fraction * half, out float sine, out float cosine);
        return new Quaternion(axis * sine, cosine);
    }
}
