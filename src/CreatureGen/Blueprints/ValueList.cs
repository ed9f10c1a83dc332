using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace CreatureGen.Blueprints;

/// <summary>An immutable list that is equal to another when their elements are equal, one by one.</summary>
/// <typeparam name="T">The type of the elements.</typeparam>
public sealed class ValueList<T> : IReadOnlyList<T>, IEquatable<ValueList<T>>
    where T : IEquatable<T>
{
    private readonly T[] items;

    /// <summary>Copies the elements of <paramref name="items"/>.</summary>
    /// <exception cref="ArgumentNullException">The sequence or one of its elements is null.</exception>
    public ValueList(IEnumerable<T> items)
    {
        this.items = CopyOf(items ?? throw new ArgumentNullException(nameof(items)));
        foreach (T item in this.items)
        {
            if (item is null)
            {
                throw new ArgumentNullException(nameof(items), "an element of the list is null");
            }
        }
    }

    /// <summary>The elements of a list; where there are none, the list without elements.</summary>
    internal static ValueList<T> Of(List<T> items) => items.Count == 0 ? Empty : new ValueList<T>(items);

    /// <summary>The list without elements.</summary>
    public static ValueList<T> Empty { get; } = new(Array.Empty<T>());

    /// <inheritdoc/>
    public int Count => items.Length;

    /// <inheritdoc/>
    public T this[int index] => items[index];

    /// <summary>A copy of this list in which the element at <paramref name="index"/> is <paramref name="item"/>.</summary>
    public ValueList<T> With(int index, T item)
    {
        T[] copy = (T[])items.Clone();
        copy[index] = item;
        return new ValueList<T>(copy);
    }

    /// <summary>A list of what a change makes of each element, in their order.</summary>
    internal ValueList<T> Each(Func<T, T> change) => new(Array.ConvertAll(items, item => change(item)));

    /// <inheritdoc/>
    public bool Equals(ValueList<T>? other)
    {
        if (ReferenceEquals(this, other))
        {
            return true;
        }

        if (other is null || other.items.Length != items.Length)
        {
            return false;
        }

        for (int i = 0; i < items.Length; i++)
        {
            if (!items[i].Equals(other.items[i]))
            {
                return false;
            }
        }

        return true;
    }

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as ValueList<T>);

    /// <inheritdoc/>
    public override int GetHashCode()
    {
        int hash = items.Length;
        foreach (T item in items)
        {
            hash = unchecked((hash * 31) + item.GetHashCode());
        }

        return hash;
    }

    /// <summary>The elements' own text, the same in every culture: <c>[a, b]</c>.</summary>
    public override string ToString()
    {
        var text = new StringBuilder("[");
        foreach (T item in items)
        {
            text.Append(text.Length > 1 ? ", " : "");
            text.Append(item is IFormattable formattable ? formattable.ToString(null, CultureInfo.InvariantCulture) : item.ToString());
        }

        return text.Append(']').ToString();
    }

    /// <inheritdoc/>
    public IEnumerator<T> GetEnumerator() => ((IEnumerable<T>)items).GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>The elements in memory of their own. A blueprint has two dozen lists, most of them empty: where the length is known they are copied once.</summary>
    private static T[] CopyOf(IEnumerable<T> items)
    {
        if (items is not ICollection<T> known)
        {
            return new List<T>(items).ToArray();
        }

        T[] copy = known.Count == 0 ? Array.Empty<T>() : new T[known.Count];
        known.CopyTo(copy, 0);
        return copy;
    }
}
