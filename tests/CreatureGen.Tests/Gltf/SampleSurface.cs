using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Species;

namespace CreatureGen.Tests.Gltf;

/// <summary>Builds the mesh of a <see cref="SampleCreature"/>: a closed spindle along z with a texture seam, and closed fins on its back.</summary>
internal sealed class SampleSurface
{
    private readonly SampleShape shape;
    private readonly float length;
    private readonly float radius;
    private readonly float height;
    private readonly List<Vector3> positions = new();
    private readonly List<Vector2> texcoords = new();
    private readonly List<int> triangles = new();

    public SampleSurface(SampleShape shape, float length, float radius, float height)
    {
        this.shape = shape;
        this.length = length;
        this.radius = radius;
        this.height = height;
    }

    public CreatureMesh Build(Skeleton skeleton, IReadOnlyList<int> bones)
    {
        AddBody();
        int skin = triangles.Count;
        for (int fin = 0; fin < shape.Fins; fin++)
        {
            AddFin(fin);
        }

        var parts = new List<MeshPart> { new(MaterialKind.Skin, 0, skin) };
        if (triangles.Count > skin)
        {
            parts.Add(new MeshPart(MaterialKind.Membrane, skin, triangles.Count - skin));
        }

        var colours = new Vector3[positions.Count];
        var weights = new SkinWeights[positions.Count];
        for (int i = 0; i < positions.Count; i++)
        {
            float along = (positions[i].Z / length) + 0.5f;
            colours[i] = new Vector3(Math.Clamp(along, 0f, 1f), 0.25f + (0.001f * (shape.Number % 100)), i % 2);
            weights[i] = Weights(positions[i], skeleton, bones);
        }

        return new CreatureMesh(positions.ToArray(), Normals(), texcoords.ToArray(), colours, weights, triangles.ToArray(), parts);
    }

    private void AddBody()
    {
        for (int ring = 0; ring < shape.Rings; ring++)
        {
            double t = (ring + 1.0) / (shape.Rings + 1.0);
            double r = radius * Math.Sqrt(4.0 * t * (1.0 - t));
            for (int segment = 0; segment <= shape.Segments; segment++)
            {
                double angle = Math.Tau * (segment % shape.Segments) / shape.Segments;
                AddVertex(new Vector3((float)(r * Math.Sin(angle)), (float)(height + (r * Math.Cos(angle))), (float)(length * (0.5 - t))), (double)segment / shape.Segments, t);
            }
        }

        int nose = AddVertex(new Vector3(0f, height, 0.5f * length), 0.5, 0.0);
        int tail = AddVertex(new Vector3(0f, height, -0.5f * length), 0.5, 1.0);
        int stride = shape.Segments + 1;
        for (int segment = 0; segment < shape.Segments; segment++)
        {
            AddTriangle(nose, segment + 1, segment);
            for (int ring = 0; ring + 1 < shape.Rings; ring++)
            {
                int a = (ring * stride) + segment;
                AddTriangle(a, a + 1, a + stride);
                AddTriangle(a + 1, a + 1 + stride, a + stride);
            }

            int last = ((shape.Rings - 1) * stride) + segment;
            AddTriangle(tail, last, last + 1);
        }
    }

    private void AddFin(int fin)
    {
        float z = length * ((0.2f * fin) - 0.1f);
        float bottom = height + (1.05f * radius);
        int first = positions.Count;
        for (int corner = 0; corner < 8; corner++)
        {
            float x = (corner & 1) == 0 ? -0.005f : 0.005f;
            float y = (corner & 2) == 0 ? bottom : bottom + (0.5f * radius);
            AddVertex(new Vector3(x, y, (corner & 4) == 0 ? z : z + (0.1f * length)), (corner & 2) * 0.5, (corner & 4) * 0.25);
        }

        foreach (int corner in new[] { 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5 })
        {
            triangles.Add(first + corner);
        }
    }

    private int AddVertex(Vector3 position, double u, double v)
    {
        positions.Add(position);
        texcoords.Add(new Vector2((float)u, (float)v));
        return positions.Count - 1;
    }

    private void AddTriangle(int a, int b, int c)
    {
        triangles.Add(a);
        triangles.Add(b);
        triangles.Add(c);
    }

    private Vector3[] Normals()
    {
        var sums = new Dictionary<Vector3, Vector3>();
        for (int i = 0; i < triangles.Count; i += 3)
        {
            Vector3 a = positions[triangles[i]];
            Vector3 b = positions[triangles[i + 1]];
            Vector3 c = positions[triangles[i + 2]];
            Vector3 area = Vector3.Cross(b - a, c - a);
            foreach (Vector3 corner in new[] { a, b, c })
            {
                sums[corner] = sums.GetValueOrDefault(corner) + area;
            }
        }

        return positions.ConvertAll(p => Vector3.Normalize(sums[p])).ToArray();
    }

    /// <summary>Weights of the nearest one to four bones, by the inverse of their squared distance.</summary>
    private static SkinWeights Weights(Vector3 position, Skeleton skeleton, IReadOnlyList<int> bones)
    {
        var near = new List<(double Weight, int Joint)>();
        foreach (int bone in bones)
        {
            double distance = (skeleton.Joints[bone].ModelPosition - position).LengthSquared();
            near.Add((1.0 / (distance + 1e-3), bone));
        }

        near.Sort((a, b) => a.Weight != b.Weight ? b.Weight.CompareTo(a.Weight) : a.Joint.CompareTo(b.Joint));
        near.RemoveAll(n => n.Weight < 0.05 * near[0].Weight);
        int count = Math.Min(4, near.Count);
        double sum = 0;
        for (int i = 0; i < count; i++)
        {
            sum += near[i].Weight;
        }

        int Joint(int slot) => slot < count ? near[slot].Joint : 0;
        float Weight(int slot) => slot < count ? (float)(near[slot].Weight / sum) : 0f;
        return new SkinWeights(Joint(0), Joint(1), Joint(2), Joint(3), new Vector4(Weight(0), Weight(1), Weight(2), Weight(3)));
    }
}
