namespace CreatureGen.Creatures;

/// <summary>A stage of the way from a blueprint to a creature.</summary>
public enum AssemblyStage
{
    /// <summary>Body and limbs as one welded surface.</summary>
    Surface,

    /// <summary>Eyes, claws and other pieces that sit on it.</summary>
    Features,

    /// <summary>Skeleton, limb chains, attachment points.</summary>
    Rig,

    /// <summary>Joint influences of each vertex.</summary>
    Skin,

    /// <summary>Normals, colours and texture coordinates.</summary>
    Appearance,

    /// <summary>Vertex buffers, colliders and mass.</summary>
    Finish,
}

/// <summary>Hears when a stage of an assembly is done: the library itself has no clock.</summary>
public interface IAssemblyObserver
{
    /// <summary>A stage is done.</summary>
    void StageFinished(AssemblyStage stage);
}
