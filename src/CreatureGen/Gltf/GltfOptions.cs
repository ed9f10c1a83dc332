using System;
using System.Collections.Generic;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf;

/// <summary>How a creature is written as glTF. The same creature and options always give the same bytes.</summary>
public sealed record GltfOptions
{
    /// <summary>Smooth shading, no provenance.</summary>
    public static GltfOptions Default { get; } = new();

    /// <summary>How light falls on the triangles.</summary>
    public Shading Shading { get; init; } = Shading.Smooth;

    /// <summary>Which levels of detail are written. Default: <see cref="LodChoice.Finest"/>.</summary>
    public LodChoice Lods { get; init; } = LodChoice.Finest;

    /// <summary>How many materials there are at most. Default: <see cref="MaterialChoice.Two"/>.</summary>
    public MaterialChoice Materials { get; init; } = MaterialChoice.Two;

    /// <summary>
    /// Texels along a side of the texture atlas in the file (base colour, normals, roughness as PNG), a power of two 256..4096. Default: 0, no atlas: all colour is in the vertices.
    /// With an atlas, vertices of the skin are white and those of eyes, claws and teeth keep their colour.
    /// </summary>
    public int TextureSize { get; init; }

    /// <summary>An atlas painted before, of the very creature that is written, to share the work with a picture; its size counts then. Default: null, one of <see cref="TextureSize"/> is painted.</summary>
    public CreatureTextures? Textures { get; init; }

    /// <summary>Motion in the file, one animation for each clip. Default: none.</summary>
    public IReadOnlyList<Clip> Clips { get; init; } = Array.Empty<Clip>();

    /// <summary>How near clips of fewer keys are to what was recorded; null keeps the keys of every frame. Default: <see cref="ClipPrecision.Default"/>.</summary>
    public ClipPrecision? ClipPrecision { get; init; } = Motion.Toolkit.ClipPrecision.Default;

    /// <summary>Who moves the creature while a clip plays. Default: <see cref="RootMotionChoice.InPlace"/>.</summary>
    public RootMotionChoice RootMotion { get; init; }

    /// <summary>For whose importer names and extras of clips are. Default: <see cref="TargetEngine.Generic"/>.</summary>
    public TargetEngine Engine { get; init; }

    /// <summary>
    /// The options that the creature was generated with, as text, kept in the file as <c>asset.extras.creaturegen.options</c>; null leaves it out.
    /// The writer does not read it: it should depend on nothing but the options, or equal creatures get different files.
    /// </summary>
    public string? Provenance { get; init; }
}
