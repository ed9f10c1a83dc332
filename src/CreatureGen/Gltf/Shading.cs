namespace CreatureGen.Gltf;

/// <summary>How light falls on the triangles of a written creature.</summary>
public enum Shading
{
    /// <summary>Rounded: the creature's own vertices with their smooth normals.</summary>
    Smooth,

    /// <summary>Faceted: every triangle has three vertices of its own with the normal of its plane.</summary>
    Flat,
}
