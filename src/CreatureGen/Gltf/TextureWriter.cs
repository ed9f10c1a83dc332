using CreatureGen.Json;

namespace CreatureGen.Gltf;

/// <summary>The JSON of textures: one sampler, and a texture and an image for each picture of the atlas.</summary>
internal static class TextureWriter
{
    private const int Linear = 9729;
    private const int LinearMipmapLinear = 9987;
    private const int ClampToEdge = 33071;

    /// <summary>Writes samplers, textures and images.</summary>
    public static void Write(JsonWriter json, BufferPlan plan)
    {
        json.Name("samplers").BeginArray().BeginObject();
        json.Name("magFilter").Number(Linear);
        json.Name("minFilter").Number(LinearMipmapLinear);
        json.Name("wrapS").Number(ClampToEdge);
        json.Name("wrapT").Number(ClampToEdge);
        json.EndObject().EndArray();
        json.Name("textures").BeginArray();
        for (int i = 0; i < plan.Blocks.Count; i++)
        {
            json.BeginObject().Name("sampler").Number(0).Name("source").Number(i).EndObject();
        }

        json.EndArray();
        json.Name("images").BeginArray();
        for (int i = 0; i < plan.Blocks.Count; i++)
        {
            json.BeginObject();
            json.Name("name").Text(TextureImages.Names[i]);
            json.Name("mimeType").Text("image/png");
            json.Name("bufferView").Number(plan.Accessors.Count + i);
            json.EndObject();
        }

        json.EndArray();
    }

    /// <summary>Refers to a texture from a material.</summary>
    public static void Refer(JsonWriter json, string name, int texture) =>
        json.Name(name).BeginObject().Name("index").Number(texture).EndObject();
}
