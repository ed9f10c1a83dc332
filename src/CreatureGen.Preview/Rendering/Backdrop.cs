using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>What is behind the creature: a soft studio without a horizon, whose floor shows by the shadows on it.</summary>
internal sealed class Backdrop
{
    // Middle of the glow, part of the picture's height from the top.
    private const float GlowHeight = 0.48f;

    private readonly LightRig rig;
    private readonly Camera camera;
    private readonly GroundShadow? shadow;
    private readonly GroundContact? contact;
    private readonly float size;
    private readonly Vector3 centre;
    private readonly int width;
    private readonly int height;
    private readonly float tangentPerPixel;
    private readonly Vector3[] rows;
    private readonly float[] rowDistances;
    private readonly float[] columnDistances;

    public Backdrop(LightRig rig, Camera camera, GroundShadow? shadow, GroundContact? contact, BoundingBox bounds, int width, int height)
    {
        this.rig = rig;
        this.camera = camera;
        this.shadow = shadow;
        this.contact = contact;
        this.width = width;
        this.height = height;
        size = Math.Max(1e-6f, bounds.Diagonal);
        centre = bounds.Centre;
        tangentPerPixel = 1f / camera.PixelsPerTangent(height);
        rows = new Vector3[height];
        rowDistances = new float[height];
        columnDistances = new float[width];
        for (int y = 0; y < height; y++)
        {
            float down = (y + 0.5f) / height;
            rows[y] = Vec.Lerp(rig.Lighting.BackdropTop, rig.Lighting.BackdropBottom, Scalar.Smooth(down));
            rowDistances[y] = (down - GlowHeight) * (down - GlowHeight) * 5f;
        }

        for (int x = 0; x < width; x++)
        {
            float side = ((x + 0.5f) / width) - 0.5f;
            columnDistances[x] = side * side * 4.2f;
        }
    }

    /// <summary>The backdrop without shadows, linear RGB as displayed.</summary>
    public Vector3 Colour(int x, int y)
    {
        float glow = 1f / (1f + rowDistances[y] + columnDistances[x]);
        return rows[y] * (1f + (rig.Lighting.BackdropGlow * ((2f * glow) - 1f)));
    }

    /// <summary>What shadows leave of the floor's light at a pixel; 1 where there is none.</summary>
    public Vector3 Floor(int x, int y)
    {
        if (shadow is null || contact is null)
        {
            return Vector3.One;
        }

        Vector3 ray = camera.Forward
            + (camera.Right * ((x + 0.5f - (width * 0.5f)) * tangentPerPixel))
            + (camera.Up * (((height * 0.5f) - y - 0.5f) * tangentPerPixel));
        float drop = -camera.Eye.Y;
        if (drop >= 0f || ray.Y >= -1e-5f)
        {
            return Vector3.One;
        }

        Vector3 point = camera.Eye + (ray * (drop / ray.Y));
        point.Y = 0f;
        float shade = shadow.Shade(point);
        float hidden = contact.Hidden(point);
        if (shade <= 0f && hidden <= 0f)
        {
            return Vector3.One;
        }

        // Far from the creature the floor turns up into the wall.
        Vector3 away = point - centre;
        float far = ((away.X * away.X) + (away.Z * away.Z)) / (size * size);
        float fade = 1f / (1f + (0.35f * far));
        Vector3 sky = rig.Lighting.Sky;
        Vector3 key = rig.Lighting.Key * rig.Key.Y;
        Vector3 open = sky + key;
        Vector3 left = (sky * (1f - (rig.Lighting.ContactShadow * hidden))) + (key * (1f - shade) * (1f - (0.5f * rig.Lighting.ContactShadow * hidden)));
        return Vector3.One + (((left / open) - Vector3.One) * fade);
    }
}
