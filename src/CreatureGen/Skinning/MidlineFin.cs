using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// A fin on the back or the belly. It bends about one joint, but the body below it bends everywhere. A short fin is one piece; of a fin much longer than the bones below it only the part
/// around the joint is, and the rest follows the body where it stands.
/// </summary>
internal sealed class MidlineFin
{
    /// <summary>Half length of the base in bones up to which a fin is one piece.</summary>
    private const double ShortFin = 2;

    /// <summary>Half length of the base in bones from which on only the part around the joint is.</summary>
    private const double LongFin = 5;

    private readonly double root;
    private readonly double reach;

    private MidlineFin(double root, double reach)
    {
        this.root = root;
        this.reach = reach;
    }

    /// <summary>Measures the fins on the midline; one entry per appendage, null for all others.</summary>
    public static MidlineFin?[] Measure(RigInput input, Rig rig)
    {
        int count = input.Appendages.Count;
        var fins = new MidlineFin?[count];
        float[] first = new float[count];
        float[] last = new float[count];
        Array.Fill(first, BodyGrid.Rings);
        foreach (VertexAddress address in input.Surface.Addresses)
        {
            int a = address.Appendage;
            if (a >= 0 && !input.Appendages[a].Paired)
            {
                first[a] = Math.Min(first[a], address.Ring);
                last[a] = Math.Max(last[a], address.Ring);
            }
        }

        for (int a = 0; a < count; a++)
        {
            if (first[a] < BodyGrid.Rings)
            {
                double root = rig.Line.ArcAt(input.Appendages[a].RootRing);
                int bone = rig.Spine.BoneOf(rig.Spine.At(root).Dominant);
                double length = Math.Max(rig.Spine.End(bone) - rig.Spine.Start(bone), 1e-6);
                double half = (rig.Line.ArcAt(last[a]) - rig.Line.ArcAt(first[a])) / 2;
                fins[a] = new MidlineFin(root, length * (3 - (2 * Scalar.Smooth(((half / length) - ShortFin) / (LongFin - ShortFin)))));
            }
        }

        return fins;
    }

    /// <summary>
    /// The ring (fractional) in whose plane a point of a fin lies. The tip of a swept fin stands over other rings than its base; columns that meet at the tip must move as one.
    /// </summary>
    /// <param name="shape">The sections.</param>
    /// <param name="position">The point, model space.</param>
    /// <param name="start">Ring of the fin's base below the point, where the search starts.</param>
    public static double RingOf(BodyShape shape, Vector3 position, double start)
    {
        int ring = (int)Scalar.Clamp(start, 0, BodyGrid.Rings - 2);
        float here = Ahead(shape, position, ring);
        while (here < 0f && ring < BodyGrid.Rings - 2 && Ahead(shape, position, ring + 1) < 0f)
        {
            here = Ahead(shape, position, ++ring);
        }

        while (here > 0f && ring > 0)
        {
            here = Ahead(shape, position, --ring);
        }

        float next = Ahead(shape, position, ring + 1);
        return ring + Scalar.Clamp(here / (double)Math.Min(here - next, -1e-9f), 0, 1);
    }

    /// <summary>Share of the fin's own joints at an arc length of the spine: all within half the reach of the root, none beyond one and a half.</summary>
    public float HoldAt(double arc) => 1f - (float)Scalar.Smooth((Math.Abs(arc - root) / reach) - 0.5);

    /// <summary>How far a point lies ahead of a ring's plane.</summary>
    private static float Ahead(BodyShape shape, Vector3 position, int ring) => Vec.Dot(position - shape.Centre(ring), shape.Forward(ring));
}
