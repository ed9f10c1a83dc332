using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text;
using System.Text.Json;
using System.Threading;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Creatures;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Working;

/// <summary>What a training set needs of a creature: it from several sides with distance, normals and parts of each pixel, its joints in each picture, and its motion as numbers.</summary>
/// <param name="Views">From how many sides; 0 for no data set.</param>
/// <param name="Width">Pixels in a row.</param>
/// <param name="Height">Rows.</param>
internal sealed record DatasetOrder(int Views, int Width, int Height)
{
    /// <summary>No data set.</summary>
    public static DatasetOrder None { get; } = new(0, 0, 0);

    // Around the creature in even steps, in turn from these elevations.
    private static readonly double[] elevations = [12, 28, 4, 45];

    /// <summary>The forms of a creature's files.</summary>
    public IEnumerable<string> Forms => Views == 0 ? [] : Enumerable.Range(0, Views).SelectMany(view => new[] { Form("view", view, "png"), Form("depth", view, "npy"), Form("normals", view, "npy"), Form("parts", view, "npy") }).Append("poses.npy").Append("labels.json");

    /// <summary>Makes the files.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="textures">Its atlas; null for none.</param>
    /// <param name="clips">Its motion.</param>
    /// <param name="name">What its files are called after.</param>
    /// <param name="backdrop">What is behind it.</param>
    /// <param name="threads">Threads that share the work.</param>
    /// <param name="cancellation">Stops between two pictures.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public IEnumerable<(string Form, byte[] Content)> Make(Creature creature, CreatureTextures? textures, IReadOnlyList<Clip> clips, string name, BackdropKind backdrop, int threads, CancellationToken cancellation)
    {
        if (Views == 0)
        {
            yield break;
        }

        RenderMesh plain = RenderMesh.From(creature);
        RenderMesh dressed = textures is null ? plain : plain.WithTextures(textures);
        ushort[] parts = Parts(creature);
        var cameras = new Camera[Views];
        for (int view = 0; view < Views; view++)
        {
            cancellation.ThrowIfCancellationRequested();
            Camera camera = cameras[view] = Camera.Fit(new CameraAngle(360.0 * view / Views, elevations[view % elevations.Length]), plain.Positions, (float)Width / Height);
            SurfaceMaps maps = SurfaceMaps.Find(plain, camera, Width, Height, threads);
            var options = new RenderOptions { Width = Width, Height = Height, Backdrop = backdrop, Ground = backdrop == BackdropKind.Transparent ? GroundKind.None : GroundKind.Shadows, Threads = threads };
            yield return (Form("view", view, "png"), PngWriter.ToBytes(Renderer.Render(dressed, camera, options)));
            yield return (Form("depth", view, "npy"), NumberArray.Of(maps.Depths, Height, Width));
            yield return (Form("normals", view, "npy"), NumberArray.Of(NormalsSeen(maps), Height, Width, 3));
            yield return (Form("parts", view, "npy"), NumberArray.Of(PartsSeen(maps, parts), Height, Width));
        }

        cancellation.ThrowIfCancellationRequested();
        yield return ("poses.npy", Poses(creature.Skeleton.Count, clips));
        yield return ("labels.json", Encoding.UTF8.GetBytes(Labels(creature, clips, cameras, name)));
    }

    private static string Form(string what, int view, string ending) => FormattableString.Invariant($"{what}-{view}.{ending}");

    /// <summary>Of each triangle the joint that moves it most, from 1.</summary>
    private static ushort[] Parts(Creature creature)
    {
        var parts = new ushort[creature.Mesh.Triangles.Length / 3];
        float[] sums = new float[creature.Skeleton.Count];
        for (int triangle = 0; triangle < parts.Length; triangle++)
        {
            Array.Clear(sums);
            for (int corner = 0; corner < 3; corner++)
            {
                Skinning.SkinWeights s = creature.Mesh.Weights[creature.Mesh.Triangles[(3 * triangle) + corner]];
                sums[s.Joint0] += s.Weights.X;
                sums[s.Joint1] += s.Weights.Y;
                sums[s.Joint2] += s.Weights.Z;
                sums[s.Joint3] += s.Weights.W;
            }

            parts[triangle] = (ushort)(1 + Array.IndexOf(sums, sums.Max()));
        }

        return parts;
    }

