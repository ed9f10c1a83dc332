using System.Collections;
using System.Collections.Generic;
using System.Threading;

namespace CreatureGen.Console.Working;

/// <summary>A list that refuses to give more once work is stopped: so whoever works through it leaves off between two items.</summary>
/// <param name="items">What is in it.</param>
/// <param name="cancellation">Stops whoever reads it, with an <see cref="System.OperationCanceledException"/>.</param>
internal sealed class StoppableList<T>(IReadOnlyList<T> items, CancellationToken cancellation) : IReadOnlyList<T>
{
    /// <inheritdoc/>
    public int Count => items.Count;

    /// <inheritdoc/>
    public T this[int index]
    {
        get
        {
            cancellation.ThrowIfCancellationRequested();
            return items[index];
        }
    }

    /// <inheritdoc/>
    public IEnumerator<T> GetEnumerator()
    {
        for (int i = 0; i < items.Count; i++)
        {
            yield return this[i];
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
