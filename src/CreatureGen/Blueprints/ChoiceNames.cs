using System;
using System.Collections.Generic;

namespace CreatureGen.Blueprints;

/// <summary>The names that the values of an enumeration have in JSON text. They are part of the format and outlive a renaming in code.</summary>
/// <typeparam name="TEnum">The enumeration.</typeparam>
internal sealed class ChoiceNames<TEnum>
    where TEnum : struct, Enum
{
    private readonly (TEnum Value, string Name)[] all;

    public ChoiceNames(params (TEnum Value, string Name)[] all) => this.all = all;

    /// <summary>Number of values.</summary>
    public int Count => all.Length;

    /// <summary>The first value.</summary>
    public TEnum First => all[0].Value;

    /// <summary>All values, in the order of the names.</summary>
    public IEnumerable<TEnum> Values
    {
        get
        {
            foreach ((TEnum value, _) in all)
            {
                yield return value;
            }
        }
    }

    /// <summary>The name of a value; null if the enumeration does not define it.</summary>
    public string? NameOf(TEnum value)
    {
        foreach ((TEnum known, string name) in all)
        {
            if (EqualityComparer<TEnum>.Default.Equals(known, value))
            {
                return name;
            }
        }

        return null;
    }

    /// <summary>The value of a name, if there is one of that name.</summary>
    public bool TryFind(string name, out TEnum value)
    {
        foreach ((TEnum known, string knownName) in all)
        {
            if (string.Equals(knownName, name, StringComparison.Ordinal))
            {
                value = known;
                return true;
            }
        }

        value = default;
        return false;
    }

    /// <summary>What is expected of a choice, as a message says it.</summary>
    public override string ToString() => "one of " + string.Join(", ", Array.ConvertAll(all, choice => choice.Name));
}
