using System.Collections.Generic;
using System;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Files;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>What the program does when nothing is asked of it: one creature, to be looked at.</summary>
internal static class FirstCreature
{
    /// <summary>Its seed.</summary>
    public const ulong Seed = 101;

    /// <summary>Makes it, writes its files into the current folder and tells what it is.</summary>
    public static int Run(Surroundings surroundings)
    {
        var times = new StageTimes();
        CreatureBlueprint blueprint = BlueprintSampler.Sample(Seed);
        times.Finished("blueprint");
        Creature creature = CreatureAssembler.Assemble(blueprint, times);
        GltfOptions export = CreatureFiles.WithAtlas(creature, GlbExport.Default with { Provenance = OptionsJson.Write(CreatureOptions.Default) });
        byte[] glb = CreatureFiles.Glb(creature, export, ClipChoice.None);
        times.Finished("glb");
        (string, byte[])[] pictures = PictureOrder.Portrait.Take(creature, export, Environment.ProcessorCount, surroundings.Abandonment).ToArray();
        times.Finished("picture");
        IReadOnlyList<CreatureFile> files = CreatureFiles.Write(surroundings.Folder, new Specimen(Seed, null).Name, [("glb", glb), .. pictures, ("json", CreatureFiles.Json(blueprint))], surroundings);
        times.Finished("files");
        CreatureText.Write(surroundings.Out, CreatureFacts.Of(creature), files, times);
        surroundings.Out.WriteLine();
        surroundings.Out.WriteLine("More: creaturegen --help");
        return ExitCode.Done;
    }
}
