using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of fins or flippers out of the flanks.</summary>
internal static class PectoralGrower
{
    /// <summary>Grows the left fin, mirrors it, and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, FinBlueprint fin, int index)
    {
        SurfaceBuilder surface = body.Surface;
        SocketLoop socket = SocketLoop.Cut(body, fin.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        float length = (float)fin.Length;
        float width = (float)fin.Width;
        Vector3 centre = socket.Centre;
        float root = socket.HalfLength;
        Vector3 outward = Vec.Normalize(new Vector3(1f, -(float)fin.Drop, -(float)fin.Sweep));
        Vector3 back = Vec.Normalize(Vec.Reject(new Vector3(0f, -0.35f, -1f), outward));
        Vector3 normal = Vec.Cross(outward, back);
        normal = normal.Y > 0f ? normal : -normal;
        Vector3 skin = body.Skin.At(socket.CentreRing, fin.Socket.Segment + (fin.Socket.Columns / 2.0)).Normal;

        // Both edges are lifted off the skin, or a swept fin would dive into the body.
        Vector3 Lift(float s) => skin * (0.13f * length * Scalar.Smooth(s / 0.25f));
        Vector3 Lead(float s) => centre + Lift(s) + (outward * (length * s)) - (back * ((root * (1f - s)) + (0.05f * length * (float)PortableMath.Sin(PortableMath.Pi * s))));
        Vector3 Trail(float s) => centre + Lift(s) + (skin * (length * 0.20f * Scalar.Smooth(s / 0.15f) * (1f - s))) + (outward * (length * s)) + (back * ((root * (1f - s)) + Depth(s)));
        float Depth(float s)
        {
            double bow = PortableMath.Pow(Math.Max(0, PortableMath.Sin(PortableMath.Pi * Math.Min(1, (s * 0.93) + 0.02))), 0.75);
            return length * width * 0.9f * (float)bow * (1f - (0.12f * (float)Math.Abs(PortableMath.Sin(s * 14))));
        }

        var blade = new BladeSweep(Lead, Trail)
        {
            Normal = _ => -normal,
            Thickness = (s, u) => (u < 0.3f ? 0.022f : 0.022f * (1f - (0.85f * Scalar.Smooth((u - 0.2f) / 0.6f)))) * (1f - (0.7f * s)) * (length / 0.3f),
            Sections = Sections(),
            Blend = 0.22f,
            Address = new VertexAddress { Region = SurfaceRegion.Fin, Appendage = (short)index, Sign = 1 },
        };
        int[] end = blade.Grow(surface, socket.Vertices);
        blade.Close(surface, end, fin.Socket, outward);
        surface.MirrorSince(firstVertex, firstFace);

        Vector3 Middle(float s) => Vec.Lerp(Lead(s), Trail(s), 0.35f);
        Vector3[] joints = { centre, Middle(0.5f), Middle(1f) };
        return new Appendage
        {
            Kind = LimbKind.Pectoral,
            Paired = true,
            RootRing = socket.CentreRing,
            Joints = joints,
            JointsAlong = new[] { 0f, 0.5f, 1f },
            Pole = back,
            Contact = joints[2],
        };
    }

    private static float[] Sections()
    {
        float[] sections = new float[13];
        for (int i = 0; i < sections.Length; i++)
        {
            sections[i] = i / 12f;
        }

        return sections;
    }
}
