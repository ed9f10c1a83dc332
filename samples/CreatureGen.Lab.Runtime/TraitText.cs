using System;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;

namespace CreatureGen.Lab.Runtime;

/// <summary>Changed traits as the page and its address write them: <c>girth1.2~legs.8</c>.</summary>
internal static class TraitText
{
    private const int Longest = 400;

    public static CreatureBlueprint Apply(CreatureBlueprint blueprint, string traits)
    {
        if (traits.Length > Longest)
        {
            throw new ArgumentException(FormattableString.Invariant($"{traits.Length} letters of traits; expected at most {Longest}"));
        }

        foreach (string entry in traits.Split('~', StringSplitOptions.RemoveEmptyEntries))
        {
            int letters = entry.TakeWhile(char.IsAsciiLetterLower).Count();
            Trait trait = Traits.All.FirstOrDefault(t => entry.AsSpan(0, letters).SequenceEqual(t.Name)) ?? throw new ArgumentException("there is no trait \u201c" + entry[..letters] + "\u201d");
            if (!double.TryParse(entry.AsSpan(letters), NumberStyles.Float & ~NumberStyles.AllowExponent, CultureInfo.InvariantCulture, out double value) || !(value >= trait.Min && value <= trait.Max))
            {
                throw new ArgumentException(FormattableString.Invariant($"{trait.Name} is \u201c{entry[letters..]}\u201d; expected a number from {trait.Min:0.##} to {trait.Max:0.##}"));
            }

            if (trait.Applies(blueprint) && value != trait.Own)
            {
                blueprint = trait.Change(blueprint, value);
            }
        }

        return blueprint;
    }
}
