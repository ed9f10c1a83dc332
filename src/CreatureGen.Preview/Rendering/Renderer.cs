using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>Makes pictures of meshes in software. The same mesh, camera and options give the same bytes on every machine and for any number of threads.</summary>
public static class Renderer
{
    private const int LargestSide = 8192;

    // Distance within which surfaces shade each other, part of the longest side of the creature.
    private const float OcclusionPart = 0.08f;

    // Room around the creature for the softest edge of its shadow, part of the grid at each edge.
    private const float ShadowBorder = 0.1f;

    /// <summary>Draws a mesh as a camera sees it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">An option is out of its range.</exception>
    public static Picture Render(RenderMesh mesh, Camera camera, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(camera);
        ArgumentNullException.ThrowIfNull(options);
        Check(options);
        var frame = new Frame(mesh, camera, options);
        var picture = new Picture(options.Width, options.Height, options.Backdrop == BackdropKind.Transparent ? PixelLayout.Rgba : PixelLayout.Rgb);
        Work.Share(frame.TileCount, options.Threads, tile => frame.DrawTile(tile, picture));
        return picture;
    }

    /// <summary>Throws if an option is out of its range.</summary>
    internal static void Check(RenderOptions options)
    {
        CheckRange(options.Width, 1, LargestSide, nameof(options.Width));
        CheckRange(options.Height, 1, LargestSide, nameof(options.Height));
        CheckRange(options.Threads, 1, int.MaxValue, nameof(options.Threads));
        if (!(options.Opacity >= 0f && options.Opacity <= 1f))
        {
            throw new ArgumentOutOfRangeException(nameof(options), options.Opacity, "Opacity; expected 0..1");
        }
    }

