using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>From a seed to its blueprint, and to what is measured of its creature, for options that somebody typed.</summary>
internal static class Growing
{
    /// <summary>The blueprint of a seed within options.</summary>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options) => Sample(seed, options, out _);

    /// <summary>The same, and how the sockets of its limbs were given out.</summary>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options, out SocketTally sockets)
    {
        try
        {
            return BlueprintSampler.Sample(seed, options, out sockets);
        }
        catch (ImpossibleSeedException problem)
        {
            throw new ImpossibleSeed(WithoutParameter(problem));
        }
        catch (ArgumentException problem)
        {
            throw new UsageError(WithoutParameter(problem));
        }
    }

    /// <summary>Grows the creature of a seed and measures how it moves.</summary>
    /// <param name="seed">Its seed.</param>
    /// <param name="options">Within what it is sampled.</param>
    /// <param name="measure">All measurements of a creature.</param>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    /// <exception cref="InvalidOperationException">Its motion failed.</exception>
    public static IReadOnlyList<TRun> Measure<TRun>(ulong seed, CreatureOptions options, Func<MotionProfile, IEnumerable<TRun>> measure)
    {
        CreatureBlueprint blueprint = Sample(seed, options);
        try
        {
            return measure(new MotionProfile(CreatureAssembler.Assemble(blueprint))).ToArray();
        }
        catch (ArgumentException problem)
        {
            // Nothing that is measured comes from outside.
            throw new InvalidOperationException($"{WordList<LocomotionKind>.Instance[blueprint.Kind]} {SeedText.Of(blueprint.Seed)}: {problem.Message}", problem);
        }
    }

    /// <summary>The name of a joint of what is measured; null for −1, which is none.</summary>
    public static string? JointName(MotionProfile profile, int joint) => joint < 0 ? null : profile.Subject.Skeleton.Joints[joint].Name;

    private static string WithoutParameter(ArgumentException problem)
    {
        int end = problem.Message.LastIndexOf(" (Parameter", StringComparison.Ordinal);
        return end < 0 ? problem.Message : problem.Message[..end];
    }
}
