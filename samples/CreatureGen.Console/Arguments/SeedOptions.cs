using System;

namespace CreatureGen.Console.Arguments;

/// <summary>The options that say which seeds are meant.</summary>
internal static class SeedOptions
{
    public static readonly OptionSyntax Seed = new("--seed", "N", "one seed, decimal or 0x hexadecimal");

    public static readonly OptionSyntax Seeds = new("--seeds", "LIST", "seeds and inclusive ranges: 1-1000,2000,0xBEEF");

    /// <summary>The one seed of a verb that takes no more.</summary>
    /// <exception cref="UsageError">There is none, or it cannot be read.</exception>
    public static ulong ReadOne(ParsedArguments arguments) => Read(arguments, arguments.Required(Seed.Name));

    /// <summary>The seeds asked for.</summary>
    /// <exception cref="UsageError">There are none, or they cannot be read.</exception>
    public static SeedList Read(ParsedArguments arguments)
    {
        if (arguments.Value(Seed.Name) is string one)
        {
            if (arguments.Has(Seeds.Name))
            {
                throw arguments.Wrong("--seed and --seeds; expected one of them");
            }

            return SeedList.Of(Read(arguments, one));
        }

        if (arguments.Value(Seeds.Name) is not string list)
        {
            throw arguments.Wrong("no seeds; expected --seed N or --seeds LIST, such as --seeds 1-36");
        }

        try
        {
            return SeedList.Read(list);
        }
        catch (FormatException problem)
        {
            throw arguments.Wrong("--seeds: " + problem.Message);
        }
    }

    private static ulong Read(ParsedArguments arguments, string text) =>
        SeedText.TryRead(text.Trim(), out ulong seed) ? seed : throw arguments.Wrong(Seed.Name, text, SeedText.Expectation);
}
