using System;
using System.Linq;
using System.Numerics;
using System.Text.Json;

namespace CreatureGen.Tests.Gltf.Models;

/// <summary>The specification of glTF read aloud, with matrices, for files made by <see cref="HumanoidFile"/>: where every vertex is at a time of its first animation.</summary>
internal sealed class NaiveGltf(byte[] file)
{
    private readonly JsonElement json = JsonDocument.Parse(file.AsMemory(20, BitConverter.ToInt32(file, 12))).RootElement;
    private readonly int start = 28 + BitConverter.ToInt32(file, 12);

    public Vector3[] Vertices(double time)
    {
        JsonElement skin = json.GetProperty("skins")[0];
        Matrix4x4[] world = World(time);
        int[] joints = skin.GetProperty("joints").EnumerateArray().Select(j => j.GetInt32()).ToArray();
        double[] inverses = Numbers(skin.GetProperty("inverseBindMatrices").GetInt32());
        Matrix4x4[] carry = joints.Select((node, i) => Matrix(inverses.AsSpan(16 * i, 16)) * world[node]).ToArray();
        JsonElement attributes = json.GetProperty("meshes")[0].GetProperty("primitives")[0].GetProperty("attributes");
        double[] points = Numbers(attributes.GetProperty("POSITION").GetInt32());
        double[] bones = Numbers(attributes.GetProperty("JOINTS_0").GetInt32());
        double[] fractions = Numbers(attributes.GetProperty("WEIGHTS_0").GetInt32());
        var vertices = new Vector3[points.Length / 3];
        for (int i = 0; i < vertices.Length; i++)
        {
            var p = new Vector3((float)points[3 * i], (float)points[(3 * i) + 1], (float)points[(3 * i) + 2]);
            for (int k = 4 * i; k < (4 * i) + 4; k++)
            {
                vertices[i] += Vector3.Transform(p, carry[(int)bones[k]]) * (float)(fractions[k] / 255);
            }
        }

        return vertices;
    }

    public Matrix4x4[] World(double time)
    {
        JsonElement[] nodes = json.GetProperty("nodes").EnumerateArray().ToArray();
        var local = nodes.Select((n, i) => Local(n, i, time)).ToArray();
        var world = new Matrix4x4[nodes.Length];
        foreach (JsonElement root in json.GetProperty("scenes")[0].GetProperty("nodes").EnumerateArray())
        {
            Place(root.GetInt32(), Matrix4x4.Identity);
        }

        return world;

        void Place(int node, Matrix4x4 outer)
        {
            world[node] = local[node] * outer;
            if (nodes[node].TryGetProperty("children", out JsonElement children))
            {
                foreach (JsonElement child in children.EnumerateArray())
                {
                    Place(child.GetInt32(), world[node]);
                }
            }
        }
    }

    private Matrix4x4 Local(JsonElement node, int index, double time)
    {
        if (node.TryGetProperty("matrix", out JsonElement matrix) && Animated(index, "translation", time) is not { } moved)
        {
            return Matrix(matrix.EnumerateArray().Select(n => n.GetDouble()).ToArray());
        }
        else if (node.TryGetProperty("matrix", out matrix))
        {
            Matrix4x4 m = Matrix(matrix.EnumerateArray().Select(n => n.GetDouble()).ToArray());
            m.Translation = new Vector3((float)Animated(index, "translation", time)![0], (float)Animated(index, "translation", time)![1], (float)Animated(index, "translation", time)![2]);
            return m;
        }

        double[] t = Animated(index, "translation", time) ?? Given("translation", [0, 0, 0]);
        double[] r = Animated(index, "rotation", time) ?? Given("rotation", [0, 0, 0, 1]);
        double[] s = Given("scale", [1, 1, 1]);
        return Matrix4x4.CreateScale((float)s[0], (float)s[1], (float)s[2])
            * Matrix4x4.CreateFromQuaternion(new Quaternion((float)r[0], (float)r[1], (float)r[2], (float)r[3]))
            * Matrix4x4.CreateTranslation((float)t[0], (float)t[1], (float)t[2]);

        double[] Given(string name, double[] otherwise) => node.TryGetProperty(name, out JsonElement e) ? e.EnumerateArray().Select(n => n.GetDouble()).ToArray() : otherwise;
    }

