using System;
using System.Collections.Generic;
using System.IO;
using System.Numerics;
using CreatureGen.Json;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf.Models;

/// <summary>Writes a model back with clips added. All else of its file stays as it was: materials, textures, morph targets, its own clips.</summary>
public static class ModelWriter
{
    /// <summary>Keys per second of clips that are not recorded frame by frame.</summary>
    private const float KeyRate = 30f;

    // A joint moves when it leaves its rest pose by more than rounding.
    private const float Still = 1e-6f;

    /// <summary>Writes a model. Nothing is written if it throws <see cref="ArgumentException"/>.</summary>
    /// <param name="model">The model, as <see cref="ModelReader"/> gave it.</param>
    /// <param name="clips">Clips of its skeleton; keyed 30 times a second, in straight lines between keys.</param>
    /// <param name="destination">Takes the bytes; is neither flushed nor closed.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A clip is of another number of joints, or its name is taken.</exception>
    public static void Write(SkinnedModel model, IReadOnlyList<IClip> clips, Stream destination)
    {
        _ = model ?? throw new ArgumentNullException(nameof(model));
        _ = clips ?? throw new ArgumentNullException(nameof(clips));
        _ = destination ?? throw new ArgumentNullException(nameof(destination));
        Require(model, clips);
        var added = new AddedClips(model);
        foreach (IClip clip in clips)
        {
            added.Add(clip);
        }

        using var json = new JsonWriter(JsonLayout.Compact);
        added.Write(json);
        GlbContainer.Write(destination, json.Utf8, added.Binary());
    }

