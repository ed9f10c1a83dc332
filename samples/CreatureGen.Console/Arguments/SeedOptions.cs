using System;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Arguments;

/// <summary>The options that say which seeds, and which individuals of their species, are meant.</summary>
internal static class SeedOptions
{
    public static readonly OptionSyntax Seed = new("--seed", "N", "one seed, decimal or 0x hexadecimal");

    public static readonly OptionSyntax Seeds = new("--seeds", "LIST", "seeds and inclusive ranges: 1-1000,2000,0xBEEF") { Short = "-s" };

    public static readonly OptionSyntax Individual = new("--individual", "N", "one individual of each seed's species (without it the species' type)");

    public static readonly OptionSyntax Individuals = new("--individuals", "LIST", "individuals of each seed's species: 1-36");

    /// <summary>The one seed of a verb that takes no more.</summary>
    /// <exception cref="UsageError">There is none, or it cannot be read.</exception>
    public static ulong ReadOne(ParsedArguments arguments) => Parse(arguments, Seed, arguments.Required(Seed.Name));

    /// <summary>The seeds asked for.</summary>
    /// <exception cref="UsageError">There are none, or they cannot be read.</exception>
    public static SeedList Read(ParsedArguments arguments) =>
        Read(arguments, Seed, Seeds) ?? throw arguments.Wrong("no seeds; expected --seed N or --seeds LIST, such as --seeds 1-36");

    /// <summary>The creatures asked for.</summary>
    /// <exception cref="UsageError">The individuals cannot be read.</exception>
    public static SpecimenList Specimens(ParsedArguments arguments, SeedList seeds, CreatureOptions options) =>
        new(seeds, Read(arguments, Individual, Individuals) ?? (options.Individual is ulong own ? SeedList.Of(own) : null));

    private static SeedList? Read(ParsedArguments arguments, OptionSyntax single, OptionSyntax many)
    {
        if (arguments.Value(single.Name) is string one)
        {
            if (arguments.Has(many.Name))
            {
                throw arguments.Wrong($"{single.Name} and {many.Name}; expected one of them");
            }

            return SeedList.Of(Parse(arguments, single, one));
        }

        if (arguments.Value(many.Name) is not string list)
        {
            return null;
        }

        try
        {
            return SeedList.Read(list);
        }
        catch (FormatException problem)
        {
            throw arguments.Wrong(many.Name + ": " + problem.Message);
        }
    }

    private static ulong Parse(ParsedArguments arguments, OptionSyntax option, string text) =>
        SeedText.TryRead(text.Trim(), out ulong seed) ? seed : throw arguments.Wrong(option.Name, text, SeedText.Expectation);
}
