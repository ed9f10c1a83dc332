using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>A face of the surface prepared for painting: its corners as places, in the picture and in anatomy.</summary>
internal struct ChartFace
{
    /// <summary>The four corners as places; a triangle repeats its third.</summary>
    public TexelPlace A, B, C, D;

    /// <summary>The corners in the picture, 0..1.</summary>
    public Vector2 PictureA, PictureB, PictureC, PictureD;

    /// <summary>The regions of the corners.</summary>
    public SurfaceRegion RegionA, RegionB, RegionC, RegionD;

    /// <summary>The appendage of the corners that have one, else −1.</summary>
    public short Appendage;

    /// <summary>Prepares a face.</summary>
    public static ChartFace Of(Surface surface, ChartPacking packing, int face, VertexCoat coat)
    {
        Face f = surface.Faces[face];
        FaceTexcoords t = surface.Texcoords[face];
        VertexAddress[] addresses = surface.Addresses;
        var result = new ChartFace
        {
            PictureA = packing.Map(f.Chart, t.A),
            PictureB = packing.Map(f.Chart, t.B),
            PictureC = packing.Map(f.Chart, t.C),
            PictureD = packing.Map(f.Chart, t.D),
            RegionA = addresses[f.A].Region,
            RegionB = addresses[f.B].Region,
            RegionC = addresses[f.C].Region,
            RegionD = addresses[f.D].Region,
            Appendage = Math.Max(Math.Max(addresses[f.A].Appendage, addresses[f.B].Appendage), Math.Max(addresses[f.C].Appendage, addresses[f.D].Appendage)),
        };
        float around = AroundOf(addresses, f);
        result.A = Place(f.A, t.A);
        result.B = Place(f.B, t.B);
        result.C = Place(f.C, t.C);
        result.D = Place(f.D, t.D);
        return result;

        TexelPlace Place(int vertex, Vector2 chart)
        {
            VertexAddress address = addresses[vertex];
            bool rooted = result.Appendage >= 0 && address.Appendage < 0;
            float segment = Math.Abs(address.Segment);
            CoatRange range = coat.RangeOf(vertex);
            return new TexelPlace
            {
                Position = coat.PositionOf(vertex),
                Normal = coat.NormalOf(vertex),
                Plain = range.Plain,
                Patterned = range.Patterned,
                Run = range.Place.Run,
                Girth = range.Place.Around,
                Chart = chart,
                Ring = address.Ring,
                Segment = Math.Min(segment, BodyGrid.Segments - segment),

                // The border of a socket is where its appendage begins; its own place along the body says nothing here.
                Along = rooted ? 0f : address.Along,
                Around = rooted ? around : Unwrapped(address.Around, around),
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