    private static void Require(SkinnedModel model, IReadOnlyList<IClip> clips)
    {
        var names = new HashSet<string>(StringComparer.Ordinal);
        foreach (KeyedClip own in model.Clips)
        {
            names.Add(own.Name);
        }

        foreach (IClip clip in clips)
        {
            if (clip.Joints != model.Skeleton.Count)
            {
                throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} has {clip.Joints} joints; expected the {model.Skeleton.Count} of the model"), nameof(clips));
            }

            if (!names.Add(clip.Name))
            {
                throw new ArgumentException($"clip {clip.Name} has the name of another; expected unique names", nameof(clips));
            }
        }
    }

    /// <summary>The parts of the document that grow: accessors, their views and bytes, animations.</summary>
    private sealed class AddedClips
    {
        private readonly SkinnedModel model;
        private readonly MemoryStream bytes = new();
        private readonly List<(int Offset, int Length)> views = new();
        private readonly List<(int View, int Count, string Type, float? Last)> accessors = new();
        private readonly List<(IClip Clip, List<(int Node, string Path, int Input, int Output)> Channels)> animations = new();

        public AddedClips(SkinnedModel model)
        {
            this.model = model;
            bytes.Write(model.Document.Binary, 0, model.Document.Binary.Length);
        }

        private int FirstView => model.Document.All("bufferViews").Count;

        private int FirstAccessor => model.Document.All("accessors").Count;

        /// <summary>Samples a clip and keeps the tracks that move.</summary>
        public void Add(IClip clip)
        {
            Skeleton skeleton = model.Skeleton;
            int count = skeleton.Count;
            int keys = Math.Max(2, (int)Math.Ceiling(clip.Duration * KeyRate - 1e-3f) + 1);
            var turns = new Quaternion[count * keys];
            var places = new Vector3[count * keys];
            float[] times = new float[keys];
            for (int k = 0; k < keys; k++)
            {
                times[k] = k == keys - 1 ? clip.Duration : clip.Duration * k / (keys - 1);
                clip.Sample(times[k], new Pose(turns.AsSpan(k * count, count), places.AsSpan(k * count, count)));
            }

            int input = Add(times, 1, "SCALAR", clip.Duration);
            var channels = new List<(int Node, string Path, int Input, int Output)>();
            for (int joint = 0; joint < count; joint++)
            {
                if (Turns(turns, joint, keys, out float[] rotations))
                {
                    channels.Add((model.Joints.Nodes[joint], "rotation", input, Add(rotations, 4, "VEC4", null)));
                }

                if (Slides(places, joint, keys, out float[] translations))
                {
                    channels.Add((model.Joints.Nodes[joint], "translation", input, Add(translations, 3, "VEC3", null)));
                }
            }

            animations.Add((clip, channels));
        }

        public byte[] Binary() => bytes.ToArray();

        /// <summary>Writes the document anew, with what was added.</summary>
        public void Write(JsonWriter json)
        {
            json.BeginObject();
            foreach (JsonMember member in model.Document.Root.Members)
            {
                json.Name(member.Name);
                switch (member.Name)
                {
                    case "bufferViews":
                        Grown(json, member.Value, WriteViews);
                        break;
                    case "accessors":
                        Grown(json, member.Value, WriteAccessors);
                        break;
                    case "animations":
                        Grown(json, member.Value, WriteAnimations);
                        break;
                    case "buffers":
                        WriteBuffers(json, member.Value);
                        break;
                    default:
                        JsonCopy.Write(json, member.Value);
                        break;
                }
            }

            if (model.Document.All("animations").Count == 0 && animations.Count > 0)
            {
                json.Name("animations").BeginArray();
                WriteAnimations(json);
                json.EndArray();
            }

            json.EndObject();
        }

        private static void Grown(JsonWriter json, JsonValue array, Action<JsonWriter> write)
        {
            json.BeginArray();
            foreach (JsonValue item in array.Items)
            {
                JsonCopy.Write(json, item);
            }

            write(json);
            json.EndArray();
        }

        private bool Turns(Quaternion[] turns, int joint, int keys, out float[] numbers)
        {
            int count = model.Skeleton.Count;
            Quaternion rest = model.Skeleton.LocalRotations[joint];
            Quaternion before = rest;
            numbers = new float[4 * keys];
            bool moves = false;
            for (int k = 0; k < keys; k++)
            {
                Quaternion q = turns[(k * count) + joint];
                q = (q.X * before.X) + (q.Y * before.Y) + (q.Z * before.Z) + (q.W * before.W) < 0f ? new Quaternion(-q.X, -q.Y, -q.Z, -q.W) : q;
                moves |= Math.Abs(q.X - rest.X) + Math.Abs(q.Y - rest.Y) + Math.Abs(q.Z - rest.Z) + Math.Abs(q.W - rest.W) > Still;
                (numbers[4 * k], numbers[(4 * k) + 1], numbers[(4 * k) + 2], numbers[(4 * k) + 3]) = (q.X, q.Y, q.Z, q.W);
                before = q;
            }

            return moves;
        }

        private bool Slides(Vector3[] places, int joint, int keys, out float[] numbers)
        {
            int count = model.Skeleton.Count;
            float scale = model.Joints.LengthOf(joint);
            Vector3 rest = model.Skeleton.LocalPositions[joint];
            numbers = new float[3 * keys];
            bool moves = false;
            for (int k = 0; k < keys; k++)
            {
                Vector3 p = places[(k * count) + joint];
                moves |= Math.Abs(p.X - rest.X) + Math.Abs(p.Y - rest.Y) + Math.Abs(p.Z - rest.Z) > Still;
                p /= scale;
                (numbers[3 * k], numbers[(3 * k) + 1], numbers[(3 * k) + 2]) = (p.X, p.Y, p.Z);
            }

            return moves;
        }

        private int Add(float[] numbers, int width, string type, float? last)
        {
            while (bytes.Length % 4 != 0)
            {
                bytes.WriteByte(0);
            }

            int offset = checked((int)bytes.Length);
            byte[] raw = new byte[4 * numbers.Length];
            for (int i = 0; i < numbers.Length; i++)
            {
                LittleEndian.Write(raw, 4 * i, numbers[i]);
            }

            bytes.Write(raw, 0, raw.Length);
            views.Add((offset, raw.Length));
            accessors.Add((FirstView + views.Count - 1, numbers.Length / width, type, last));
            return FirstAccessor + accessors.Count - 1;
        }

        private void WriteViews(JsonWriter json)
        {
            foreach ((int offset, int length) in views)
            {
                json.BeginObject();
                json.Name("buffer").Number(0);
                json.Name("byteOffset").Number(offset);
                json.Name("byteLength").Number(length);
                json.EndObject();
            }
        }

        private void WriteAccessors(JsonWriter json)
        {
            foreach ((int view, int count, string type, float? last) in accessors)
            {
                json.BeginObject();
                json.Name("bufferView").Number(view);
                json.Name("componentType").Number(5126);
                json.Name("count").Number(count);
                json.Name("type").Text(type);
                if (last is { } seconds)
                {
                    json.Name("min").BeginArray().Number(0f).EndArray();
                    json.Name("max").BeginArray().Number(seconds).EndArray();
                }

                json.EndObject();
            }
        }

        private void WriteBuffers(JsonWriter json, JsonValue buffers)
        {
            json.BeginArray();
            for (int i = 0; i < buffers.Items.Count; i++)
            {
                json.BeginObject();
                foreach (JsonMember member in buffers.Items[i].Members)
                {
                    json.Name(member.Name);
                    if (i == 0 && member.Name == "byteLength")
                    {
                        json.Number(bytes.Length);
                    }
                    else
                    {
                        JsonCopy.Write(json, member.Value);
                    }
                }

                json.EndObject();
            }

            json.EndArray();
        }

        private void WriteAnimations(JsonWriter json)
        {
            foreach ((IClip clip, List<(int Node, string Path, int Input, int Output)> channels) in animations)
            {
                json.BeginObject();
                json.Name("name").Text(clip.Name);
                json.Name("channels").BeginArray();
                for (int c = 0; c < channels.Count; c++)
                {
                    json.BeginObject().Name("sampler").Number(c);
                    json.Name("target").BeginObject().Name("node").Number(channels[c].Node).Name("path").Text(channels[c].Path).EndObject();
                    json.EndObject();
                }

                json.EndArray();
                json.Name("samplers").BeginArray();
                foreach ((int _, string _, int input, int output) in channels)
                {
                    json.BeginObject().Name("input").Number(input).Name("interpolation").Text("LINEAR").Name("output").Number(output).EndObject();
                }

                json.EndArray();
                json.Name("extras").BeginObject();
                json.Name("loop").Boolean(clip.End == ClipEnd.Loops);
                json.Name("speed").Number(clip.Speed);
                EventExtras.Write(json, clip.Events);
                json.EndObject();
                json.EndObject();
            }
        }
    }
}
