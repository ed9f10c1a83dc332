using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using CreatureGen.Skinning;

namespace CreatureGen.Lab;

/// <summary>The creature that the page shows before the library runs in it, as pictures: it stands and breathes. A browser moves them without the page's help, and before anything can be drawn.</summary>
internal static class FirstCreature
{
    /// <summary>The same seed and kind as in the page's own code.</summary>
    private const ulong Seed = 25;
    private const int Rate = 9;
    private const float SettleSeconds = 2f;
    private const int TextureSize = 512;

    /// <summary>Frames of the loop, at least and at most: it ends where it is most like its beginning.</summary>
    private const int FewestFrames = 14;
    private const int MaxFrames = 22;

    /// <summary>Steps from the darkest to the brightest that are kept of each colour: the file is half as large, and skin shows no bands.</summary>
    private const int Levels = 31;

    /// <summary>Widths of the soft edges, parts of the picture; the lower one ends above the picture's end.</summary>
    private const float FadeLeft = 0.07f;
    private const float FadeRight = 0.12f;
    private const float FadeBelow = 0.26f;
    private const float FadeEnd = 0.98f;

    private static readonly RenderOptions options = new() { Width = 360, Height = 315, Backdrop = BackdropKind.Transparent, Threads = Environment.ProcessorCount };

    /// <summary>It, on nothing but its shadow: as it stands, and the same moving.</summary>
    public static (byte[] Still, byte[] Moving) Pictures()
    {
        Creature creature = CreatureGenerator.Generate(Seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        List<(Vector3[] Positions, Vector3[] Normals)> poses = Poses(creature);
        CreatureTextures textures = CreatureTextures.Bake(creature, TextureSize);
        Camera camera = Camera.Fit(Views.Angle(View.ThreeQuarter), poses[0].Positions, options.Width / (float)options.Height);
        int frames = LoopLength(poses);
        using var file = new MemoryStream();
        var writer = new AnimatedPngWriter(file, frames, 1000 / Rate);
        byte[]? still = null;
        foreach ((Vector3[] positions, Vector3[] normals) in poses.Take(frames))
        {
            Picture picture = Renderer.Render(RenderMesh.From(creature, positions, normals).WithTextures(textures), camera, options);
            Fade(picture);
            still ??= PngWriter.ToBytes(picture);
            Coarsen(picture);
            writer.Add(picture);
        }

        return (still!, file.ToArray());
    }

    private static List<(Vector3[] Positions, Vector3[] Normals)> Poses(Creature creature)
    {
        var animator = new CreatureAnimator(creature);
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        for (float t = 0f; t < SettleSeconds; t += 1f / Rate)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
        }

        List<(Vector3[], Vector3[])> poses = [];
        for (int frame = 0; frame <= MaxFrames; frame++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
            var positions = new Vector3[creature.Mesh.Positions.Length];
            var normals = new Vector3[positions.Length];
            CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, positions, normals);
            poses.Add((positions, normals));
        }

        return poses;
    }

    /// <summary>Its shadow and what is near the edges end softly: a mask of the page would have every frame drawn twice, at a third of a processor.</summary>
    private static void Fade(Picture picture)
    {
        for (int y = 0; y < picture.Height; y++)
        {
            Span<byte> row = picture.Row(y);
            float down = (y + 0.5f) / picture.Height;
            for (int x = 0; x < picture.Width; x++)
            {
                float across = (x + 0.5f) / picture.Width;
                float share = Math.Clamp(across / FadeLeft, 0f, 1f) * Math.Clamp((1f - across) / FadeRight, 0f, 1f) * Math.Clamp((FadeEnd - down) / FadeBelow, 0f, 1f);
                row[(4 * x) + 3] = (byte)Math.Round(row[(4 * x) + 3] * share);
            }
        }
    }

    private static void Coarsen(Picture picture)
    {
        for (int y = 0; y < picture.Height; y++)
        {
            Span<byte> row = picture.Row(y);
            for (int at = 0; at < row.Length; at++)
            {
                // Not how opaque it is: its shadow would have rings.
                int level = ((row[at] * Levels) + 127) / 255;
                row[at] = at % 4 == 3 ? row[at] : (byte)(((level * 255) + (Levels / 2)) / Levels);
            }
        }
    }

    private static int LoopLength(List<(Vector3[] Positions, Vector3[] Normals)> poses) =>
        Enumerable.Range(FewestFrames, MaxFrames - FewestFrames + 1).MinBy(n => poses[n].Positions.Zip(poses[0].Positions, Vector3.DistanceSquared).Sum(apart => (double)apart));
}