    private static Half[] NormalsSeen(SurfaceMaps maps)
    {
        var numbers = new Half[3 * maps.Normals.Length];
        for (int i = 0; i < maps.Normals.Length; i++)
        {
            (numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]) = ((Half)maps.Normals[i].X, (Half)maps.Normals[i].Y, (Half)maps.Normals[i].Z);
        }

        return numbers;
    }

    private static ushort[] PartsSeen(SurfaceMaps maps, ushort[] parts)
    {
        var seen = new ushort[maps.Triangles.Length];
        for (int i = 0; i < seen.Length; i++)
        {
            seen[i] = maps.Triangles[i] < 0 ? (ushort)0 : parts[maps.Triangles[i]];
        }

        return seen;
    }

    /// <summary>Of each frame of all clips, one after the other, rotation (x, y, z, w) and position (x, y, z) of each joint in its parent's space.</summary>
    private static byte[] Poses(int joints, IReadOnlyList<Clip> clips)
    {
        var numbers = new List<float>();
        int frames = 0;
        foreach (Clip clip in clips)
        {
            for (int frame = 0; frame < clip.Frames; frame++, frames++)
            {
                ReadOnlySpan<Quaternion> rotations = clip.RotationsAt(frame);
                ReadOnlySpan<Vector3> positions = clip.PositionsAt(frame);
                for (int joint = 0; joint < joints; joint++)
                {
                    numbers.AddRange([rotations[joint].X, rotations[joint].Y, rotations[joint].Z, rotations[joint].W, positions[joint].X, positions[joint].Y, positions[joint].Z]);
                }
            }
        }

        return NumberArray.Of(numbers.ToArray(), frames, joints, 7);
    }

    private string Labels(Creature creature, IReadOnlyList<Clip> clips, Camera[] cameras, string name) => JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteString("creature", name);
        json.WriteNumber("width", Width);
        json.WriteNumber("height", Height);
        json.WriteStartArray("joints");
        for (int joint = 0; joint < creature.Skeleton.Count; joint++)
        {
            json.WriteStartObject();
            json.WriteString("name", creature.Skeleton.Joints[joint].Name);
            json.WriteNumber("parent", creature.Skeleton.Parents[joint]);
            json.WriteNumber("part", joint + 1);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("views");
        for (int view = 0; view < cameras.Length; view++)
        {
            Camera camera = cameras[view];
            json.WriteStartObject();
            foreach ((string what, string ending) in new[] { ("view", "png"), ("depth", "npy"), ("normals", "npy"), ("parts", "npy") })
            {
                json.WriteString(what, CreatureFiles.PathOf("", name, Form(what, view, ending)));
            }

            Write(json, "eye", camera.Eye);
            Write(json, "right", camera.Right);
            Write(json, "up", camera.Up);
            Write(json, "forward", camera.Forward);
            json.WriteNumber("fieldOfViewDegrees", camera.FieldOfViewDegrees);
            json.WriteStartArray("joints");
            foreach (Vector3 position in creature.Skeleton.ModelPositions)
            {
                Write(json, null, camera.Project(position, Width, Height));
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("clips");
        int first = 0;
        foreach (Clip clip in clips)
        {
            json.WriteStartObject();
            json.WriteString("name", clip.Name);
            json.WriteNumber("rate", clip.Rate);
            json.WriteNumber("speed", clip.Speed);
            json.WriteNumber("first", first);
            json.WriteNumber("frames", clip.Frames);
            json.WriteEndObject();
            first += clip.Frames;
        }

        json.WriteEndArray();
        json.WriteEndObject();
    });

    private static void Write(Utf8JsonWriter json, string? name, Vector3 vector)
    {
        if (name != null)
        {
            json.WritePropertyName(name);
        }

        json.WriteStartArray();
        json.WriteNumberValue(vector.X);
        json.WriteNumberValue(vector.Y);
        json.WriteNumberValue(vector.Z);
        json.WriteEndArray();
    }
}
