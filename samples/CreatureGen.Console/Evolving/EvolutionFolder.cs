using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Working;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Genetics.Populations;

namespace CreatureGen.Console.Evolving;

/// <summary>
/// The folder of a run: <c>lineage.json</c>, and in <c>creatures/</c> the blueprint of everybody who lived. A generation is there when <c>lineage.json</c> says so, which is written last: a run that is killed
/// loses the generation that it was at.
/// </summary>
internal sealed class EvolutionFolder(string path, Surroundings surroundings)
{
    /// <summary>Where the run is.</summary>
    public string Lineage => Path.Combine(path, "lineage.json");

    /// <summary>Whether there is a run.</summary>
    public bool HasRun => File.Exists(Lineage);

    /// <summary>Where a picture or another file of the run is.</summary>
    public string PathOf(string name) => Path.Combine(path, name);

    /// <summary>Makes the folders.</summary>
    /// <exception cref="WriteFailure">They cannot be made.</exception>
    public void Make()
    {
        FileSet.MakeFolder(path, surroundings);
        FileSet.MakeFolder(Path.Combine(path, "creatures"), surroundings);
    }

    /// <summary>Writes what is new in a run, all or none.</summary>
    /// <param name="run">The run.</param>
    /// <param name="pictures">Files beside it, by their names.</param>
    /// <exception cref="WriteFailure">Something cannot be written.</exception>
    public void Save(EvolutionRun run, IReadOnlyList<(string Name, byte[] Content)> pictures)
    {
        using var files = new FileSet(surroundings);
        foreach (Individual one in run.Now.Individuals.Concat(run.Now.Archive))
        {
            Stage(files, one.Identity, one.Blueprint);
        }

        foreach ((string name, byte[] content) in pictures)
        {
            files.Stage(PathOf(name), stream => stream.Write(content));
        }

        byte[] lineage = Encoding.UTF8.GetBytes(LineageText.Write(run));
        files.Stage(Lineage, stream => stream.Write(lineage));
        files.Commit();
    }

    /// <summary>Reads the run.</summary>
    /// <param name="goal">The goal by which it was judged.</param>
    /// <exception cref="UsageError">It cannot be read; the message says why.</exception>
    public EvolutionRun Load(Goal goal) => Reading(text => LineageText.Read(text, (identity, verdict, scores) => Evolution.Recall(Creature(identity), verdict, scores, goal)));

    /// <summary>The creatures that were picked when the run was last left; none if there is no run.</summary>
    /// <exception cref="UsageError">They cannot be read; the message says why.</exception>
    public IReadOnlyList<CreatureBlueprint> Picked() => HasRun ? Reading(text => LineageText.ReadPicks(text)).Select(Creature).ToArray() : [];

    /// <summary>Writes creatures that are to be found again, whether they live or not.</summary>
    /// <exception cref="WriteFailure">One cannot be written.</exception>
    public void Keep(IEnumerable<CreatureBlueprint> blueprints)
    {
        using var files = new FileSet(surroundings);
        foreach (CreatureBlueprint blueprint in blueprints)
        {
            Stage(files, BlueprintIdentity.Of(blueprint), blueprint);
        }

        files.Commit();
    }

    /// <summary>A creature of the run.</summary>
    /// <exception cref="UsageError">Its blueprint cannot be read.</exception>
    public CreatureBlueprint Creature(ulong identity) => CreatureSource.Read(BlueprintOf(identity), surroundings).Blueprint;

    /// <summary>The creature of the run whose number begins with some digits; null if there is none.</summary>
    public ulong? Find(string digits)
    {
        string[] found = Directory.Exists(Path.Combine(path, "creatures")) ? Directory.GetFiles(Path.Combine(path, "creatures"), $"creature-{digits}*.json") : [];
        return found.Length == 1 && HashText.TryRead(Path.GetFileNameWithoutExtension(found[0])["creature-".Length..], out ulong identity) ? identity : null;
    }

    private T Reading<T>(Func<string, T> read)
    {
        try
        {
            return read(File.ReadAllText(Lineage));
        }
        catch (Exception problem) when (problem is FormatException || Reason.IsOfFiles(problem))
        {
            string reason = problem is FormatException ? problem.Message : Reason.Of(problem);
            throw new UsageError($"cannot go on with '{Lineage}': {reason}; expected what evolve wrote, or another folder");
        }
    }

    private void Stage(FileSet files, ulong identity, CreatureBlueprint blueprint)
    {
        string file = BlueprintOf(identity);
        if (!File.Exists(file))
        {
            byte[] text = CreatureFiles.Json(blueprint);
            files.Stage(file, stream => stream.Write(text));
        }
    }

    private string BlueprintOf(ulong identity) => CreatureFiles.PathOf(Path.Combine(path, "creatures"), HashText.Of(identity), "json");
}
