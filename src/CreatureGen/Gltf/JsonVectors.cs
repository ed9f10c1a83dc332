using System.Numerics;
using CreatureGen.Json;

namespace CreatureGen.Gltf;

/// <summary>Vectors as arrays of numbers.</summary>
internal static class JsonVectors
{
    /// <summary>Writes x, y and z.</summary>
    public static JsonWriter Vector(this JsonWriter json, Vector3 v) =>
        json.BeginArray().Number(v.X).Number(v.Y).Number(v.Z).EndArray();

    /// <summary>Writes x, y, z and w.</summary>
    public static JsonWriter Vector(this JsonWriter json, Quaternion q) =>
        json.BeginArray().Number(q.X).Number(q.Y).Number(q.Z).Number(q.W).EndArray();
}
