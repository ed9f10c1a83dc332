using System;
using System.Collections.Generic;

namespace CreatureGen.Creatures;

/// <summary>
/// The levels of detail of a creature, finest first: 100, 50, 25 and 10 % of its triangles over one set of vertices, with one skeleton and one set of weights.
/// </summary>
/// <remarks>
/// Level 0 is the mesh itself. Each level is a coarsening of the one before it, closed wherever the mesh is closed, mirror symmetric when the mesh is, and nowhere crosses itself where the mesh does not.
/// The same mesh always gives the same levels. Immutable, and safe to share between threads.
/// </remarks>
public sealed class CreatureLods
{
    private static readonly double[] fractions = { 1, 0.5, 0.25, 0.1 };

    private readonly CreatureLod[] levels;

    private CreatureLods(CreatureLod[] levels) => this.levels = levels;

    /// <summary>Part of the triangles that each level keeps, finest first: 1, 0.5, 0.25, 0.1.</summary>
    public static IReadOnlyList<double> Fractions => fractions;

    /// <summary>Number of levels: 4.</summary>
    public int Count => levels.Length;

    /// <summary>A level; 0 is the finest.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such level.</exception>
    public CreatureLod this[int level] => (uint)level < (uint)levels.Length
        ? levels[level]
        : throw new ArgumentOutOfRangeException(nameof(level), FormattableString.Invariant($"level {level}; expected 0..{levels.Length - 1}"));

    /// <summary>The mesh itself when it has no more triangles than a budget, or else one that does, with the vertices that it still uses.</summary>
    /// <remarks>A closed surface cannot be made of any number of triangles: what is left when nothing can go without damage is returned, whatever the budget.</remarks>
    internal static CreatureMesh Within(int budget, CreatureMesh mesh)
    {
        if (mesh.Triangles.Length <= 3 * (long)budget)
        {
            return mesh;
        }

        using var reduction = new MeshReduction(mesh);
        reduction.ReduceTo(budget);
        return reduction.ToLevel().ToMesh();
    }

    /// <summary>Makes the levels of a mesh. Takes some milliseconds; <see cref="CreatureMesh.Lods"/> does it once.</summary>
    public static CreatureLods Of(CreatureMesh mesh)
    {
        _ = mesh ?? throw new ArgumentNullException(nameof(mesh));
        using var reduction = new MeshReduction(mesh);
        int triangles = reduction.Triangles;
        var levels = new CreatureLod[fractions.Length];
        levels[0] = CreatureLod.Finest(mesh);
        for (int i = 1; i < levels.Length; i++)
        {
            reduction.ReduceTo((int)(triangles * fractions[i]));
            levels[i] = reduction.ToLevel();
        }

        return new CreatureLods(levels);
    }
}
