// The few types of UnityEngine that the package uses, as far as a test needs them: it compiles the package against them and lets it run.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public struct Vector2 { public float x, y; public Vector2(float x, float y) { this.x = x; this.y = y; } }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator *(Vector3 a, float k) => new Vector3(a.x * k, a.y * k, a.z * k);
    }

    public struct Vector4 { public float x, y, z, w; public Vector4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; } }

    public struct Quaternion
    {
        public float x, y, z, w;
        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public static Quaternion identity => new Quaternion(0f, 0f, 0f, 1f);

        // As Unity's: the formula of Hamilton knows no hand.
        public static Quaternion operator *(Quaternion a, Quaternion b) => new Quaternion(
            (a.w * b.x) + (a.x * b.w) + (a.y * b.z) - (a.z * b.y), (a.w * b.y) - (a.x * b.z) + (a.y * b.w) + (a.z * b.x),
            (a.w * b.z) + (a.x * b.y) - (a.y * b.x) + (a.z * b.w), (a.w * b.w) - (a.x * b.x) - (a.y * b.y) - (a.z * b.z));

        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            Quaternion r = q * new Quaternion(v.x, v.y, v.z, 0f) * new Quaternion(-q.x, -q.y, -q.z, q.w);
            return new Vector3(r.x, r.y, r.z);
        }
    }

    public struct Color { public float r, g, b, a; public Color(float r, float g, float b, float a) { this.r = r; this.g = g; this.b = b; this.a = a; } }

    public struct Matrix4x4
    {
        public Vector4 c0, c1, c2, c3;
        public void SetColumn(int index, Vector4 column) { if (index == 0) c0 = column; else if (index == 1) c1 = column; else if (index == 2) c2 = column; else c3 = column; }
        public Vector3 MultiplyPoint3x4(Vector3 p) => new Vector3((c0.x * p.x) + (c1.x * p.y) + (c2.x * p.z) + c3.x, (c0.y * p.x) + (c1.y * p.y) + (c2.y * p.z) + c3.y, (c0.z * p.x) + (c1.z * p.y) + (c2.z * p.z) + c3.z);
    }

    public struct BoneWeight { public int boneIndex0, boneIndex1, boneIndex2, boneIndex3; public float weight0, weight1, weight2, weight3; }

    public struct LayerMask { public int value; public static implicit operator int(LayerMask m) => m.value; public static implicit operator LayerMask(int v) => new LayerMask { value = v }; }

    public struct RaycastHit { public Vector3 point { get; set; } public Vector3 normal { get; set; } }

    public enum QueryTriggerInteraction { UseGlobal, Ignore, Collide }

    public static class Physics
    {
        // A level plane at y = 0.
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hit, float distance, int layers, QueryTriggerInteraction triggers)
        {
            float t = direction.y < 0f ? origin.y / -direction.y : -1f;
            hit = new RaycastHit { point = origin + (direction * t), normal = new Vector3(0f, 1f, 0f) };
            return t >= 0f && t <= distance;
        }
    }

    public static class Time { public static float deltaTime => 1f / 60f; public static float time { get; set; } }

    public static class Mathf { public static float Sin(float x) => (float)Math.Sin(x); public static float Cos(float x) => (float)Math.Cos(x); }

    public static class Debug { public static void LogWarning(object message) { } }

    public static class PlayerPrefs
    {
        private static readonly Dictionary<string, string> all = new Dictionary<string, string>();
        public static void SetString(string key, string value) => all[key] = value;
        public static string GetString(string key, string otherwise) => all.TryGetValue(key, out string value) ? value : otherwise;
    }

    public class Object
    {
        public string name { get; set; }
        public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Component, new()
        {
            var copy = new GameObject("copy").AddComponent<T>();
            copy.transform.SetPositionAndRotation(position, rotation);
            return copy;
        }
    }

    public sealed class GameObject : Object
    {
        public GameObject(string name) { this.name = name; transform = new Transform { gameObject = this }; }
        public Transform transform { get; }
        public T AddComponent<T>() where T : Component, new() => new T { gameObject = this };
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }
        public Transform transform => gameObject.transform;
    }

    public class MonoBehaviour : Component { }

    public sealed class SerializeField : Attribute { }

    public sealed class Transform : Component
    {
        public Transform parent { get; private set; }
        public Vector3 localPosition { get; set; }
        public Quaternion localRotation { get; set; } = Quaternion.identity;
        public void SetParent(Transform to, bool worldPositionStays) => parent = to;
        public void SetPositionAndRotation(Vector3 p, Quaternion q) { localPosition = p; localRotation = q; }
        public Quaternion rotation => parent == null ? localRotation : parent.rotation * localRotation;
        public Vector3 position => parent == null ? localPosition : parent.position + (parent.rotation * localPosition);
    }

    public sealed class Mesh : Object
    {
        public Rendering.IndexFormat indexFormat { get; set; }
        public Vector3[] vertices { get; set; }
        public Vector3[] normals { get; set; }
        public Vector4[] tangents { get; set; }
        public Vector2[] uv { get; set; }
        public Color[] colors { get; set; }
        public BoneWeight[] boneWeights { get; set; }
        public Matrix4x4[] bindposes { get; set; }
        public int subMeshCount { get; set; }
        public Dictionary<int, int[]> Triangles { get; } = new Dictionary<int, int[]>();
        public void SetTriangles(int[] triangles, int submesh) => Triangles[submesh] = triangles;
        public void RecalculateBounds() { }
    }

    public class Texture : Object { }

    public enum TextureFormat { RGB24 = 3 }

    public sealed class Texture2D : Texture
    {
        public Texture2D(int width, int height, TextureFormat format, bool mipChain) { }
        public byte[] Data { get; private set; }
        public void LoadRawTextureData(byte[] data) => Data = data;
        public void Apply() { }
    }

    public sealed class Material : Object { public Material(Material source) { } public Texture mainTexture { get; set; } }

    public sealed class SkinnedMeshRenderer : Component
    {
        public Mesh sharedMesh { get; set; }
        public Transform[] bones { get; set; }
        public Transform rootBone { get; set; }
        public Material[] sharedMaterials { get; set; }
    }
}

namespace UnityEngine.Rendering
{
    public enum IndexFormat { UInt16, UInt32 }
}
