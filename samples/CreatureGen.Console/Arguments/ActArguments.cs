using System;
using System.Globalization;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;

namespace CreatureGen.Console.Arguments;

/// <summary>The options that say which act a creature is to perform, and where.</summary>
internal static class ActArguments
{
    private const float Farthest = 1e4f;

    public static readonly OptionSyntax Act = new("--act", "ACT", "bite, claw, kick, gore, tail-sweep, eat, drink, sniff, call, shake, scratch, groom, sit, lie, sleep, threaten, submit, dance, flinch, die ...");

    public static readonly OptionSyntax Target = new("--target", "X,Y,Z", "with --act: where, metres left, up and ahead of the creature's root (default: what suits it)");

    /// <summary>An act that a creature can do, by its name.</summary>
    /// <param name="profile">Whose.</param>
    /// <param name="word">The name, with or without hyphens.</param>
    /// <param name="wrong">Makes an error of what was expected.</param>
    public static ActAbility Find(MotionProfile profile, string word, Func<string, Exception> wrong)
    {
        ActAbility found = Named(profile, word, wrong);
        return found.IsPossible ? found : throw wrong($"an act that this creature can do: {string.Join(", ", Known(profile))} (not {word}: {found.Refusal})");
    }

    /// <summary>The same, whether the creature can do it or not.</summary>
    public static ActAbility Named(MotionProfile profile, string word, Func<string, Exception> wrong)
    {
        string plain = word.Replace("-", "", StringComparison.Ordinal);
        ActAbility? found = profile.Acts.All.FirstOrDefault(ability => string.Equals(ability.Act.Name, plain, StringComparison.OrdinalIgnoreCase));
        string[] known = Known(profile);
        return found ?? throw wrong("an act: " + string.Join(", ", known) + Suggestion.For(word, known));
    }

    private static string[] Known(MotionProfile profile) => profile.Acts.Possible.Select(ability => MovementArguments.Hyphenated(ability.Act.Name)).ToArray();

    /// <summary>The target asked for.</summary>
    /// <exception cref="UsageError">It cannot be read.</exception>
    public static ActTarget ReadTarget(ParsedArguments arguments)
    {
        if (arguments.Value(Target.Name) is not string text)
        {
            return ActTarget.Usual;
        }

        string[] parts = text.Split(',');
        var numbers = new float[3];
        for (int i = 0; i < numbers.Length; i++)
        {
            if (parts.Length != numbers.Length || !float.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !(Math.Abs(numbers[i]) <= Farthest))
            {
                throw arguments.Wrong(Target.Name, text, "three finite numbers with commas between, such as 0,0.4,1.2");
            }
        }

        return ActTarget.At(new Vector3(numbers[0], numbers[1], numbers[2]));
    }
}
