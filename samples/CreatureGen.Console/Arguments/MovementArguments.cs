using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using CreatureGen.Motion;

namespace CreatureGen.Console.Arguments;

/// <summary>The options that say what a creature is to do.</summary>
internal static class MovementArguments
{
    private const float SlowestSpeed = 0.001f;
    private const float FastestSpeed = 1000f;

    // Standard gravity, metres per second squared: that of the animator's settings by default.
    private static readonly float gravity = MotionSettings.Default.Gravity;

    public static readonly OptionSyntax Gait = new("--gait", "GAIT", "walk, trot, canter, transverse-gallop, run, hop, tripod, fly, take-off, land, swim, c-start, slither, sidewind, rectilinear ... (default: what suits the speed)");

    public static readonly OptionSyntax Speed = new("--speed", "V", "metres per second (default: the most comfortable for the gait)");

    /// <summary>The movement asked for.</summary>
    /// <exception cref="UsageError">The creature has no such gait, or the speed cannot be read.</exception>
    public static Movement Read(ParsedArguments arguments, MotionProfile profile)
    {
        float? speed = ReadSpeed(arguments);
        IReadOnlyList<Movement> all = Movement.OfGoing(profile);
        Movement movement = arguments.Value(Gait.Name) is string word ? Find(arguments, all, word) : Suitable(profile, all, speed);
        return speed is float metres ? movement.At(metres) : movement;
    }

    /// <summary>The speed asked for, before any creature is grown; null for none.</summary>
    /// <exception cref="UsageError">It cannot be read.</exception>
    public static float? ReadSpeed(ParsedArguments arguments)
    {
        if (arguments.Value(Speed.Name) is not string text)
        {
            return null;
        }

        return float.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out float speed) && speed is >= SlowestSpeed and <= FastestSpeed
            ? speed
            : throw arguments.Wrong(Speed.Name, text, "metres per second, 0.001..1000");
    }

    private static Movement Find(ParsedArguments arguments, IReadOnlyList<Movement> all, string word)
    {
        string wanted = Plain(word);
        foreach (Movement movement in all)
        {
            if (Plain(movement.Name) == wanted || Plain(movement.GaitName) == wanted)
            {
                return movement;
            }
        }

        string[] known = all.Select(movement => Hyphenated(movement.Name)).ToArray();
        throw arguments.Wrong(Gait.Name, word, "a gait that this creature has: " + string.Join(", ", known) + Suggestion.For(word, known));
    }

    private static Movement Suitable(MotionProfile profile, IReadOnlyList<Movement> all, float? speed)
    {
        if (profile.Gaits is not null && speed is float metres && all.All(movement => movement.Input.Medium == MotionMedium.Ground))
        {
            int choice = profile.Gaits.Choose(0, metres * metres / (gravity * profile.LegLength));
            return all.First(movement => movement.Gait == profile.Gaits.Steps[choice].Gait);
        }

        // What its kind is for comes after the gaits; hovering needs to be asked for.
        return all.FirstOrDefault(movement => movement.IsCyclic && movement.Gait is null) ?? all.First(movement => movement.IsCyclic);
    }

    private static string Plain(string word) => word.Replace("-", "", StringComparison.Ordinal).Replace("_", "", StringComparison.Ordinal).ToLowerInvariant();

    /// <summary>A name in words of lower case.</summary>
    public static string Hyphenated(string name)
    {
        var words = new StringBuilder();
        foreach (char letter in name)
        {
            if (char.IsUpper(letter) && words.Length > 0)
            {
                words.Append('-');
            }

            words.Append(char.ToLowerInvariant(letter));
        }

        return words.ToString();
    }
}
