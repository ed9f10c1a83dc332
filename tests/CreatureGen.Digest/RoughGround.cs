using System;
using System.Numerics;
using CreatureGen.Motion;

namespace CreatureGen.Digest;

/// <summary>Ground of mounds and hollows, here and there with a step in it. Of its own arithmetic, so that no change of the library changes it.</summary>
/// <param name="length">Metres from mound to mound.</param>
/// <param name="height">Of a mound, metres.</param>
internal sealed class RoughGround(float length, float height) : IGround
{
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        float y = At(origin.X, origin.Z);
        if (origin.Y - y > distance)
        {
            hit = default;
            return false;
        }

        float step = 0.01f * length;
        var slope = new Vector3(At(origin.X - step, origin.Z) - At(origin.X + step, origin.Z), 2 * step, At(origin.X, origin.Z - step) - At(origin.X, origin.Z + step));
        float size = MathF.Sqrt((slope.X * slope.X) + (slope.Y * slope.Y) + (slope.Z * slope.Z));
        hit = new GroundHit(new Vector3(origin.X, y, origin.Z), slope / size, y > 0f ? 1 : 2);
        return true;
    }

    private float At(float x, float z) => height * (Wave(x / length) + (0.7f * Wave((z / length) + (0.3f * x / length))) + (Wave(z / (3f * length)) > 0.5f ? 0.4f : 0f));

    /// <summary>Parabolas, one up and one down, of period 2.</summary>
    private static float Wave(float x)
    {
        float whole = MathF.Floor(x);
        float part = x - whole;
        float arc = 4f * part * (1f - part);
        return (int)whole % 2 == 0 ? arc : -arc;
    }
}
