using System.Numerics;

namespace CreatureGen.Preview.Rendering;

/// <summary>Fits light of any strength into 0..1: unchanged up to a knee, bent from there to white without ever reaching it.</summary>
internal static class ToneCurve
{
    private const float Knee = 0.5f;

    public static Vector3 Apply(Vector3 light) => new(Apply(light.X), Apply(light.Y), Apply(light.Z));

    private static float Apply(float x)
    {
        if (x <= Knee)
        {
            return x < 0f ? 0f : x;
        }

        float t = (x - Knee) * (1f / (1f - Knee));
        return Knee + ((1f - Knee) * (t / (1f + t)));
    }
}
