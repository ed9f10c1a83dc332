using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;
#if EARLIER
using CreatureGen.Animation;
#else
using CreatureGen.Motion;
#endif

namespace CreatureGen.Benchmarks.Probe;

/// <summary>The blueprints that both builds work on, and what has been made of them.</summary>
internal sealed class Subjects
{
    private static readonly RequestedKind[] kinds = { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming };

    private Subjects(CreatureBlueprint[] blueprints)
    {
        Blueprints = blueprints;
        Creatures = Array.ConvertAll(blueprints, CreatureAssembler.Assemble);
        Profiles = Array.ConvertAll(Creatures, creature => new MotionProfile(creature));
    }

    /// <summary>Blueprints of all kinds in turn.</summary>
    public CreatureBlueprint[] Blueprints { get; }

    /// <summary>Their creatures.</summary>
    public Creature[] Creatures { get; }

    /// <summary>How these move.</summary>
    public MotionProfile[] Profiles { get; }

    /// <summary>Writes the blueprints of the first seeds, kind by kind in turn.</summary>
    public static void Write(string folder, int count)
    {
        for (int i = 0; i < count; i++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)i, CreatureOptions.Default with { Kind = kinds[i % kinds.Length] });
            File.WriteAllText(Path.Combine(folder, i.ToString("D4", CultureInfo.InvariantCulture) + ".json"), BlueprintJson.Write(blueprint));
        }
    }

    /// <summary>Reads all blueprints of a folder.</summary>
    public static Subjects Read(string folder) => new(Directory.GetFiles(folder, "*.json").OrderBy(path => path, StringComparer.Ordinal).Select(path => BlueprintJson.Read(File.ReadAllText(path)).GetBlueprint()).ToArray());
}
