using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf.Models;

/// <summary>The animations of a document as clips of its skeleton. Tracks of nodes that are no joints, and of morph targets, are passed over.</summary>
internal sealed class ModelClips
{
    /// <summary>Most keys of one track.</summary>
    private const int MaxKeys = 1 << 22;

    /// <summary>Most by which animated scale may leave the scale at rest, as a part of it: what exporters lose in rounding.</summary>
    private const float ScaleSlack = 2e-3f;

    /// <summary>Most by which a joint ends other than it begins in a clip that goes around, radians, besides what it turns in a frame.</summary>
    private const float ClosedTurn = 0.02f;

    /// <summary>Seconds of a frame that may be missing at the end of one that goes around.</summary>
    private const float Frame = 1f / 30f;

    private readonly ModelDocument document;
    private readonly ModelJoints joints;
    private readonly AccessorReader accessors;
    private readonly Dictionary<int, float[]> times = new();

    private ModelClips(ModelDocument document, ModelJoints joints)
    {
        this.document = document;
        this.joints = joints;
        accessors = new AccessorReader(document);
    }

    /// <summary>Reads all animations that move a joint.</summary>
    public static IReadOnlyList<KeyedClip> Of(ModelDocument document, ModelJoints joints)
    {
        var reader = new ModelClips(document, joints);
        var clips = new List<KeyedClip>();
        var names = new HashSet<string>(StringComparer.Ordinal);
        IReadOnlyList<JsonValue> animations = document.All("animations");
        for (int i = 0; i < animations.Count; i++)
        {
            string name = ModelDocument.Text(animations[i], "name", string.Empty);
            if (name.Length == 0 || !names.Add(name))
            {
                name = (name.Length == 0 ? "Clip" : name) + "_" + ModelFault.Text(i);
                names.Add(name);
            }

            if (reader.Read(animations[i], name) is { } clip)
            {
                clips.Add(clip);
            }
        }

        return clips;
    }

    private KeyedClip? Read(JsonValue animation, string name)
    {
        Skeleton skeleton = joints.Skeleton;
        var rotations = new KeyTrack?[skeleton.Count];
        var positions = new KeyTrack?[skeleton.Count];
        IReadOnlyList<JsonValue> samplers = ModelDocument.ItemsOf(animation, "samplers");
        float duration = 0f;
        foreach (JsonValue channel in ModelDocument.ItemsOf(animation, "channels"))
        {
            JsonValue target = ModelDocument.Need(channel, "target", "a target");
            if (ModelDocument.Find(target, "node") is not { } node || joints.JointOf(ModelDocument.Whole(node, document.All("nodes").Count - 1)) is var joint && joint < 0)
            {
                continue;
            }

            JsonValue sampler = samplers[ModelDocument.Whole(ModelDocument.Need(channel, "sampler", "a sampler"), samplers.Count - 1)];
            string path = ModelDocument.Text(target, "path", string.Empty);
            KeyTrack? track = Track(sampler, path, joint);
            if (track is null)
            {
                continue;
            }

            KeyTrack?[] tracks = path == "rotation" ? rotations : positions;
            tracks[joint] = tracks[joint] is null ? track : throw new ModelFault(target.Path, skeleton.Joints[joint].Name + "." + path, "one channel for it");
            duration = Math.Max(duration, track.Times[track.Count - 1]);
        }

        return duration > 0f ? Finish(animation, name, duration, rotations, positions) : null;
    }

    private KeyedClip Finish(JsonValue animation, string name, float duration, KeyTrack?[] rotations, KeyTrack?[] positions)
    {
        Skeleton skeleton = joints.Skeleton;
        float[] beginning = { 0f };
        var turns = new KeyTrack[skeleton.Count];
        var places = new KeyTrack[skeleton.Count];
        for (int joint = 0; joint < skeleton.Count; joint++)
        {
            turns[joint] = rotations[joint] ?? KeyTrack.OfRotations(beginning, new[] { skeleton.LocalRotations[joint] }, KeyInterpolation.Step);
            places[joint] = positions[joint] ?? KeyTrack.OfPositions(beginning, new[] { skeleton.LocalPositions[joint] }, KeyInterpolation.Step);
        }

        JsonValue? extras = ModelDocument.Find(animation, "extras");
        bool loops = extras != null && ModelDocument.Find(extras, "loop") is { } told ? told.IsTrue : Closes(turns, duration);
        float speed = extras != null && ModelDocument.Find(extras, "speed") is { Kind: JsonKind.Number } given ? (float)given.Number : 0f;
        return new KeyedClip(name, loops ? ClipEnd.Loops : ClipEnd.Stays, duration, speed, turns, places, EventExtras.Read(extras, duration));
    }

