using CreatureGen.Json;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf;

/// <summary>The JSON of clips: one animation each, plain linear keys, with speed and looping in its extras.</summary>
internal static class ClipWriter
{
    /// <summary>Writes all animations.</summary>
    public static void Write(JsonWriter json, ClipBuffers buffers)
    {
        json.Name("animations").BeginArray();
        for (int c = 0; c < buffers.Clips.Count; c++)
        {
            Write(json, buffers, c);
        }

        json.EndArray();
    }

    private static void Write(JsonWriter json, ClipBuffers buffers, int c)
    {
        Clip clip = buffers.Clips[c];
        json.BeginObject();
        json.Name("name").Text(clip.Name);
        json.Name("channels").BeginArray();
        int sampler = 0;
        foreach (int joint in buffers.Turning)
        {
            Channel(json, sampler++, joint, "rotation");
        }

        foreach (int joint in buffers.Sliding)
        {
            Channel(json, sampler++, joint, "translation");
        }

        json.EndArray();
        json.Name("samplers").BeginArray();
        for (int k = 0; k < buffers.Turning.Count; k++)
        {
            Sampler(json, buffers.TimesOf(c), buffers.RotationsOf(c, k));
        }

        for (int k = 0; k < buffers.Sliding.Count; k++)
        {
            Sampler(json, buffers.TimesOf(c), buffers.PositionsOf(c, k));
        }

        json.EndArray();
        json.Name("extras").BeginObject();
        json.Name("loop").Boolean(clip.End == ClipEnd.Loops);
        json.Name("speed").Number(clip.Speed);
        Models.EventExtras.Write(json, clip.Events);
        json.EndObject();
        json.EndObject();
    }

    private static void Channel(JsonWriter json, int sampler, int joint, string path)
    {
        json.BeginObject();
        json.Name("sampler").Number(sampler);
        json.Name("target").BeginObject().Name("node").Number(NodeTree.FirstJointNode + joint).Name("path").Text(path).EndObject();
        json.EndObject();
    }

    private static void Sampler(JsonWriter json, Accessor input, Accessor output)
    {
        json.BeginObject();
        json.Name("input").Number(input.Index);
        json.Name("interpolation").Text("LINEAR");
        json.Name("output").Number(output.Index);
        json.EndObject();
    }
}
