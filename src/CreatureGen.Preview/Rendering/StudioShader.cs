using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>Lights a point of a creature: key light with shadow, sky and floor, fill, rim, highlight and the mirror image of the studio.</summary>
internal sealed class StudioShader
{
    // Reflection of skin, horn and water at right angles.
    private const float Reflectance = 0.04f;

    // How far round the edge of light each colour reaches: skin scatters red farthest.
    private static readonly Vector3 Wrap = new(0.30f, 0.22f, 0.18f);

    private readonly LightRig rig;
    private readonly GroundContact? contact;
    private readonly Vector3 eye;

    public StudioShader(LightRig rig, GroundContact? contact, Camera camera)
    {
        this.rig = rig;
        this.contact = contact;
        eye = camera.Eye;
    }

    /// <summary>The light that a point sends to the camera, linear RGB.</summary>
    /// <param name="point">Model space, metres.</param>
    /// <param name="normal">Unit normal turned to the viewer.</param>
    /// <param name="colour">Linear RGB of the surface.</param>
    /// <param name="gloss">0..1.</param>
    /// <param name="translucency">0..1.</param>
    /// <param name="openness">How open the place is to the light around it, 0..1.</param>
    /// <param name="lit">How much of the key light reaches it, 0..1.</param>
    public Vector3 Light(Vector3 point, Vector3 normal, Vector3 colour, float gloss, float translucency, float openness, float lit)
    {
        Lighting lighting = rig.Lighting;
        Vector3 toEye = eye - point;
        toEye *= 1f / MathF.Sqrt(Vec.LengthSquared(toEye));
        float facing = Math.Max(0f, Vec.Dot(normal, toEye));
        float towardsKey = Vec.Dot(normal, rig.Key);

        // Where light grazes, wrapped light takes over from the shadow map, which cannot tell there.
        float grazing = Scalar.Clamp((0.22f - towardsKey) * (1f / 0.32f), 0f, 1f);
        float diffuseLit = lit + ((1f - lit) * grazing * 0.85f);
        diffuseLit *= 0.65f + (0.35f * openness);
        var key = new Vector3(
            Wrapped(towardsKey, Wrap.X) * diffuseLit * lighting.Key.X,
            Wrapped(towardsKey, Wrap.Y) * diffuseLit * lighting.Key.Y,
            Wrapped(towardsKey, Wrap.Z) * diffuseLit * lighting.Key.Z);

        float up = 0.5f + (0.5f * normal.Y);
        float floor = contact is null ? 1f : 1f - (0.65f * contact.Hidden(point));
        Vector3 ambient = (lighting.Sky * up) + (lighting.Bounce * ((1f - up) * floor));
        ambient += lighting.Fill * Math.Max(0f, Vec.Dot(normal, rig.Fill));
        ambient *= new Vector3(Interreflect(openness, colour.X), Interreflect(openness, colour.Y), Interreflect(openness, colour.Z));
        Vector3 result = colour * (key + ambient);

        if (translucency > 0f)
        {
            result += colour * colour * lighting.Key * (Math.Max(0f, -towardsKey) * openness * translucency);
        }

        float roughness = 0.68f - (0.56f * gloss);
        result += Highlight(normal, toEye, towardsKey, roughness) * lit * lighting.Key;
        result += Mirror(normal, toEye, facing, gloss, openness);

        float edge = 1f - facing;
        float rim = edge * edge * edge * Scalar.Clamp(0.25f + Vec.Dot(normal, rig.Rim), 0f, 1f) * openness;
        result += lighting.Rim * ((colour * 0.6f) + new Vector3(0.16f)) * rim;
        return result * lighting.Exposure;
    }

    private static float Wrapped(float cosine, float wrap)
    {
        float value = (cosine + wrap) / (1f + wrap);
        return value > 0f ? value : 0f;
    }

    // Light between bright surfaces makes up for part of what their closeness hides: Jimenez, Wu, Pesce and Jarabo 2016, "Practical real-time strategies for accurate indirect occlusion", eq. 10.
    private static float Interreflect(float openness, float colour)
    {
        colour = Math.Min(colour, 1f);
        float a = (2.0404f * colour) - 0.3324f;
        float b = (-4.7951f * colour) + 0.6417f;
        float c = (2.7552f * colour) + 0.6903f;
        return Math.Max(openness, ((((openness * a) + b) * openness) + c) * openness);
    }

    // The distribution of Trowbridge and Reitz with the visibility term of Karis 2013, "Real shading in Unreal Engine 4", simplified.
    private Vector3 Highlight(Vector3 normal, Vector3 toEye, float towardsKey, float roughness)
    {
        if (towardsKey <= 0f)
        {
            return Vector3.Zero;
        }

        Vector3 half = rig.Key + toEye;
        half *= 1f / MathF.Sqrt(Math.Max(1e-6f, Vec.LengthSquared(half)));
        float cosine = Math.Max(0f, Vec.Dot(normal, half));
        float alpha = roughness * roughness;
        float square = alpha * alpha;
        float denominator = (cosine * cosine * (square - 1f)) + 1f;
        float distribution = square / (denominator * denominator);
        return new Vector3(Reflectance * distribution * ((roughness * 0.25f) + 0.25f) * Math.Min(1f, towardsKey * 4f));
    }

    // A dull surface mirrors nothing; a wet one shows the key light's box and the sky.
    private Vector3 Mirror(Vector3 normal, Vector3 toEye, float facing, float gloss, float openness)
    {
        Vector3 reflected = (normal * (2f * Vec.Dot(normal, toEye))) - toEye;
        float edge = 1f - facing;
        float square = edge * edge;
        float fresnel = Reflectance + ((1f - Reflectance) * square * square * edge * gloss);
        float sky = Scalar.Smooth((reflected.Y + 0.25f) * 0.9f);
        Vector3 image = (rig.Lighting.Bounce * (1f - sky)) + (rig.Lighting.Sky * (1.3f * sky));
        float strength = fresnel * gloss * (0.35f + (0.65f * openness));
        float depth = Vec.Dot(reflected, rig.Key);
        if (gloss > 0.5f && depth > 0.2f)
        {
            float blur = 0.5f * (1.12f - gloss);
            float u = Math.Abs(Vec.Dot(reflected, rig.BoxRight) / depth);
            float v = Math.Abs(Vec.Dot(reflected, rig.BoxUp) / depth);
            float box = Scalar.Smooth((0.36f + blur - u) / (2f * blur)) * Scalar.Smooth((0.42f + blur - v) / (2f * blur));
            image += rig.Lighting.Key * (box * 14f * (gloss - 0.5f));
        }

        return image * strength;
    }
}
