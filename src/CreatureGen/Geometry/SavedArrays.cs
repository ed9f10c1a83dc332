using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>Arrays of numbers that can be put back to what they were. What is kept lies in memory borrowed from the pool, which disposing gives back.</summary>
internal sealed class SavedArrays : IDisposable
{
    private readonly Array[] values;
    private byte[] saved = Array.Empty<byte>();

    /// <summary>Takes the arrays; nothing is kept yet.</summary>
    public SavedArrays(params Array[] values) => this.values = values;

    /// <summary>Keeps the values as they are.</summary>
    public void Save()
    {
        if (saved.Length == 0)
        {
            int length = 0;
            foreach (Array array in values)
            {
                length += Buffer.ByteLength(array);
            }

            saved = ArrayPool<byte>.Shared.Rent(length);
        }

        int at = 0;
        foreach (Array array in values)
        {
            Buffer.BlockCopy(array, 0, saved, at, Buffer.ByteLength(array));
            at += Buffer.ByteLength(array);
        }
    }

    /// <summary>Puts the values back to what they were when they were kept.</summary>
    public void Restore()
    {
        int at = 0;
        foreach (Array array in values)
        {
            Buffer.BlockCopy(saved, at, array, 0, Buffer.ByteLength(array));
            at += Buffer.ByteLength(array);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (saved.Length > 0)
        {
            ArrayPool<byte>.Shared.Return(saved);
            saved = Array.Empty<byte>();
        }
    }
}
