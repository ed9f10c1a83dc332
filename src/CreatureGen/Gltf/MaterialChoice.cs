namespace CreatureGen.Gltf;

/// <summary>How many materials a written creature has at most.</summary>
public enum MaterialChoice
{
    /// <summary><c>Skin</c>, opaque and solid, and where there are thin sheets <c>Membrane</c>, drawn on both sides. Each has triangles of its own at each level of detail.</summary>
    Two,

    /// <summary>
    /// One, <c>Creature</c>, drawn on both sides: all triangles of a level are one primitive, and so one draw call. The triangles, vertices and colours are the same.
    /// </summary>
    One,
}
