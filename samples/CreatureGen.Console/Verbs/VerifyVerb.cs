using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Checks the creatures of many seeds.</summary>
internal sealed class VerifyVerb : IVerb
{
    /// <summary>The invariant of a blueprint that cannot be built at all.</summary>
    public const string Builds = "builds";

    /// <summary>The invariant that every limb that the rules ask for has a socket of its own.</summary>
    public const string Sockets = "sockets";

    private static readonly OptionSyntax poses = new("--poses", "N", "look for crossings on all levels of detail and in N poses of each clip as well, 1 to 256: seconds for each creature");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "verify",
        null,
        "check all invariants of the creatures of seeds, or the files of a batch",
        [
            new("verify --seeds 1-1000", "check a thousand creatures, each of its seed's natural kind"),
            new("verify --seeds 1-100 --individuals 1-20", "twenty individuals of each of a hundred species"),
            new("verify --manifest farm/manifest.jsonl", "whether all files of a batch are there and whole"),
            new("verify --manifest farm --grow", "whether they are what would be made now"),
            new("verify --seeds 1-100000 --kind walking --threads 8 --json > report.json", "a long run, for a script"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, SeedOptions.Individual, SeedOptions.Individuals, .. CreatureArguments.Syntax, .. ManifestVerification.Syntax, poses, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        if (ManifestVerification.IsAskedFor(arguments))
        {
            return ManifestVerification.Run(arguments, surroundings);
        }

        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        SpecimenList specimens = SeedOptions.Specimens(arguments, seeds, options);
        int threads = CommonOptions.ReadThreads(arguments);
        int deep = arguments.Has(poses.Name) ? arguments.Whole(poses.Name, 1, CrossingTrial.MaxPoses, 0) : 0;
        var verification = new Verification();
        using (var progress = new ProgressLine(surroundings, "creatures checked", specimens.Count, ProgressKind.Shown))
        {
            OrderedWork<Specimen, VerifiedCreature>.Run(specimens, threads, specimen => Verify(specimen, options, surroundings.Checks, deep), creature =>
            {
                verification.Add(creature);
                progress.Step();
            }, surroundings.Cancellation);
        }

        if (arguments.Has(CommonOptions.Json.Name))
        {
            VerificationJson.Write(surroundings.Out, verification);
        }
        else
        {
            VerificationText.Write(surroundings.Out, verification, surroundings.Checks.Names.Prepend(Sockets).ToArray(), Ink.For(surroundings, surroundings.OutIsTerminal));
        }

        return verification.Failed == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static VerifiedCreature Verify(Specimen specimen, CreatureOptions options, CreatureChecks checks, int deep)
    {
        CreatureBlueprint blueprint = Growing.Sample(specimen.Seed, specimen.Of(options), out SocketTally sockets);
        if (sockets.LimbRefusals > 0)
        {
            string detail = FormattableString.Invariant($"{sockets.LimbRefusals} sockets of legs, wings or fins ran into others; expected none");
            return new VerifiedCreature(blueprint.Kind, specimen, [new VerificationProblem(blueprint.Kind, specimen, Sockets, detail)], default, null);
        }

        try
        {
            Creature creature = CreatureAssembler.Assemble(blueprint);
            CheckResult result = CheckResult.Of(creature, checks);
            VerificationProblem[] problems = result.Violations.Select(violation => new VerificationProblem(blueprint.Kind, specimen, violation.Invariant, violation.Detail)).ToArray();
            return new VerifiedCreature(blueprint.Kind, specimen, problems, result.Crossings, deep > 0 ? CrossingTrial.Run(creature, deep) : null);
        }
        catch (Exception problem) when (problem is not OutOfMemoryException)
        {
            // Whatever a stage throws is a defect of the creature, to be reported with all others.
            return new VerifiedCreature(blueprint.Kind, specimen, [new VerificationProblem(blueprint.Kind, specimen, Builds, problem.GetType().Name + ": " + problem.Message)], default, null);
        }
    }
}
