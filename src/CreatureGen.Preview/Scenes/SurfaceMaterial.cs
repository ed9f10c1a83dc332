namespace CreatureGen.Preview.Scenes;

/// <summary>Which sides of a triangle are drawn.</summary>
public enum Facing
{
    /// <summary>Only the side on which its corners run counter-clockwise.</summary>
    Front,

    /// <summary>Both; normals are turned to the viewer.</summary>
    Both,
}

/// <summary>How a part of a <see cref="RenderMesh"/> takes light.</summary>
/// <param name="Facing">Which sides are drawn.</param>
/// <param name="Gloss">0 is dull like felt, 1 wet like an eye; of meshes with their own gloss per vertex the larger counts.</param>
/// <param name="Translucency">Part of the light from behind that shines through, 0..1.</param>
public sealed record SurfaceMaterial(Facing Facing, float Gloss, float Translucency)
{
    /// <summary>Skin and all that is solid.</summary>
    public static SurfaceMaterial Skin { get; } = new(Facing.Front, 0.28f, 0f);

    /// <summary>Thin membranes and feathers, seen from both sides.</summary>
    public static SurfaceMaterial Membrane { get; } = new(Facing.Both, 0.3f, 0.55f);
}

/// <summary>Triangles of one material.</summary>
/// <param name="Material">How they take light.</param>
/// <param name="FirstIndex">First of their indices in <see cref="RenderMesh.Triangles"/>.</param>
/// <param name="IndexCount">Number of their indices.</param>
public sealed record RenderPart(SurfaceMaterial Material, int FirstIndex, int IndexCount);
