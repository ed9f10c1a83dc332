using System;
using System.Collections.Generic;
using CreatureGen.Creatures;
using CreatureGen.Geometry;

namespace CreatureGen.Gltf;

/// <summary>The levels of detail that a file holds, finest first, as one mesh: its parts are those of one level after the other.</summary>
internal sealed class LodStack
{
    private readonly int[] partCounts;

    private LodStack(CreatureMesh mesh, int[] partCounts)
    {
        Mesh = mesh;
        this.partCounts = partCounts;
    }

    /// <summary>The vertices that all levels share, and the triangles of all levels.</summary>
    public CreatureMesh Mesh { get; }

    /// <summary>Number of levels.</summary>
    public int Count => partCounts.Length;

    /// <summary>Collects the chosen levels of a mesh.</summary>
    /// <exception cref="ArgumentException">The choice, the materials or the shading is none of the known ones.</exception>
    public static LodStack Of(CreatureMesh mesh, GltfOptions options)
    {
        LodStack stack = options.Lods switch
        {
            LodChoice.Finest => new LodStack(mesh, new[] { mesh.Parts.Count }),
            LodChoice.Half => Single(mesh.Lods[1]),
            LodChoice.Quarter => Single(mesh.Lods[2]),
            LodChoice.Tenth => Single(mesh.Lods[3]),
            LodChoice.All => All(mesh),
            _ => throw new ArgumentException(FormattableString.Invariant($"levels {(int)options.Lods}; expected Finest, Half, Quarter, Tenth or All"), nameof(options)),
        };
        stack = options.Materials switch
        {
            MaterialChoice.Two => stack,
            MaterialChoice.One => stack.InOnePart(),
            _ => throw new ArgumentException(FormattableString.Invariant($"materials {(int)options.Materials}; expected Two or One"), nameof(options)),
        };
        return options.Shading switch
        {
            Shading.Smooth => stack,
            Shading.Flat => new LodStack(FlatShading.Split(stack.Mesh), stack.partCounts),
            _ => throw new ArgumentException(FormattableString.Invariant($"shading {(int)options.Shading}; expected Smooth or Flat"), nameof(options)),
        };
    }

    /// <summary>The first of a level's parts, and their number.</summary>
    public (int First, int Count) PartsOf(int level)
    {
        int first = 0;
        for (int i = 0; i < level; i++)
        {
            first += partCounts[i];
        }

        return (first, partCounts[level]);
    }

    /// <summary>The same levels over other vertices: the parts of the mesh are the same.</summary>
    public LodStack Over(CreatureMesh mesh) => new(mesh, partCounts);

    private static LodStack Single(CreatureLod level)
    {
        CreatureMesh mesh = level.ToMesh();
        return new LodStack(mesh, new[] { mesh.Parts.Count });
    }

    private static LodStack All(CreatureMesh mesh)
    {
        CreatureLods levels = mesh.Lods;
        var triangles = new List<int>();
        var parts = new List<MeshPart>();
        int[] counts = new int[levels.Count];
        for (int i = 0; i < counts.Length; i++)
        {
            counts[i] = levels[i].Parts.Count;
            foreach (MeshPart part in levels[i].Parts)
            {
                parts.Add(part with { FirstIndex = triangles.Count + part.FirstIndex });
            }

            triangles.AddRange(levels[i].Triangles.ToArray());
        }

        return new LodStack(mesh.With(triangles.ToArray(), parts), counts);
    }

    /// <summary>The parts of each level, which follow one another, as one that is drawn on both sides.</summary>
    private LodStack InOnePart()
    {
        var parts = new MeshPart[Count];
        int[] counts = new int[Count];
        int next = 0;
        for (int level = 0; level < Count; level++)
        {
            (int first, int count) = PartsOf(level);
            int start = next;
            for (int i = first; i < first + count; i++)
            {
                next += Mesh.Parts[i].IndexCount;
            }

            parts[level] = new MeshPart(MaterialKind.Membrane, start, next - start);
            counts[level] = 1;
        }

        return new LodStack(Mesh.With(Mesh.Triangles.ToArray(), parts), counts);
    }
}
