using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of spread wings out of the body.</summary>
internal static class WingGrower
{
    private const int Feathers = 11;
    private const int Fingers = 4;

    private static readonly double[] edgeKnots = { 0, 0.3, 0.52, 0.8, 1 };

    /// <summary>Shares of the span at shoulder, elbow, wrist, hand and tip.</summary>
    private static readonly float[] jointShares = { 0f, 0.28f, 0.53f, 0.78f, 1f };

    /// <summary>Grows the left wing, mirrors it, and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, WingBlueprint wing, int index)
    {
        SurfaceBuilder surface = body.Surface;
        SocketLoop socket = SocketLoop.Cut(body, wing.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        float span = (float)wing.Span;
        bool feathered = wing.Style == WingStyle.Feathered;
        Func<float, Vector3> edge = LeadingEdge(wing, socket);
        float root = 2f * socket.HalfLength;

        Vector3 Trail(float s)
        {
            double turn = ((feathered ? 0.35 : 0.12) * s) + ((feathered ? 0.30 : 0.42) * Scalar.Smooth((s - 0.6) / 0.4));
            var direction = Vec.Normalize(new Vector3((float)PortableMath.Sin(turn), -0.22f - (0.16f * s), -(float)PortableMath.Cos(turn)));
            return edge(s) + (direction * (feathered ? FeatherChord(wing, s, root) : MembraneChord(wing, s, root)));
        }

        Vector3 Normal(float s)
        {
            Vector3 along = edge(Math.Min(s + 0.02f, 1f)) - edge(Math.Max(s - 0.02f, 0f));
            Vector3 n = Vec.Cross(along, -Vector3.UnitZ);
            n = n.Y < 0f ? -n : n;
            return -Vec.Normalize(n, Vector3.UnitY);
        }

        float thickest = Scalar.Clamp(0.10f * (float)wing.Chord, 0.018f, 0.05f);
        var blade = new BladeSweep(edge, Trail)
        {
            Normal = Normal,
            Thickness = (s, u) => feathered ? Thickness(thickest, s, u) : Thickness(thickest, s, u) + FingerRidge(thickest, s, u),
            Sections = feathered ? FeatherSections() : MembraneSections(),
            Blend = 0.14f,
            Crowding = 0.85f,
            Address = new VertexAddress { Region = SurfaceRegion.Wing, Appendage = (short)index, Sign = 1 },
        };
        int[] end = blade.Grow(surface, socket.Vertices);
        blade.Close(surface, end, wing.Socket, Vector3.UnitX);
        surface.MirrorSince(firstVertex, firstFace);

        var joints = Array.ConvertAll(jointShares, s => edge(s) + ((Trail(s) - edge(s)) * (s == 0f ? 0.35f : 0.06f)));
        return WingAppendage.Of(socket.CentreRing, joints, jointShares);
    }

    private static Func<float, Vector3> LeadingEdge(WingBlueprint wing, SocketLoop socket)
    {
        double span = wing.Span;
        double rc = socket.HalfLength;
        double[] x = new double[5];
        double[] y = new double[5];
        double[] z = new double[5];
        double[] rise = { 0, 0.20, 0.42, 0.52, 0.50 };
        double[] ahead = { rc, rc + (0.03 * span), rc + (0.15 * span), rc + (0.11 * span), (rc * 0.5) + (0.045 * span) };
        for (int i = 0; i < 5; i++)
        {
            x[i] = socket.Centre.X + (edgeKnots[i] * span * 0.98);
            y[i] = socket.Centre.Y + (rise[i] * wing.Rise * span * 1.5);
            z[i] = socket.Centre.Z + ahead[i] - (wing.Sweep * span * edgeKnots[i] * 0.6);
        }

        double[] sx = new double[5];
        double[] sy = new double[5];
        double[] sz = new double[5];
        MonotoneCubic.Slopes(edgeKnots, x, sx);
        MonotoneCubic.Slopes(edgeKnots, y, sy);
        MonotoneCubic.Slopes(edgeKnots, z, sz);
        return s => new Vector3(
            (float)MonotoneCubic.Evaluate(edgeKnots, x, sx, s),
            (float)MonotoneCubic.Evaluate(edgeKnots, y, sy, s),
            (float)MonotoneCubic.Evaluate(edgeKnots, z, sz, s));
    }

    private static float MembraneChord(WingBlueprint wing, float s, float root)
    {
        float chord = (float)wing.Chord;
        float depth = Piecewise(s, stackalloc float[] { 0f, 0.12f, 0.35f, 0.6f, 0.85f, 1f }, stackalloc float[] { root, chord * 0.85f, chord, chord * 0.95f, chord * 0.55f, chord * 0.02f });
        if (s <= 0.05f)
        {
            return depth;
        }

        float phase = Scalar.Clamp((s - 0.02f) / 0.98f, 0f, 1f) * Fingers;
        double scallop = PortableMath.Pow(Math.Abs(PortableMath.Sin(PortableMath.Pi * (phase - Math.Floor(phase)))), 0.8);
        return depth * (1f - (0.20f * (float)scallop));
    }

    private static float FeatherChord(WingBlueprint wing, float s, float root)
    {
        float chord = (float)wing.Chord;
        float depth = Piecewise(s, stackalloc float[] { 0f, 0.1f, 0.3f, 0.55f, 0.8f, 0.93f, 1f }, stackalloc float[] { root, chord * 0.72f, chord * 0.82f, chord * 0.9f, chord * 0.85f, chord * 0.62f, chord * 0.25f });
        float tooth = Piecewise(s, stackalloc float[] { 0f, 0.4f, 0.75f, 0.88f, 1f }, stackalloc float[] { 0.06f, 0.10f, 0.28f, 0.28f, 0.08f });
        float phase = (s * Feathers) - (float)Math.Floor(s * Feathers);
        return depth * (1f - (tooth * phase * phase));
    }

    private static float Thickness(float thickest, float s, float u)
    {
        float r = thickest * (1f - (0.65f * s));
        return u < 0.25f
            ? r * (float)Math.Sqrt(Scalar.Clamp(u / 0.12f, 0f, 1f)) * (u < 0.12f ? 1f : 1f - (0.75f * Scalar.Smooth((u - 0.12f) / 0.13f)))
            : r * 0.25f * (1f - (u * 0.75f));
    }

    /// <summary>Fingers stand out of the membrane.</summary>
    private static float FingerRidge(float thickest, float s, float u)
    {
        if (u <= 0.1f || s <= 0.2f)
        {
            return 0f;
        }

        double phase = Scalar.Clamp((s - 0.02) / 0.98, 0, 1) * Fingers;
        double f = phase - Math.Floor(phase);
        f = Math.Min(f, 1 - f) / 0.07;
        return thickest * (1f - (0.65f * s)) * 0.55f * (float)PortableMath.Exp(-f * f) * (1f - (u * 0.6f));
    }

    private static float[] MembraneSections()
    {
        float[] sections = new float[29];
        for (int i = 0; i < sections.Length; i++)
        {
            sections[i] = i / 28f;
        }

        return sections;
    }

    private static float[] FeatherSections()
    {
        var sections = new List<float> { 0f };
        for (int q = 0; q < Feathers; q++)
        {
            foreach (float part in new[] { 0.02f, 0.35f, 0.7f, 0.99f })
            {
                sections.Add((q + part) / Feathers);
            }
        }

        sections[sections.Count - 1] = 1f;
        return sections.ToArray();
    }

    private static float Piecewise(float x, ReadOnlySpan<float> knots, ReadOnlySpan<float> values)
    {
        for (int i = 1; i < knots.Length; i++)
        {
            if (x <= knots[i])
            {
                return Scalar.Lerp(values[i - 1], values[i], (x - knots[i - 1]) / (knots[i] - knots[i - 1]));
            }
        }

        return values[values.Length - 1];
    }
}
