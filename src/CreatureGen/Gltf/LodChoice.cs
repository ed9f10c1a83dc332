using CreatureGen.Creatures;

namespace CreatureGen.Gltf;

/// <summary>Which levels of detail of a creature a file holds.</summary>
public enum LodChoice
{
    /// <summary>Level 0 of <see cref="CreatureLods"/>: the creature's mesh as it is.</summary>
    Finest,

    /// <summary>Level 1 alone.</summary>
    Half,

    /// <summary>Level 2 alone.</summary>
    Quarter,

    /// <summary>Level 3 alone.</summary>
    Tenth,

    /// <summary>
    /// All levels over one set of vertices and one skin, tied together with the extension <c>MSFT_lod</c>; importers that do not know it show level 0.
    /// <c>MSFT_screencoverage</c> in the extras of the mesh's node says how much of the screen's area each level is made for.
    /// </summary>
    All,
}
