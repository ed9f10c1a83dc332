using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>What is made of seeds: which creatures, and which files of each.</summary>
/// <param name="Options">Which creatures.</param>
/// <param name="Export">How they are written as GLB.</param>
/// <param name="Clips">Whether their motion is written too.</param>
/// <param name="Pictures">Which pictures are taken.</param>
/// <param name="Dataset">What else of each, for training.</param>
internal sealed record CreatureTask(CreatureOptions Options, GltfOptions Export, ClipChoice Clips, PictureOrder Pictures, DatasetOrder Dataset)
{
    /// <summary>The forms of a creature's files (<see cref="CreatureFile.Form"/>).</summary>
    public IEnumerable<string> Forms => ["glb", .. Pictures.Forms, "json", .. Dataset.Forms];

    /// <summary>Makes a creature and all that is in its files.</summary>
    /// <param name="specimen">Which.</param>
    /// <param name="threads">Threads that share the work of a picture.</param>
    /// <param name="cancellation">Gives the creature up.</param>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    /// <exception cref="InvalidOperationException">The creature is not whole: a defect of the library.</exception>
    /// <exception cref="OperationCanceledException">It was stopped between two clips, pictures or files.</exception>
    public MadeCreature Make(Specimen specimen, int threads, CancellationToken cancellation)
    {
        var times = new StageTimes();
        CreatureOptions options = specimen.Of(Options);
        CreatureBlueprint blueprint = Growing.Sample(specimen.Seed, options);
        times.Finished("blueprint");
        Creature creature = CreatureAssembler.Assemble(blueprint, times);
        IReadOnlyList<Clip> clips = Clips.Bake(creature, cancellation);
        cancellation.ThrowIfCancellationRequested();
        GltfOptions export = CreatureFiles.WithAtlas(creature, Export with { Provenance = OptionsJson.Write(options), Clips = new StoppableList<Clip>(clips, cancellation) });
        cancellation.ThrowIfCancellationRequested();
        var contents = new List<(string Form, byte[] Content)> { ("glb", CreatureFiles.Glb(creature, export)) };
        times.Finished("glb");
        if (Pictures.Views.Count > 0)
        {
            contents.AddRange(Pictures.Take(creature, export, threads, cancellation));
            times.Finished("picture");
        }

        contents.Add(("json", CreatureFiles.Json(blueprint)));
        if (Dataset.Views > 0)
        {
            contents.AddRange(Dataset.Make(creature, export.Textures, Clips == ClipChoice.All ? clips : ClipChoice.All.Bake(creature, cancellation), specimen.Name, Pictures.Backdrop, threads, cancellation));
            times.Finished("dataset");
        }

        return new MadeCreature(CreatureFacts.Of(creature, specimen), clips.Select(clip => new ClipFacts(clip.Name, clip.Duration, clip.Speed, clip.End)).ToArray(), contents, times);
    }
}

/// <summary>A creature, and what goes into its files.</summary>
/// <param name="Facts">What there is to tell of it.</param>
/// <param name="Clips">Its motion.</param>
/// <param name="Contents">The form and the bytes of each file.</param>
/// <param name="Times">How long it took until now.</param>
internal sealed record MadeCreature(CreatureFacts Facts, IReadOnlyList<ClipFacts> Clips, IReadOnlyList<(string Form, byte[] Content)> Contents, StageTimes Times);

/// <summary>What there is to tell of a clip.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Seconds">How long it lasts.</param>
/// <param name="Speed">Metres per second ahead.</param>
/// <param name="End">What becomes of it at its end.</param>
internal sealed record ClipFacts(string Name, float Seconds, float Speed, ClipEnd End);
