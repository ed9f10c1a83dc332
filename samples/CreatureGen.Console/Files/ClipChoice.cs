using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using CreatureGen.Console.Arguments;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Console.Files;

/// <summary>Which clips a file holds.</summary>
/// <param name="Text"><c>none</c>, <c>all</c>, or names with hyphens and commas between, as <c>idle,walk,turn-left</c>.</param>
internal sealed record ClipChoice(string Text)
{
    /// <summary>The creature alone.</summary>
    public static ClipChoice None { get; } = new("none");

    /// <summary>Everything that the creature does.</summary>
    public static ClipChoice All { get; } = new("all");

    /// <summary>Every name that a clip of any creature can have.</summary>
    public static IReadOnlyList<string> Known { get; } = [.. ClipBaker.Names.Select(MovementArguments.Hyphenated)];

    /// <summary>The choice of a text.</summary>
    /// <param name="text">As <see cref="Text"/>; names without hyphens will do.</param>
    /// <param name="wrong">Makes an error of what was expected.</param>
    public static ClipChoice Read(string text, Func<string, Exception> wrong)
    {
        if (text is "none" or "all")
        {
            return new ClipChoice(text);
        }

        var names = new List<string>();
        foreach (string word in text.Split(','))
        {
            string name = Known.FirstOrDefault(known => Plain(known) == Plain(word)) ?? throw wrong($"all, none, or names with commas between, of {string.Join(", ", Known)}{Suggestion.For(word, Known)}");
            if (!names.Contains(name))
            {
                names.Add(name);
            }
        }

        return new ClipChoice(string.Join(',', names));
    }

    /// <summary>The clips of the names of a file.</summary>
    public static ClipChoice OfNames(IReadOnlyCollection<string> names) => names.Count == 0 ? None : new ClipChoice(string.Join(',', names.Select(MovementArguments.Hyphenated)));

    /// <summary>Bakes what of it the creature does.</summary>
    /// <exception cref="OperationCanceledException">It was stopped between two clips.</exception>
    public IReadOnlyList<Clip> Bake(Creature creature, CancellationToken cancellation) => this == None ? [] : Bake(new MotionProfile(creature), cancellation);

    /// <summary>Bakes what of it a body does.</summary>
    /// <exception cref="OperationCanceledException">It was stopped between two clips.</exception>
    public IReadOnlyList<Clip> Bake(MotionProfile profile, CancellationToken cancellation)
    {
        string[] wanted = Array.ConvertAll(Text.Split(','), Plain);
        var clips = new List<Clip>();
        foreach (ClipRecipe recipe in ClipBaker.RecipesOf(profile).Where(recipe => this == All || wanted.Contains(Plain(recipe.Name))))
        {
            cancellation.ThrowIfCancellationRequested();
            clips.Add(recipe.Bake());
        }

        return clips;
    }

    private static string Plain(string word) => word.Trim().Replace("-", "", StringComparison.Ordinal).ToLowerInvariant();
}
