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

/// <summary>
/// Grows a pair of wings that lie folded along the flanks: both edges, and a line between them, ride on the body's skin, so that no body is too round for them.
/// </summary>
internal static class FoldedWingGrower
{
    private const int Feathers = 7;

    /// <summary>Share of the span in which the wing rises off the skin before it slides back.</summary>
    private const double Lifting = 0.1;

    // Parts of its rise by which the wing stands off the skin at its upper and its lower edge and half way between: edges that do are the rims of a hollow shell from behind.
    private const double OffAbove = 0.2;
    private const double OffBelow = 0.12;
    private const double OffBetween = 0.55;

    /// <summary>Part of its rise that it loses to its tip: as thick to its end it is a pod from behind.</summary>
    private const double FlatTip = 0.6;

    // The same of the wrist over what is between the edges, the tip's height over the rump in metres, and the share of the span at which its feathers begin, each of which ends in a step.
    private const double OffWrist = 0.2;
    private const double OffTip = 0.008;
    private const double FirstPrimary = 0.35;

    /// <summary>Rings by which feathers stand out of the rear edge.</summary>
    private const double Tooth = 0.5;

    /// <summary>The last ring that an edge may ride on.</summary>
    private const double LastRing = 52.5;

    private static readonly float[] jointFractions = { 0f, 0.3f, 0.55f, 0.8f, 1f };

    /// <summary>Segments of the lower edge and the shares of the span that they hold for.</summary>
    private static readonly double[] lowerFractions = { 0, 0.15, 0.4, 0.7, 1 };
    private static readonly double[] lowerSegments = { 8.0, 8.6, 8.0, 6.2, 2.3 };

    /// <summary>Grows the left wing, mirrors it, and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, WingBlueprint wing, int index)
    {
        SurfaceBuilder surface = body.Surface;
        SocketLoop socket = SocketLoop.Cut(body, wing.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        BodySkin skin = body.Skin;
        double first = socket.CentreRing;
        double reach = Math.Min(LastRing, skin.Shape.RingAt(BodyShape.At(skin.Shape.Arc, first) + wing.Span)) - first;
        double lift = wing.Rise * wing.Span;

        double Slide(double s) => Math.Max(0, s - 0.02) / 0.98;
        double Stand(double s) => lift * Scalar.Smooth(s / Lifting) * (1 - (FlatTip * s * s));
        double Upper(double s) => wing.Socket.Segment - (1.2 * s) - (2.2 * s * s);
        double Lower(double s) => Stepped(s) + wing.Socket.Segment - 4;
        Vector3 Lead(float s) => Ride(skin, first + (reach * Slide(s)), Upper(s), 0.010 + (OffAbove * Stand(s)) + (OffTip * s * s));
        Vector3 Trail(float s) => Ride(skin, first + (0.93 * reach * Slide(s)) + (Tooth * (Phase(s) - 0.5) * Scalar.Smooth(4 * s)), Lower(s), 0.012 + (OffBelow * Stand(s)) + (OffTip * Scalar.Smooth((s - FirstPrimary) / (1 - FirstPrimary))));
        Vector3 Middle(float s) => Ride(skin, first + (0.97 * reach * Slide(s)), (Upper(s) + Lower(s)) / 2, 0.012 + ((OffBetween + (OffWrist * Wrist(s))) * Stand(s)) + (OffTip * s * s));
        Vector3 Normal(float s) => skin.At(Math.Min(first + (reach * Slide(s)), LastRing), (Upper(s) + Lower(s)) / 2).Normal;

        int quarter = (wing.Socket.Rows + wing.Socket.Columns) / 2;
        int[] loop = Turned(socket.Vertices, socket.Vertices.Length - quarter);
        var blade = new BladeSweep(Lead, Trail)
        {
            Middle = Middle,
            Normal = Normal,
            Thickness = (s, u) => (0.006f + (0.014f * (float)PortableMath.Pow(Math.Max(0, PortableMath.Sin(PortableMath.Pi * u)), 0.6))) * (1f - (0.8f * s)) * Scalar.Smooth((s / 0.1f) + 0.2f),
            Sections = Sections(),
            Blend = (float)Lifting,
            Crowding = 0.85f,
            Address = new VertexAddress { Region = SurfaceRegion.Wing, Appendage = (short)index, Sign = 1 },
        };
        int[] end = Turned(blade.Grow(surface, loop), quarter);
        blade.Close(surface, end, wing.Socket, -Vector3.UnitZ);
        surface.MirrorSince(firstVertex, firstFace);

        Vector3[] joints = Array.ConvertAll(jointFractions, s => Vec.Lerp(Lead(s), Trail(s), s == 0f ? 0.5f : 0.25f));
        return WingAppendage.Of(socket.CentreRing, joints, jointFractions, held: false);
    }

    /// <summary>The point off the skin at a ring and segment, never across the sagittal plane.</summary>
    private static Vector3 Ride(BodySkin skin, double ring, double segment, double off)
    {
        SurfacePoint at = skin.At(Math.Min(ring, LastRing), segment);
        Vector3 p = at.Position + (at.Normal * (float)off);
        p.X = Math.Max(p.X, (float)(0.012 + (0.8 * off)));
        return p;
    }

    private static double Phase(float s) => s < 0.999f ? (s * Feathers) - Math.Floor(s * Feathers) : 0;

    /// <summary>How much of the wrist's bump is at a share of the span, 0..1.</summary>
    private static double Wrist(double s) => Scalar.Smooth(1 - (Math.Abs(s - 0.12) / 0.14));

    /// <summary>Segment of the lower edge, down in a step at the tip of each primary.</summary>
    private static double Stepped(double s)
    {
        double feather = Math.Ceiling((s * Feathers) - 0.01);
        double tip = feather / Feathers;
        double start = (feather - 1) / Feathers;
        return Scalar.Lerp(Piecewise(s), Scalar.Lerp(Piecewise(Math.Max(0, start)), Piecewise(tip), 0.25 * ((s * Feathers) - Math.Floor(s * Feathers))), Scalar.Smooth((s - FirstPrimary) / 0.1));
    }

    private static double Piecewise(double s)
    {
        int i = 1;
        while (i < lowerFractions.Length - 1 && s > lowerFractions[i])
        {
            i++;
        }

        return Scalar.Lerp(lowerSegments[i - 1], lowerSegments[i], (s - lowerFractions[i - 1]) / (lowerFractions[i] - lowerFractions[i - 1]));
    }

    private static int[] Turned(int[] loop, int by)
    {
        int[] turned = new int[loop.Length];
        for (int k = 0; k < turned.Length; k++)
        {
            turned[k] = loop[(k + by) % loop.Length];
        }

        return turned;
    }

    private static float[] Sections()
    {
        var sections = new List<float> { 0f, 0.03f, 0.07f };
        for (int q = 0; q < Feathers; q++)
        {
            foreach (float part in new[] { 0.15f, 0.6f, 0.97f })
            {
                float s = (q + part) / Feathers;
                if (s > 0.075f)
                {
                    sections.Add(s);
                }
            }
        }

        sections[sections.Count - 1] = 1f;
        return sections.ToArray();
    }
}
