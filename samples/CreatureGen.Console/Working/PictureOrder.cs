using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Working;

/// <summary>Which pictures of a creature are wanted.</summary>
/// <param name="Views">From where, each once; none for no picture.</param>
/// <param name="Width">Pixels in a row.</param>
/// <param name="Height">Rows.</param>
/// <param name="Backdrop">What is behind the creature; where nothing is, it throws no shadow either.</param>
internal sealed record PictureOrder(IReadOnlyList<View> Views, int Width, int Height, BackdropKind Backdrop)
{
    /// <summary>One, from three quarters.</summary>
    public static PictureOrder Portrait { get; } = new([View.ThreeQuarter], 1024, 768, BackdropKind.Studio);

    /// <summary>None.</summary>
    public static PictureOrder None { get; } = Portrait with { Views = [] };

    /// <summary>The pictures of what is written, as files: <c>png</c>, or of several one for each view, such as <c>side.png</c>.</summary>
    /// <exception cref="OperationCanceledException">It was stopped between two pictures.</exception>
    public IEnumerable<(string Form, byte[] Content)> Take(Creature creature, GltfOptions export, int threads, CancellationToken cancellation)
    {
        foreach (View view in Views)
        {
            cancellation.ThrowIfCancellationRequested();
            yield return (Form(view), Take(creature, view, export, threads));
        }
    }

    /// <summary>The forms of the files that <see cref="Take(Creature, GltfOptions, int, CancellationToken)"/> gives.</summary>
    public IEnumerable<string> Forms => Views.Select(Form);

    private string Form(View view) => Views.Count == 1 ? "png" : Preview.Scenes.Views.Word(view) + ".png";

    private byte[] Take(Creature creature, View view, GltfOptions export, int threads) => PngWriter.ToBytes(Preview.Rendering.Portrait.Take(creature, export.Textures, view, new RenderOptions
    {
        Width = Width,
        Height = Height,
        Shading = export.Shading == Shading.Flat ? ShadingMode.Faceted : ShadingMode.Smooth,
        Backdrop = Backdrop,
        Ground = Backdrop == BackdropKind.Transparent ? GroundKind.None : GroundKind.Shadows,
        Threads = threads,
    }));
}
