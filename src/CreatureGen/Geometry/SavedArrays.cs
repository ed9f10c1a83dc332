using System;

namespace CreatureGen.Geometry;

/// <summary>Arrays that can be put back to what they were.</summary>
internal sealed class SavedArrays
{
    private readonly Array[] values;
    private readonly Array[] saved;

    /// <summary>Takes the arrays and keeps their values as they are.</summary>
    public SavedArrays(params Array[] values)
    {
        this.values = values;
        saved = Array.ConvertAll(values, a => (Array)a.Clone());
    }

    /// <summary>Keeps the values as they are.</summary>
    public void Save() => Copy(values, saved);

    /// <summary>Puts the values back to what they were when they were kept.</summary>
    public void Restore() => Copy(saved, values);

    private static void Copy(Array[] from, Array[] to)
    {
        for (int i = 0; i < from.Length; i++)
        {
            Array.Copy(from[i], to[i], from[i].Length);
        }
    }
}
