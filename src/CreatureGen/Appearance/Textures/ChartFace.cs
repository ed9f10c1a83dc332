using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>A face of the surface prepared for painting: its corners as places, in the picture and in anatomy.</summary>
internal struct ChartFace
{
    /// <summary>The four corners; a triangle repeats its third.</summary>
    public ChartCorner A, B, C, D;

    /// <summary>The appendage of the corners that have one, else −1.</summary>
    public short Appendage;

    /// <summary>Whether some rows of a picture of so many texels a side may hold texels of the face.</summary>
    public readonly bool Touches(int size, RowBand rows)
    {
        float top = Math.Min(Math.Min(A.Picture.Y, B.Picture.Y), Math.Min(C.Picture.Y, D.Picture.Y)) * size;
        float bottom = Math.Max(Math.Max(A.Picture.Y, B.Picture.Y), Math.Max(C.Picture.Y, D.Picture.Y)) * size;
        return top <= rows.End + 1f && bottom >= rows.Top - 1f;
    }

    /// <summary>Prepares a face.</summary>
    public static ChartFace Of(Surface surface, ChartPacking packing, int face, VertexCoat coat)
    {
        Face f = surface.Faces[face];
        FaceTexcoords t = surface.Texcoords[face];
        VertexAddress[] addresses = surface.Addresses;
        short appendage = Math.Max(Math.Max(addresses[f.A].Appendage, addresses[f.B].Appendage), Math.Max(addresses[f.C].Appendage, addresses[f.D].Appendage));
        float around = AroundOf(addresses, f);
        return new ChartFace
        {
            A = Corner(f.A, t.A),
            B = Corner(f.B, t.B),
            C = Corner(f.C, t.C),
            D = Corner(f.D, t.D),
            Appendage = appendage,
        };

        ChartCorner Corner(int vertex, Vector2 chart)
        {
            VertexAddress address = addresses[vertex];
            CoatRange range = coat.RangeOf(vertex);
            float segment = Math.Abs(address.Segment);
            segment = Math.Min(segment, BodyGrid.Segments - segment);

            // The border of a socket is where its appendage begins; its own place along the body says nothing here.
            bool rooted = appendage >= 0 && address.Appendage < 0;
            return new ChartCorner
            {
                Picture = packing.Map(f.Chart, chart),
                Openness = coat.OpennessOf(vertex),
                Region = address.Region,
                PositionAndRing = new Vector4(coat.PositionOf(vertex), address.Ring),
                ChartAndTurns = new Vector4(chart.X, chart.Y, segment, rooted ? around : Unwrapped(address.Around, around)),
                PlainAndRun = new Vector4(range.Plain, range.Place.Run),
                PatternedAndGirth = new Vector4(range.Patterned, range.Place.Around),
                PlainUndercoatAndAlong = new Vector4(range.PlainUndercoat, rooted ? 0f : address.Along),
                PatternedUndercoatAndGrain = new Vector4(range.PatternedUndercoat, range.Grain),
            };
        }
    }

    private static float AroundOf(VertexAddress[] addresses, Face f)
    {
        ReadOnlySpan<int> corners = stackalloc int[] { f.A, f.B, f.C, f.D };
        foreach (int corner in corners)
        {
            if (addresses[corner].Appendage >= 0)
            {
                return addresses[corner].Around;
            }
        }

        return addresses[f.A].Around;
    }

    /// <summary>The same angle within half a turn of another, so that nothing between the two runs the long way round.</summary>
    private static float Unwrapped(float angle, float near)
    {
        const float Tau = (float)PortableMath.Tau;
        return angle - near > Tau / 2f ? angle - Tau : near - angle > Tau / 2f ? angle + Tau : angle;
    }
}
