using System;
using System.Linq;
using System.Text.Json;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Batches;

/// <summary>What is made of seeds, as JSON: all that decides about the bytes of a creature's files but its seed and the versions. The names are a contract.</summary>
internal static class TaskJson
{
    /// <summary>Writes it as an object.</summary>
    public static void Write(Utf8JsonWriter json, CreatureTask task)
    {
        json.WriteStartObject();
        json.WritePropertyName("options");
        using (JsonDocument options = JsonDocument.Parse(OptionsJson.Write(task.Options with { Individual = null })))
        {
            options.RootElement.WriteTo(json);
        }

        json.WriteStartObject("export");
        json.WriteString("shading", WordList<Shading>.Instance[task.Export.Shading]);
        json.WriteString("levels", WordList<LodChoice>.Instance[task.Export.Lods]);
        json.WriteString("materials", WordList<MaterialChoice>.Instance[task.Export.Materials]);
        json.WriteNumber("textureSize", task.Export.TextureSize);
        json.WriteString("clips", task.Clips.Text);
        if (task.Export.ClipPrecision is null)
        {
            json.WriteString("keys", "all");
        }

        if (task.Export.RootMotion != RootMotionChoice.InPlace)
        {
            json.WriteString("rootMotion", WordList<RootMotionChoice>.Instance[task.Export.RootMotion]);
        }

        if (task.Export.Engine != TargetEngine.Generic)
        {
            json.WriteString("engine", WordList<TargetEngine>.Instance[task.Export.Engine]);
        }

        json.WriteEndObject();
        json.WriteStartObject("pictures");
        json.WriteStartArray("views");
        foreach (View view in task.Pictures.Views)
        {
            json.WriteStringValue(Views.Word(view));
        }

        json.WriteEndArray();
        json.WriteNumber("width", task.Pictures.Width);
        json.WriteNumber("height", task.Pictures.Height);
        json.WriteString("backdrop", WordList<BackdropKind>.Instance[task.Pictures.Backdrop]);
        json.WriteEndObject();
        json.WriteStartObject("dataset");
        json.WriteNumber("views", task.Dataset.Views);
        json.WriteNumber("width", task.Dataset.Width);
        json.WriteNumber("height", task.Dataset.Height);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    /// <exception cref="FormatException">It did not write that.</exception>
    public static CreatureTask Read(JsonElement json)
    {
        JsonElement export = json.GetProperty("export");
        JsonElement pictures = json.GetProperty("pictures");
        OptionsReading options = OptionsJson.Read(json.GetProperty("options").GetRawText());
        return new CreatureTask(
            options.Options ?? throw new FormatException("options: " + options.Problems[0]),
            new GltfOptions
            {
                Shading = Word<Shading>(export, "shading"),
                Lods = Word<LodChoice>(export, "levels"),
                Materials = Word<MaterialChoice>(export, "materials"),
                ClipPrecision = export.TryGetProperty("keys", out _) ? null : ClipPrecision.Default,
                RootMotion = export.TryGetProperty("rootMotion", out _) ? Word<RootMotionChoice>(export, "rootMotion") : RootMotionChoice.InPlace,
                Engine = export.TryGetProperty("engine", out _) ? Word<TargetEngine>(export, "engine") : TargetEngine.Generic,
                TextureSize = export.GetProperty("textureSize").GetInt32(),
            },
            ClipChoice.Read(export.GetProperty("clips").GetString()!, expected => new FormatException("clips: expected " + expected)),
            new PictureOrder(
                pictures.GetProperty("views").EnumerateArray().Select(word => Views.TryParse(word.GetString()!, out View view) ? view : throw new FormatException("views: " + word)).ToArray(),
                pictures.GetProperty("width").GetInt32(),
                pictures.GetProperty("height").GetInt32(),
                Word<BackdropKind>(pictures, "backdrop")),
            new DatasetOrder(json.GetProperty("dataset").GetProperty("views").GetInt32(), json.GetProperty("dataset").GetProperty("width").GetInt32(), json.GetProperty("dataset").GetProperty("height").GetInt32()));
    }

    private static T Word<T>(JsonElement json, string name)
        where T : struct, Enum
    {
        string word = json.GetProperty(name).GetString()!;
        return WordList<T>.Instance.TryFind(word, out T value) ? value : throw new FormatException($"{name}: '{word}'; expected {WordList<T>.Instance}");
    }
}