    /// <summary>Whether joints end as they begin, wherever they have gone: files of other programs do not say which clips go around, and some leave out the frame that is the first again.</summary>
    private static bool Closes(KeyTrack[] turns, float duration)
    {
        return Array.TrueForAll(turns, track => Between(track, duration, 0f) <= ClosedTurn + (1.5f * Between(track, Math.Max(duration - Frame, 0f), duration)));

        static double Between(KeyTrack track, float a, float b) => Rotation.Angle(Rotation.Multiply(track.RotationAt(a, track.KeyAt(a, 0)), Rotation.Inverse(track.RotationAt(b, track.KeyAt(b, 0)))));
    }

    private KeyTrack? Track(JsonValue sampler, string path, int joint)
    {
        KeyInterpolation interpolation = ModelDocument.Text(sampler, "interpolation", "LINEAR") switch
        {
            "STEP" => KeyInterpolation.Step,
            "LINEAR" => KeyInterpolation.Linear,
            "CUBICSPLINE" => KeyInterpolation.Cubic,
            _ => throw ModelFault.At(sampler["interpolation"], "STEP, LINEAR or CUBICSPLINE"),
        };
        JsonValue output = ModelDocument.Need(sampler, "output", "values");
        float[] at = TimesOf(ModelDocument.Need(sampler, "input", "times"));
        int each = interpolation == KeyInterpolation.Cubic ? 3 : 1;
        switch (path)
        {
            case "rotation":
                return Rotations(at, Values(output, "VEC4", 4, each * at.Length), interpolation, output.Path);
            case "translation":
                return Positions(at, Values(output, "VEC3", 3, each * at.Length), interpolation, joint, output.Path);
            case "scale":
                RequireStill(Values(output, "VEC3", 3, each * at.Length), each, joint, output.Path);
                return null;
            default:
                return null;
        }
    }

    private float[] TimesOf(JsonValue index)
    {
        int accessor = ModelDocument.Whole(index, int.MaxValue);
        if (!times.TryGetValue(accessor, out float[]? at))
        {
            at = accessors.Floats(index, "SCALAR");
            if (at.Length is 0 or > MaxKeys)
            {
                throw new ModelFault(index.Path, FormattableString.Invariant($"{at.Length} times"), FormattableString.Invariant($"1 to {MaxKeys}"));
            }

            times.Add(accessor, at);
        }

        return at;
    }

    private float[] Values(JsonValue output, string type, int width, int count)
    {
        float[] values = accessors.Floats(output, type);
        return values.Length == width * count ? values : throw new ModelFault(output.Path, FormattableString.Invariant($"{values.Length / width} values"), FormattableString.Invariant($"{count} for its times"));
    }

    private static KeyTrack Rotations(float[] at, float[] values, KeyInterpolation interpolation, string where)
    {
        var rotations = new Quaternion[values.Length / 4];
        for (int i = 0; i < rotations.Length; i++)
        {
            var q = new Quaternion(values[4 * i], values[(4 * i) + 1], values[(4 * i) + 2], values[(4 * i) + 3]);
            bool tangent = interpolation == KeyInterpolation.Cubic && i % 3 != 1;
            rotations[i] = tangent ? q : NodePlace.UnitOf(q, where);
        }

        return Made(() => KeyTrack.OfRotations(at, rotations, interpolation), where);
    }

    private KeyTrack Positions(float[] at, float[] values, KeyInterpolation interpolation, int joint, string where)
    {
        float scale = joints.LengthOf(joint);
        var positions = new Vector3[values.Length / 3];
        for (int i = 0; i < positions.Length; i++)
        {
            positions[i] = new Vector3(values[3 * i], values[(3 * i) + 1], values[(3 * i) + 2]) * scale;
        }

        return Made(() => KeyTrack.OfPositions(at, positions, interpolation), where);
    }

    private void RequireStill(float[] values, int each, int joint, string where)
    {
        float rest = joints.Scales[joint] / joints.LengthOf(joint);
        for (int i = 0; i < values.Length; i++)
        {
            bool tangent = each == 3 && i / 3 % 3 != 1;
            if (!tangent && !(Math.Abs(values[i] - rest) <= ScaleSlack * rest))
            {
                throw new ModelFault(where, FormattableString.Invariant($"a scale of {values[i]} of {joints.Skeleton.Joints[joint].Name}"), FormattableString.Invariant($"its scale at rest, {rest}: joints do not grow"));
            }
        }
    }

    private static KeyTrack Made(Func<KeyTrack> make, string where)
    {
        try
        {
            return make();
        }
        catch (ArgumentException e)
        {
            throw new ModelFault(where, e.Message, "a sound track");
        }
    }
}