    private double[]? Animated(int node, string path, double time)
    {
        if (time < 0)
        {
            return null;
        }

        JsonElement animation = json.GetProperty("animations")[0];
        foreach (JsonElement channel in animation.GetProperty("channels").EnumerateArray())
        {
            JsonElement target = channel.GetProperty("target");
            if (target.GetProperty("node").GetInt32() == node && target.GetProperty("path").GetString() == path)
            {
                JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
                return Value(Numbers(sampler.GetProperty("input").GetInt32()), Numbers(sampler.GetProperty("output").GetInt32()), sampler.GetProperty("interpolation").GetString()!, path == "rotation", time);
            }
        }

        return null;
    }

    private static double[] Value(double[] times, double[] values, string interpolation, bool turns, double time)
    {
        int width = turns ? 4 : 3;
        bool cubic = interpolation == "CUBICSPLINE";
        double[] At(int key, int part) => values[(((cubic ? (3 * key) + part : key) * width))..][..width];
        int last = times.Length - 1;
        if (time <= times[0] || time >= times[last])
        {
            return At(time <= times[0] ? 0 : last, 1);
        }

        int k = Array.FindLastIndex(times, t => t <= time);
        double td = times[k + 1] - times[k];
        double u = (time - times[k]) / td;
        double[] a = At(k, 1);
        double[] b = At(k + 1, 1);
        if (interpolation == "STEP")
        {
            return a;
        }

        if (cubic)
        {
            double[] p = a.Select((_, i) => (((2 * u * u * u) - (3 * u * u) + 1) * a[i]) + (td * ((u * u * u) - (2 * u * u) + u) * At(k, 2)[i]) + (((-2 * u * u * u) + (3 * u * u)) * b[i]) + (td * ((u * u * u) - (u * u)) * At(k + 1, 0)[i])).ToArray();
            double length = turns ? Math.Sqrt(p.Sum(x => x * x)) : 1;
            return p.Select(x => x / length).ToArray();
        }

        if (turns)
        {
            // By the chord, since the arc cosine of what is rounded to floats is wrong by up to 5e-4 radians near 1.
            double sign = a.Zip(b, (x, y) => x * y).Sum() < 0 ? -1 : 1;
            double lengthA = Math.Sqrt(a.Sum(x => x * x));
            double lengthB = sign * Math.Sqrt(b.Sum(x => x * x));
            double chord = Math.Sqrt(a.Zip(b, (x, y) => (x / lengthA) - (y / lengthB)).Sum(x => x * x));
            double angle = 2 * Math.Asin(Math.Min(chord / 2, 1));
            double sine = Math.Sin(angle);
            return sine < 1e-9 ? a : a.Zip(b, (x, y) => ((x / lengthA * Math.Sin((1 - u) * angle)) + (y / lengthB * Math.Sin(u * angle))) / sine).ToArray();
        }

        return a.Zip(b, (x, y) => x + ((y - x) * u)).ToArray();
    }

    private static Matrix4x4 Matrix(ReadOnlySpan<double> m) => new(
        (float)m[0], (float)m[1], (float)m[2], (float)m[3], (float)m[4], (float)m[5], (float)m[6], (float)m[7], (float)m[8], (float)m[9], (float)m[10], (float)m[11], (float)m[12], (float)m[13], (float)m[14], (float)m[15]);

    private double[] Numbers(int index)
    {
        JsonElement accessor = json.GetProperty("accessors")[index];
        int offset = start + json.GetProperty("bufferViews")[accessor.GetProperty("bufferView").GetInt32()].GetProperty("byteOffset").GetInt32();
        int width = accessor.GetProperty("type").GetString() switch { "SCALAR" => 1, "VEC3" => 3, "VEC4" => 4, _ => 16 };
        bool bytes = accessor.GetProperty("componentType").GetInt32() == 5121;
        return Enumerable.Range(0, accessor.GetProperty("count").GetInt32() * width).Select(i => bytes ? file[offset + i] : (double)BitConverter.ToSingle(file, offset + (4 * i))).ToArray();
    }
}
