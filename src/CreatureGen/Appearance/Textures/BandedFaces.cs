using System;
using CreatureGen.Geometry;

namespace CreatureGen.Appearance.Textures;

/// <summary>Faces to be painted, and which of them each band of rows of a picture may hold texels of: each face has half a kilobyte, and to look through all of them for each band takes as long as painting a tenth of the picture.</summary>
internal sealed class BandedFaces : IDisposable
{
    private readonly int size;
    private readonly PooledList<ChartFace> faces;
    private readonly PooledList<int>[] bands = new PooledList<int>[RowBand.Count];

    /// <summary>No faces yet.</summary>
    /// <param name="size">Texels along a side of the picture.</param>
    /// <param name="capacity">How many faces there will be about.</param>
    public BandedFaces(int size, int capacity)
    {
        this.size = size;
        faces = new PooledList<ChartFace>(capacity);
        for (int band = 0; band < bands.Length; band++)
        {
            bands[band] = new PooledList<int>(capacity / 4);
        }
    }

    /// <summary>Does something with a face.</summary>
    public delegate void FaceAction(in ChartFace face);

    /// <summary>Adds a face.</summary>
    public void Add(in ChartFace face)
    {
        for (int band = 0; band < bands.Length; band++)
        {
            if (face.Touches(size, RowBand.Of(size, band)))
            {
                bands[band].Add(faces.Count);
            }
        }

        faces.Add(face);
    }

    /// <summary>Does something with each face of a band, in the order in which they were added.</summary>
    public void ForEach(int band, FaceAction action)
    {
        ReadOnlySpan<ChartFace> all = faces.Items;
        foreach (int face in bands[band].Items)
        {
            action(all[face]);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        faces.Dispose();
        foreach (PooledList<int> band in bands)
        {
            band.Dispose();
        }
    }
}
