using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// The halves of a disc (rays) as rows of joints from the trunk out to the edge, in front, in the middle and behind: what beats is the disc itself. The skin of a body as broad as that
/// follows them the more the farther out it is.
/// </summary>
internal sealed class DiscEdges
{
    /// <summary>How broad a disc is at the least, relative to how thick it is there.</summary>
    private const double MinBreadth = 3;

    /// <summary>Where along the body rows are: the front and the rear one where it is so many times as wide as in the middle, which is where it is widest.</summary>
    private const double FrontWidth = 0.7;
    private const double RearWidth = 0.55;

    /// <summary>Shares of the way from the midline to the edge at which the joints of a row are.</summary>
    private static readonly float[] joints = { 0.26f, 0.6f, 1f };

    /// <summary>Share of that way from which on skin follows the disc, and by how much more it does wholly.</summary>
    private const float Trunk = 0.16f;
    private const float Spread = 0.32f;

    /// <summary>The same of what follows the outer joint.</summary>
    private const float Inner = 0.48f;
    private const float Outward = 0.3f;

    /// <summary>Widths, of the greatest, from which on the narrow ends of the body follow the disc, and where they do wholly.</summary>
    private const double Narrow = 0.3;
    private const double Wide = 0.62;

    /// <summary>Part of the way from row to row on which the skin goes over from one to the next.</summary>
    private const double Blend = 0.8;

    private readonly BodySkin skin;
    private readonly int first;
    private readonly double widest;
    private readonly double[] arcs;

    private DiscEdges(BodySkin skin, int first, double widest, double[] arcs)
    {
        this.skin = skin;
        this.first = first;
        this.widest = widest;
        this.arcs = arcs;
    }

    /// <summary>The rows of a body as appendages that have no surface of their own; none for bodies that are no discs.</summary>
    public static IEnumerable<Appendage> Of(CreatureBlueprint blueprint, BodySkin skin)
    {
        if (!IsDisc(blueprint, skin.Shape, out int middle))
        {
            yield break;
        }

        int pair = 1;
        foreach (int ring in Rings(skin.Shape, middle))
        {
            var points = new Vector3[joints.Length];
            for (int k = 0; k < points.Length; k++)
            {
                points[k] = Inside(skin, ring, joints[k]);
            }

            yield return new Appendage { Kind = LimbKind.Disc, Pair = pair++, Paired = true, RootRing = ring, Joints = points, JointsAlong = joints, Contact = points[points.Length - 1] };
        }
    }

    /// <summary>The rows of a rig, for the weights of its skin; null for bodies that are no discs.</summary>
    public static DiscEdges? In(RigInput input, SpineLine line)
    {
        int first = -1;
        var arcs = new List<double>();
        for (int i = 0; i < input.Appendages.Count; i++)
        {
            if (input.Appendages[i].Kind == LimbKind.Disc)
            {
                first = first < 0 ? i : first;
                arcs.Add(line.ArcAt(input.Appendages[i].RootRing));
            }
        }

        return first < 0 ? null : new DiscEdges(input.Skin, first, input.Skin.Shape.Width[(int)input.Appendages[first + 1].RootRing], arcs.ToArray());
    }

    /// <summary>Who moves a vertex of the left half.</summary>
    /// <param name="position">Where it is, at scale 1.</param>
    /// <param name="ring">Its ring on the body.</param>
    /// <param name="arc">The arc length of that along the spine.</param>
    public DiscShare At(Vector3 position, double ring, double arc)
    {
        double width = skin.Shape.Width[Math.Min(Math.Max((int)(ring + 0.5), 0), BodyGrid.Rings - 1)];
        double across = width > 0 ? Math.Min(position.X / width, 1) : 0;
        double share = Scalar.Smooth((across - Trunk) / Spread) * Scalar.Smooth(((width / widest) - Narrow) / (Wide - Narrow));
        int row = arc < arcs[1] ? 0 : 1;
        double behind = Scalar.Smooth(((((arc - arcs[row]) / (arcs[row + 1] - arcs[row])) - 0.5) / Blend) + 0.5);
        return new DiscShare(first + row, (float)share, (float)behind, (float)Scalar.Smooth((across - Inner) / Outward));
    }

    private static bool IsDisc(CreatureBlueprint blueprint, BodyShape shape, out int middle)
    {
        middle = StationRing.TrunkFirst;
        for (int i = 0; i < StationRing.TailFirst; i++)
        {
            middle = shape.Width[i] > shape.Width[middle] ? i : middle;
        }

        return blueprint.Kind == LocomotionKind.Swimming && blueprint.Body.Disc.Sweep != 0 && shape.Width[middle] > MinBreadth * Math.Max(shape.Top[middle], shape.Bottom[middle]);
    }

    private static int[] Rings(BodyShape shape, int middle)
    {
        int front = middle - 1;
        while (front > 1 && shape.Width[front] > FrontWidth * shape.Width[middle])
        {
            front--;
        }

        int rear = middle + 1;
        while (rear < StationRing.TailFirst && shape.Width[rear] > RearWidth * shape.Width[middle])
        {
            rear++;
        }

        return new[] { front, middle, rear };
    }

    /// <summary>A point inside the disc, a share of the way from the midline to its edge.</summary>
    private static Vector3 Inside(BodySkin skin, int ring, float share)
    {
        Vector3 edge = skin[ring, BodyGrid.Segments / 4];
        Vector3 above = Vector3.Zero;
        Vector3 below = Vector3.Zero;
        float x = share * edge.X;
        for (int j = 1; j < BodyGrid.Segments / 4; j++)
        {
            above = Between(skin[ring, j - 1], skin[ring, j], x, above);
            below = Between(skin[ring, (BodyGrid.Segments / 2) - j + 1], skin[ring, (BodyGrid.Segments / 2) - j], x, below);
        }

        return share >= 1f || above == Vector3.Zero || below == Vector3.Zero ? edge * new Vector3(share, 1f, 1f) : ((above + below) / 2f) with { X = x };
    }

    private static Vector3 Between(Vector3 inner, Vector3 outer, float x, Vector3 found) =>
        inner.X <= x && x <= outer.X ? Vec.Lerp(inner, outer, (x - inner.X) / Math.Max(outer.X - inner.X, 1e-6f)) : found;
}

/// <summary>How the rows of a disc move a vertex.</summary>
/// <param name="Front">Number of the row before it among the appendages; the row behind it is the next.</param>
/// <param name="Share">Of all its weight, 0..1.</param>
/// <param name="Behind">Part of that of the row behind it.</param>
/// <param name="Outer">Part of a row's share of its outer joint.</param>
internal readonly record struct DiscShare(int Front, float Share, float Behind, float Outer);
