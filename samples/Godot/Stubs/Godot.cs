// The few types of Godot 4 that the add-on uses, as far as a test needs them: it compiles the add-on against them and lets it run.
using System;
using System.Collections.Generic;

namespace Godot
{
    public struct Vector2 { public float X, Y; public Vector2(float x, float y) { X = x; Y = y; } }

    public struct Vector3
    {
        public float X, Y, Z;
        public Vector3(float x, float y, float z) { X = x; Y = y; Z = z; }
        public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);
        public static Vector3 operator *(Vector3 a, float k) => new(a.X * k, a.Y * k, a.Z * k);
    }

    public struct Quaternion { public float X, Y, Z, W; public Quaternion(float x, float y, float z, float w) { X = x; Y = y; Z = z; W = w; } }

    public struct Color { public float R, G, B, A; public Color(float r, float g, float b, float a = 1f) { R = r; G = g; B = b; A = a; } }

    public struct Basis
    {
        public Vector3 X, Y, Z;
        private readonly Quaternion rotation;
        public Basis(Vector3 x, Vector3 y, Vector3 z) { X = x; Y = y; Z = z; rotation = new(0f, 0f, 0f, 1f); }
        public Basis(Quaternion q)
        {
            rotation = q;
            X = new(1f - (2f * ((q.Y * q.Y) + (q.Z * q.Z))), 2f * ((q.X * q.Y) + (q.W * q.Z)), 2f * ((q.X * q.Z) - (q.W * q.Y)));
            Y = new(2f * ((q.X * q.Y) - (q.W * q.Z)), 1f - (2f * ((q.X * q.X) + (q.Z * q.Z))), 2f * ((q.Y * q.Z) + (q.W * q.X)));
            Z = new(2f * ((q.X * q.Z) + (q.W * q.Y)), 2f * ((q.Y * q.Z) - (q.W * q.X)), 1f - (2f * ((q.X * q.X) + (q.Y * q.Y))));
        }

        public Quaternion GetRotationQuaternion() => rotation;
        public static Vector3 operator *(Basis b, Vector3 v) => (b.X * v.X) + (b.Y * v.Y) + (b.Z * v.Z);
    }

    public struct Transform3D
    {
        public Basis Basis;
        public Vector3 Origin;
        public Transform3D(Basis basis, Vector3 origin) { Basis = basis; Origin = origin; }
        public Transform3D(Vector3 x, Vector3 y, Vector3 z, Vector3 origin) : this(new Basis(x, y, z), origin) { }
        public static Vector3 operator *(Transform3D t, Vector3 v) => (t.Basis * v) + t.Origin;
        public static Transform3D operator *(Transform3D a, Transform3D b) => new(a.Basis * b.Basis.X, a.Basis * b.Basis.Y, a.Basis * b.Basis.Z, a * b.Origin);
    }

    public struct Variant
    {
        public object Value;
        public Vector3 AsVector3() => (Vector3)Value;
        public static implicit operator Variant(Vector3[] v) => new() { Value = v };
        public static implicit operator Variant(Vector2[] v) => new() { Value = v };
        public static implicit operator Variant(Color[] v) => new() { Value = v };
        public static implicit operator Variant(float[] v) => new() { Value = v };
        public static implicit operator Variant(int[] v) => new() { Value = v };
        public static implicit operator Variant(Vector3 v) => new() { Value = v };
    }

    [AttributeUsage(AttributeTargets.Property)] public sealed class ExportAttribute : Attribute { }

    public class GodotObject { }

    public class Resource : GodotObject { }

    public class NodePath { public Node To; }

    public class Node : GodotObject
    {
        public Node Parent;
        public void AddChild(Node child) => child.Parent = this;
        public NodePath GetPathTo(Node other) => new() { To = other };
        public virtual void _Ready() { }
        public virtual void _PhysicsProcess(double delta) { }
    }

    public class Node3D : Node
    {
        public Vector3 GlobalPosition { get; set; }
        public Basis GlobalBasis { get; set; } = new(new Quaternion(0f, 0f, 0f, 1f));
        public World3D GetWorld3D() => new();
    }

    public class World3D { public PhysicsDirectSpaceState3D DirectSpaceState { get; } = new(); }

    public class PhysicsRayQueryParameters3D
    {
        public Vector3 From, To;
        public static PhysicsRayQueryParameters3D Create(Vector3 from, Vector3 to, uint collisionMask) => new() { From = from, To = to };
    }

    public class PhysicsDirectSpaceState3D
    {
        // A level plane at y = 0.
        public Collections.Dictionary IntersectRay(PhysicsRayQueryParameters3D ray)
        {
            var met = new Collections.Dictionary();
            if (ray.From.Y >= 0f && ray.To.Y <= 0f && ray.From.Y > ray.To.Y)
            {
                met["position"] = ray.From + ((ray.To + (ray.From * -1f)) * (ray.From.Y / (ray.From.Y - ray.To.Y)));
                met["normal"] = new Vector3(0f, 1f, 0f);
            }

            return met;
        }
    }

    public class Skeleton3D : Node3D
    {
        public readonly List<string> Names = new();
        public readonly List<int> Parents = new();
        public readonly List<Transform3D> Rests = new();
        private readonly Dictionary<int, Quaternion> rotations = new();
        private readonly Dictionary<int, Vector3> positions = new();
        public int AddBone(string name) { Names.Add(name); Parents.Add(-1); Rests.Add(default); return Names.Count - 1; }
        public void SetBoneParent(int bone, int parent) => Parents[bone] = parent;
        public void SetBoneRest(int bone, Transform3D rest) => Rests[bone] = rest;
        public void SetBonePoseRotation(int bone, Quaternion rotation) => rotations[bone] = rotation;
        public void SetBonePosePosition(int bone, Vector3 position) => positions[bone] = position;
        public Transform3D GetBonePose(int bone) => new(new Basis(rotations[bone]), positions[bone]);
        public Transform3D GetBoneGlobalPose(int bone)
        {
            Transform3D own = GetBonePose(bone);
            return Parents[bone] < 0 ? own : GetBoneGlobalPose(Parents[bone]) * own;
        }
    }

    public class Skin : Resource { public readonly List<Transform3D> Binds = new(); public void AddBind(int bone, Transform3D pose) => Binds.Add(pose); }

    public abstract class Mesh : Resource
    {
        public enum PrimitiveType : long { Triangles = 3 }

        public enum ArrayType : long { Vertex = 0, Normal = 1, Tangent = 2, Color = 3, TexUV = 4, TexUV2 = 5, Bones = 10, Weights = 11, Index = 12, Max = 13 }
    }

    public class ArrayMesh : Mesh { public Collections.Array Arrays; public void AddSurfaceFromArrays(PrimitiveType primitive, Collections.Array arrays) => Arrays = arrays; }

    public class Material : Resource { }

    public class BaseMaterial3D : Material
    {
        public enum CullModeEnum : long { Back, Front, Disabled }

        public Texture2D AlbedoTexture { get; set; }
        public bool VertexColorUseAsAlbedo { get; set; }
        public float Roughness { get; set; }
        public CullModeEnum CullMode { get; set; }
    }

    public class StandardMaterial3D : BaseMaterial3D { }

    public class Texture2D : Resource { }

    public class ImageTexture : Texture2D { public static ImageTexture CreateFromImage(Image image) => new(); }

    public class Image : Resource
    {
        public enum Format : long { Rgb8 = 4 }

        public static Image CreateFromData(int width, int height, bool useMipmaps, Format format, byte[] data) => data.Length == 3 * width * height ? new Image() : throw new ArgumentException("data");
    }

    public class MeshInstance3D : Node3D
    {
        public Mesh Mesh { get; set; }
        public Skin Skin { get; set; }
        public NodePath Skeleton { get; set; }
        public Material MaterialOverride { get; set; }
    }
}

namespace Godot.Collections
{
    public class Array
    {
        private readonly List<Variant> items = new();
        public int Resize(int size) { while (items.Count < size) { items.Add(default); } return 0; }
        public Variant this[int index] { get => items[index]; set => items[index] = value; }
    }

    public class Dictionary
    {
        private readonly Dictionary<string, Variant> items = new();
        public int Count => items.Count;
        public Variant this[string key] { get => items[key]; set => items[key] = value; }
    }
}