    private static void CheckRange(int value, int min, int max, string name)
    {
        if (value < min || value > max)
        {
            throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"expected {min}..{max}"));
        }
    }

    /// <summary>All that is known of one picture before its pixels are coloured.</summary>
    private sealed class Frame
    {
        private readonly RenderMesh mesh;
        private readonly RenderOptions options;
        private readonly SamplePattern pattern;
        private readonly VisibleSurface surface;
        private readonly SurfaceLight? light;
        private readonly StudioShader shader;
        private readonly Backdrop backdrop;
        private readonly Vector3 flatLight;

        public Frame(RenderMesh mesh, Camera camera, RenderOptions options)
        {
            this.mesh = mesh;
            this.options = options;
            pattern = SamplePattern.Of(options.Samples);
            var rig = new LightRig(options.Lighting, camera);
            flatLight = options.FlatLightDirection ?? rig.Key;
            surface = VisibleSurface.Find(mesh, camera, options);

            bool studio = options.Shading is ShadingMode.Smooth or ShadingMode.Faceted;
            bool ground = options.Ground == GroundKind.Shadows && mesh.Triangles.Length > 0;
            BoundingBox bounds = mesh.Bounds;
            float size = Math.Max(bounds.Size.X, Math.Max(bounds.Size.Y, bounds.Size.Z));
            HeightRaster? fromLight = mesh.Triangles.Length > 0 && (studio || ground) ? new HeightRaster(mesh, rig.Key, ShadowSize(options), ShadowBorder) : null;
            GroundContact? contact = ground ? new GroundContact(mesh) : null;
            light = studio && fromLight is not null
                ? SurfaceLight.Measure(surface, camera, new ShadowMap(fromLight, options.Lighting.KeySize), size * OcclusionPart, options.Threads)
                : null;
            shader = new StudioShader(rig, contact, camera);
            GroundShadow? shadow = ground && fromLight is not null ? new GroundShadow(fromLight, options.Lighting.KeySize) : null;
            backdrop = new Backdrop(rig, camera, shadow, contact, bounds, options.Width, options.Height);
        }

        public int TileCount => surface.Bins.Count;

        public void DrawTile(int tile, Picture picture)
        {
            surface.Bins.Pixels(tile, out int left, out int top, out int right, out int bottom);
            ReadOnlySpan<Fragment> fragments = surface.Fragments[tile];
            int next = 0;
            for (int y = top; y < bottom; y++)
            {
                Span<byte> row = picture.Row(y);
                for (int x = left; x < right; x++)
                {
                    int pixel = (y * options.Width) + x;
                    Vector3 sum = Vector3.Zero;
                    int covered = 0;
                    while (next < fragments.Length && fragments[next].Pixel == pixel)
                    {
                        int samples = BitOperations.PopCount((uint)fragments[next].Mask);
                        Vector2 open = light is null ? Vector2.One : covered == 0 ? light.AtPixel(pixel) : light.Near(pixel, fragments[next].Depth);
                        sum += Colour(in fragments[next], open) * samples;
                        covered += samples;
                        next++;
                    }

                    float opacity = covered * options.Opacity / pattern.Count;
                    Vector3 colour = covered > 0 ? sum / covered : Vector3.Zero;
                    if (options.Backdrop == BackdropKind.Transparent)
                    {
                        PutTransparent(row, x, y, colour, opacity);
                    }
                    else
                    {
                        if (opacity < 1f)
                        {
                            // A half transparent creature does not show its own shadow through itself.
                            Vector3 floor = Vec.Lerp(backdrop.Floor(x, y), Vector3.One, (1f - options.Opacity) * covered / pattern.Count);
                            Vector3 behind = backdrop.Colour(x, y) * floor;
                            colour = (colour * opacity) + (behind * (1f - opacity));
                        }

                        row[3 * x] = SrgbCurve.Encode(colour.X);
                        row[(3 * x) + 1] = SrgbCurve.Encode(colour.Y);
                        row[(3 * x) + 2] = SrgbCurve.Encode(colour.Z);
                    }
                }
            }
        }

        // Texels of the shadow map: about those of the picture.
        private static int ShadowSize(RenderOptions options)
        {
            int size = 256;
            while (size < Math.Max(options.Width, options.Height) && size < 1024)
            {
                size *= 2;
            }

            return size;
        }

        // Shadows on the floor become black of the opacity that darkens a white page alike.
        private void PutTransparent(Span<byte> row, int x, int y, Vector3 colour, float opacity)
        {
            Vector3 floor = opacity < 1f ? backdrop.Floor(x, y) : Vector3.One;
            float shade = (1f - opacity) * (1f - ((floor.X + floor.Y + floor.Z) * (1f / 3f)));
            float total = opacity + shade;
            float part = total > 0f ? opacity / total : 0f;
            row[4 * x] = SrgbCurve.Encode(colour.X * part);
            row[(4 * x) + 1] = SrgbCurve.Encode(colour.Y * part);
            row[(4 * x) + 2] = SrgbCurve.Encode(colour.Z * part);
            row[(4 * x) + 3] = (byte)((total * 255f) + 0.5f);
        }

        // What a fragment shows; open is how open it is to the light around it (X) and to the key light (Y).
        private Vector3 Colour(in Fragment fragment, Vector2 open)
        {
            ref readonly ScreenTriangle triangle = ref surface.Triangles[fragment.Triangle];
            int i0 = mesh.Triangles[triangle.Source];
            int i1 = mesh.Triangles[triangle.Source + 1];
            int i2 = mesh.Triangles[triangle.Source + 2];
            float b = fragment.B;
            float c = fragment.C;
            float a = 1f - b - c;
            if (options.Shading == ShadingMode.Flat)
            {
                a = b = c = 1f / 3f;
            }

            Vector3 colour = (mesh.Colours[i0] * a) + (mesh.Colours[i1] * b) + (mesh.Colours[i2] * c);
            if (mesh.Texture is not null)
            {
                colour *= Sample(mesh.Texture, in triangle, a, b, c, i0, i1, i2);
            }

            if (options.Shading == ShadingMode.Unlit)
            {
                return colour;
            }

            var normal = new Vector3(fragment.NormalX, fragment.NormalY, fragment.NormalZ);
            if (options.Shading == ShadingMode.Flat)
            {
                return FlatShading.Lit(normal, flatLight, colour);
            }

            if (mesh.NormalMap is not null && options.Shading == ShadingMode.Smooth)
            {
                normal = Embossed(normal, Sample(mesh.NormalMap, in triangle, a, b, c, i0, i1, i2), i0, i1, i2);
            }

            Vector3 point = (mesh.Positions[i0] * a) + (mesh.Positions[i1] * b) + (mesh.Positions[i2] * c);
            SurfaceMaterial material = mesh.Parts[triangle.Part].Material;
            float gloss = material.Gloss;
            if (mesh.Gloss.Length > 0)
            {
                gloss = Math.Max(gloss, (mesh.Gloss[i0] * a) + (mesh.Gloss[i1] * b) + (mesh.Gloss[i2] * c));
            }

            return ToneCurve.Apply(shader.Light(point, normal, colour, gloss, material.Translucency, open.X, open.Y));
        }

        // The normal turned as the normal map says, in the frame of the directions in which u and v grow over the triangle.
        private Vector3 Embossed(Vector3 normal, Vector3 texel, int i0, int i1, int i2)
        {
            Vector2 g = mesh.Texcoords[i1] - mesh.Texcoords[i0];
            Vector2 h = mesh.Texcoords[i2] - mesh.Texcoords[i0];
            float area = (g.X * h.Y) - (g.Y * h.X);
            if (area == 0f)
            {
                return normal;
            }

            Vector3 e = mesh.Positions[i1] - mesh.Positions[i0];
            Vector3 f = mesh.Positions[i2] - mesh.Positions[i0];
            float sign = area < 0f ? -1f : 1f;
            Vector3 alongU = Vec.Normalize(Vec.Reject(((e * h.Y) - (f * g.Y)) * sign, normal), Vector3.Zero);
            Vector3 alongV = Vec.Normalize(Vec.Reject(((f * g.X) - (e * h.X)) * sign, normal), Vector3.Zero);
            return Vec.Normalize((normal * ((2f * texel.Z) - 1f)) + (alongU * ((2f * texel.X) - 1f)) - (alongV * ((2f * texel.Y) - 1f)), normal);
        }

        /// <summary>The last level on which the charts of an atlas are apart, which are so by 2/256 of its side: on smaller ones the edge of a chart takes on the colour of the next, a pale tick on the back that is seen aslant.</summary>
        private static int LastApart(Texture texture) => BitOperations.Log2((uint)Math.Max(1, texture.Width / CreatureTextures.SmallestSize));

        private Vector3 Sample(Texture texture, in ScreenTriangle triangle, float a, float b, float c, int i0, int i1, int i2)
        {
            Vector2 t0 = mesh.Texcoords[i0];
            Vector2 t1 = mesh.Texcoords[i1];
            Vector2 t2 = mesh.Texcoords[i2];
            float u = (t0.X * a) + (t1.X * b) + (t2.X * c);
            float v = (t0.Y * a) + (t1.Y * b) + (t2.Y * c);
            float texels = Math.Abs(((t1.X - t0.X) * (t2.Y - t0.Y)) - ((t2.X - t0.X) * (t1.Y - t0.Y))) * texture.Width * texture.Height;
            const float Square = 1f / (ScreenProjection.SubPixel * ScreenProjection.SubPixel);
            float pixels = (((float)(triangle.X1 - triangle.X0) * (triangle.Y2 - triangle.Y0)) - ((float)(triangle.X2 - triangle.X0) * (triangle.Y1 - triangle.Y0))) * Square;
            return texture.Sample(u, v, Math.Min(Texture.LevelFor(texels / Math.Max(1e-6f, pixels)), LastApart(texture)));
        }
    }
}
