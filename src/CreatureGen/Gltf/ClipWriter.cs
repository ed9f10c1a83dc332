using CreatureGen.Json;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf;

/// <summary>The JSON of clips: one animation each, with speed, looping and events in its extras.</summary>
internal static class ClipWriter
{
    /// <summary>Writes all animations.</summary>
    public static void Write(JsonWriter json, ClipBuffers buffers, TargetEngine engine)
    {
        json.Name("animations").BeginArray();
        for (int c = 0; c < buffers.Clips.Count; c++)
        {
            Write(json, buffers, c, engine);
        }

        json.EndArray();
    }

    /// <summary>Writes what is to know of all clips as a member of the root joint's extras, for importers that drop those of animations.</summary>
    public static void WriteMirror(JsonWriter json, ClipBuffers buffers, TargetEngine engine)
    {
        if (engine == TargetEngine.Generic || buffers.Clips.Count == 0)
        {
            return;
        }

        json.Name("clips").BeginArray();
        foreach (Clip clip in buffers.Clips)
        {
            json.BeginObject();
            json.Name("name").Text(clip.Name);
            Facts(json, buffers, clip);
            json.EndObject();
        }

        json.EndArray();
    }

    /// <summary>The name of an animation, as an engine's importer tells loops by it.</summary>
    public static string NameOf(Clip clip, TargetEngine engine) => engine == TargetEngine.Godot && clip.End == ClipEnd.Loops ? clip.Name + "-loop" : clip.Name;

    private static void Write(JsonWriter json, ClipBuffers buffers, int c, TargetEngine engine)
    {
        Clip clip = buffers.Clips[c];
        json.BeginObject();
        json.Name("name").Text(NameOf(clip, engine));
        json.Name("channels").BeginArray();
        int sampler = 0;
        foreach (ClipChannel channel in buffers.Channels(c))
        {
            json.BeginObject();
            json.Name("sampler").Number(sampler++);
            json.Name("target").BeginObject().Name("node").Number(NodeTree.FirstJointNode + channel.Joint).Name("path").Text(channel.Path).EndObject();
            json.EndObject();
        }

        json.EndArray();
        json.Name("samplers").BeginArray();
        foreach (ClipChannel channel in buffers.Channels(c))
        {
            json.BeginObject();
            json.Name("input").Number(channel.Times.Index);
            json.Name("interpolation").Text(WordFor(channel.Interpolation));
            json.Name("output").Number(channel.Values.Index);
            json.EndObject();
        }

        json.EndArray();
        json.Name("extras").BeginObject();
        Facts(json, buffers, clip);
        json.EndObject();
        json.EndObject();
    }

    private static void Facts(JsonWriter json, ClipBuffers buffers, Clip clip)
    {
        json.Name("loop").Boolean(clip.End == ClipEnd.Loops);
        json.Name("speed").Number(buffers.SpeedOf(clip));
        Models.EventExtras.Write(json, clip.Events);
    }

    private static string WordFor(KeyInterpolation interpolation) => interpolation switch
    {
        KeyInterpolation.Step => "STEP",
        KeyInterpolation.Linear => "LINEAR",
        _ => "CUBICSPLINE",
    };
}
