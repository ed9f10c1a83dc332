namespace CreatureGen.Geometry;

/// <summary>How a part of the mesh is drawn.</summary>
public enum MaterialKind
{
    /// <summary>Opaque skin and all that is solid.</summary>
    Skin,

    /// <summary>Thin, double-sided membrane.</summary>
    Membrane,
}
