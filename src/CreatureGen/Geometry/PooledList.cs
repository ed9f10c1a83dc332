using System;
using System.Buffers;
using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>
/// A growing list in memory borrowed from the shared pool, for buffers that are large and live no longer than one stage: as arrays of their own they
/// would go to the large object heap and make full collections of garbage the dearest stage of all.
/// </summary>
/// <remarks>Disposing gives the memory back; what was read from the list by then is a copy. Without disposing, the collector takes it.</remarks>
internal sealed class PooledList<T> : IDisposable
    where T : unmanaged
{
    private T[] items;

    /// <summary>An empty list with room for a number of items.</summary>
    public PooledList(int capacity) => items = ArrayPool<T>.Shared.Rent(capacity);

    /// <summary>Number of items.</summary>
    public int Count { get; private set; }

    /// <summary>The items; valid until the next one is added.</summary>
    public ReadOnlySpan<T> Items => new(items, 0, Count);

    /// <summary>An item.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such item.</exception>
    public T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Check(index);
            return items[index];
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            Check(index);
            items[index] = value;
        }
    }

    /// <summary>Adds an item at the end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(T item)
    {
        if (Count == items.Length)
        {
            Grow(Count + 1);
        }

        items[Count++] = item;
    }

    /// <summary>Adds items at the end.</summary>
    public void AddRange(ReadOnlySpan<T> range)
    {
        if (range.Length > items.Length - Count)
        {
            Grow(Count + range.Length);
        }

        range.CopyTo(items.AsSpan(Count));
        Count += range.Length;
    }

    /// <summary>A copy of the items.</summary>
    public T[] ToArray() => Items.ToArray();

    /// <summary>Gives the memory back; the list is empty and must not be used again.</summary>
    public void Dispose()
    {
        if (items.Length > 0)
        {
            ArrayPool<T>.Shared.Return(items);
            items = Array.Empty<T>();
            Count = 0;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Check(int index)
    {
        if ((uint)index >= (uint)Count)
        {
            Refuse(index);
        }
    }

    private void Refuse(int index) => throw new ArgumentOutOfRangeException(nameof(index), FormattableString.Invariant($"index {index}; expected 0..{Count - 1}"));

    private void Grow(int min)
    {
        T[] larger = ArrayPool<T>.Shared.Rent(Math.Max(min, 2 * items.Length));
        Items.CopyTo(larger);
        ArrayPool<T>.Shared.Return(items);
        items = larger;
    }
}
