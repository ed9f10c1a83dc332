using CreatureGen.Creatures;
using CreatureGen.Rigging;

namespace CreatureGen.Engines;

/// <summary>What engines take of a creature: <c>creature.Mesh.For(EngineAxes.Unity)</c>.</summary>
public static class EngineExtensions
{
    /// <summary>The mesh as an engine takes it.</summary>
    /// <exception cref="System.ArgumentNullException">An argument is null.</exception>
    public static EngineMesh For(this CreatureMesh mesh, EngineAxes axes) => new(mesh, axes);

    /// <summary>The skeleton as an engine takes it.</summary>
    /// <exception cref="System.ArgumentNullException">An argument is null.</exception>
    public static EngineSkeleton For(this Skeleton skeleton, EngineAxes axes) => new(skeleton, axes);
}
