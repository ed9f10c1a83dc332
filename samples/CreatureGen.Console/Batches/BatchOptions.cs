using System;
using System.Globalization;
using System.Linq;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Batches;

/// <summary>What becomes of creatures that are there already.</summary>
internal enum Existing
{
    /// <summary>They are made anew.</summary>
    Replace,

    /// <summary>They stay if the manifest and their bytes say that they are those that would be made.</summary>
    Resume,

    /// <summary>They stay if there are files of their names.</summary>
    Skip,
}

/// <summary>Whether a manifest is kept that nobody asked for.</summary>
internal enum ManifestNeed
{
    /// <summary>It is not.</summary>
    AsAskedFor,

    /// <summary>It is: what is made needs an index.</summary>
    Always,
}

/// <summary>The options that make a batch of many creatures one that may be shared between tasks, ended at any time, and taken up again.</summary>
/// <param name="Shard">The part of this task; null if no manifest is kept.</param>
/// <param name="Existing">What becomes of creatures that are there already.</param>
internal sealed record BatchOptions(Shard? Shard, Existing Existing)
{
    // What the schedulers of Kubernetes (Indexed Jobs) and Slurm (job arrays) tell their tasks.
    private const string KubernetesIndex = "JOB_COMPLETION_INDEX";
    private const string SlurmIndex = "SLURM_ARRAY_TASK_ID";
    private const string SlurmMin = "SLURM_ARRAY_TASK_MIN";
    private const string SlurmStep = "SLURM_ARRAY_TASK_STEP";
    private const string SlurmCount = "SLURM_ARRAY_TASK_COUNT";

    private static readonly OptionSyntax manifest = new("--manifest", null, "tell of each creature, with its SHA-256, in manifest.jsonl in the folder");
    private static readonly OptionSyntax shard = new("--shard", "I/N", "make every Nth creature from the Ith on, 0/N to N-1/N, with a manifest (default in a batch with one: what Slurm or Kubernetes tell)");
    private static readonly OptionSyntax shards = new("--shards", "N", "into how many shards a Kubernetes Job is divided, whose tasks know their index alone");
    private static readonly OptionSyntax resume = new("--resume", null, "keep what the manifest lists if its bytes are there, make the rest");
    private static readonly OptionSyntax skip = new("--skip-existing", null, "leave out creatures that have all their files, whatever is in them");

    /// <summary>All of them, in the order of the help.</summary>
    public static OptionSyntax[] Syntax { get; } = [manifest, shard, shards, resume, skip];

    /// <summary>What was asked for.</summary>
    /// <exception cref="UsageError">The options contradict one another, or what a scheduler tells.</exception>
    public static BatchOptions Read(ParsedArguments arguments, ManifestNeed need, Surroundings surroundings)
    {
        OptionSyntax[] given = new[] { manifest, shard, shards, resume }.Where(option => arguments.Has(option.Name)).ToArray();
        if (arguments.Has(skip.Name))
        {
            return given.Length == 0 ? new BatchOptions(null, Existing.Skip) : throw arguments.Wrong($"{given[0].Name} and {skip.Name}; expected one of them: a manifest lists only creatures whose bytes are known");
        }

        return given.Length == 0 && need == ManifestNeed.AsAskedFor ? new BatchOptions(null, Existing.Replace) : new BatchOptions(ReadShard(arguments, surroundings), arguments.Has(resume.Name) ? Existing.Resume : Existing.Replace);
    }

    private static Shard ReadShard(ParsedArguments arguments, Surroundings surroundings)
    {
        if (arguments.Value(shard.Name) is string text)
        {
            Shard read = Batches.Shard.TryRead(text, out Shard found) ? found : throw arguments.Wrong(shard.Name, text, Batches.Shard.Expectation);
            return !arguments.Has(shards.Name) || ReadCount(arguments) == read.Count ? read : throw arguments.Wrong($"{shard.Name} {text} and {shards.Name} {arguments.Value(shards.Name)}; expected the same number");
        }

        if (surroundings.Variable(KubernetesIndex) is string kubernetes)
        {
            int index = Told(arguments, KubernetesIndex, kubernetes);
            int count = arguments.Has(shards.Name) ? ReadCount(arguments) : throw arguments.Wrong($"{KubernetesIndex} = '{kubernetes}', which does not tell of how many; expected {shards} with the Job's completions, or {shard}");
            return index < count ? new Shard(index, count) : throw arguments.Wrong(FormattableString.Invariant($"{KubernetesIndex} = {index} and {shards.Name} {count}; expected an index below the number of shards"));
        }

        if (surroundings.Variable(SlurmIndex) is string slurm)
        {
            return OfArray(arguments, surroundings, slurm);
        }

        return arguments.Has(shards.Name) && ReadCount(arguments) > 1 ? throw arguments.Wrong($"{shards.Name} {arguments.Value(shards.Name)} without an index; expected {KubernetesIndex} in the environment, or {shard}") : Batches.Shard.Whole;
    }

    /// <summary>The shard of a task of an array, whose numbers may start anywhere and go on in steps.</summary>
    private static Shard OfArray(ParsedArguments arguments, Surroundings surroundings, string task)
    {
        string Variable(string name) => surroundings.Variable(name) ?? throw arguments.Wrong($"{SlurmIndex} is there without {name}; expected both, or {shard}");
        int id = Told(arguments, SlurmIndex, task);
        int least = Told(arguments, SlurmMin, Variable(SlurmMin));
        int count = Told(arguments, SlurmCount, Variable(SlurmCount));
        int step = surroundings.Variable(SlurmStep) is string told ? Math.Max(1, Told(arguments, SlurmStep, told)) : 1;
        int index = (id - least) / step;
        bool even = id >= least && (id - least) % step == 0 && index < count && count <= Batches.Shard.Max;
        if (!even)
        {
            throw arguments.Wrong(FormattableString.Invariant($"task {id} of an array of {count} from {least} in steps of {step}; expected an array without gaps, such as --array=0-63, or {shard}"));
        }

        return !arguments.Has(shards.Name) || ReadCount(arguments) == count ? new Shard(index, count) : throw arguments.Wrong(FormattableString.Invariant($"{SlurmCount} = {count} and {shards.Name} {arguments.Value(shards.Name)}; expected the same number"));
    }

    private static int ReadCount(ParsedArguments arguments) => arguments.Whole(shards.Name, 1, Batches.Shard.Max, 1);

    private static int Told(ParsedArguments arguments, string variable, string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : throw arguments.Wrong(variable, text, "a whole number from 0 on");
}
