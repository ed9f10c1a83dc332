using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>The lights of a studio as they stand around a camera: unit directions in model space.</summary>
internal sealed class LightRig
{
    // A key light at the horizon would throw shadows without end.
    private const float LowestKey = 0.15f;

    public LightRig(Lighting lighting, Camera camera)
    {
        Lighting = lighting;
        Vector3 right = camera.Right;
        Vector3 back = Vec.Cross(right, Vector3.UnitY);
        Vector3 key = InModel(lighting.KeyDirection, right, back);
        Key = Vec.Normalize(new Vector3(key.X, Math.Max(key.Y, LowestKey), key.Z));
        Rim = InModel(lighting.RimDirection, right, back);
        Fill = Vec.Normalize(InModel(new Vector3(0.35f, 0.15f, 1f), right, back) - (camera.Forward * 0.5f), Vector3.UnitY);
        BoxRight = Vec.Normalize(Vec.Cross(Vector3.UnitY, Key), right);
        BoxUp = Vec.Cross(Key, BoxRight);
    }

    public Lighting Lighting { get; }

    /// <summary>To the key light.</summary>
    public Vector3 Key { get; }

    /// <summary>To the light behind.</summary>
    public Vector3 Rim { get; }

    /// <summary>To the light at the camera.</summary>
    public Vector3 Fill { get; }

    /// <summary>Level edge of the key light's box.</summary>
    public Vector3 BoxRight { get; }

    /// <summary>Upper edge of the key light's box.</summary>
    public Vector3 BoxUp { get; }

    private static Vector3 InModel(Vector3 inStudio, Vector3 right, Vector3 back) =>
        Vec.Normalize((right * inStudio.X) + (Vector3.UnitY * inStudio.Y) + (back * inStudio.Z), Vector3.UnitY);
}
