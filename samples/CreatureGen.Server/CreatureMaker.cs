using System;
using System.IO;
using System.Text;
using System.Threading;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Sampling;

namespace CreatureGen.Server;

/// <summary>Makes what a request asks for.</summary>
internal static class CreatureMaker
{
    /// <summary>The bytes of the answer.</summary>
    /// <exception cref="ImpossibleSeedException">This seed has no creature of that kind.</exception>
    /// <exception cref="OperationCanceledException">Nobody waits for the answer any more.</exception>
    public static byte[] Make(CreatureRequest request, CancellationToken cancellation)
    {
        CreatureBlueprint blueprint = BlueprintSampler.Sample(request.Seed, request.Options);
        if (request.Form == "json")
        {
            return Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint));
        }

        Creature creature = CreatureAssembler.Assemble(blueprint, new Stop(cancellation));
        return request.Form == "glb" ? Glb(creature, request, cancellation) : PngWriter.ToBytes(Portrait.Take(creature, request.View, new RenderOptions { Width = request.Size, Height = request.Size }));
    }

    private static byte[] Glb(Creature creature, CreatureRequest request, CancellationToken cancellation)
    {
        var options = new GltfOptions { Provenance = OptionsJson.Write(request.Options), TextureSize = request.TextureSize, Clips = request.HasClips ? ClipBaker.Bake(creature) : [] };
        cancellation.ThrowIfCancellationRequested();
        var file = new MemoryStream();
        GlbWriter.Write(creature, options, file);
        return file.ToArray();
    }

    /// <summary>Ends an assembly after the stage in which its requester went away.</summary>
    private sealed class Stop(CancellationToken cancellation) : IAssemblyObserver
    {
        public void StageFinished(AssemblyStage stage) => cancellation.ThrowIfCancellationRequested();
    }
}
