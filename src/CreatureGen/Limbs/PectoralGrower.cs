using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of fins or flippers out of the flanks.</summary>
internal static class PectoralGrower
{
    /// <summary>Share of the length over which a fin goes over from its socket to its outline, fast at first: where it comes into it late, its edges have a corner there, and a stalk before it.</summary>
    private const float Rooted = 0.5f;

    // Share of the length from which on the edges draw together, so that no tip is cut off straight, how pointed: 0.5 is half an ellipse, with which a fin is a spoon; and what is left of the chord at its end.
    private const float RoundedFrom = 0.4f;
    private const double Pointed = 0.8;
    private const float Tip = 0.06f;

    /// <summary>Where along the chord they meet: near the leading edge, or the corner behind the tip of a swept fin would be cut off straight.</summary>
    private const float TipChord = 0.3f;

    // Half thickness of a fin at its root in lengths, where along the chord it is thickest, how much thinner it is at its tip, and where along the fin it begins to run out: with a thick end the tip is sawn off.
    private const float Thickness = 0.066f;
    private const float Thickest = 0.3f;
    private const float Thinning = 0.85f;
    private const float RunsOutFrom = 0.5f;
    private const float Thinnest = 0.12f;

    // Rise of the trailing edge for each unit that it lies behind the leading one: of a fin on the flank, turned as in gliding, and of one under the body, which keeps off it. Falling with the axis, a blade on the flank would be a rod from the side; rising no more than the eye looks down, one from behind.
    private const float Pronation = 0.5f;
    private const float UnderBody = -0.35f;

    /// <summary>That of paddles on the flank, whose scalloped rear edge would go through a slender flank.</summary>
    private const float PronationOfPaddle = 0.25f;

    // How far skin faces down from which on, and over which, a fin is one under the body.
    private const float FacesDown = 0.5f;
    private const float Turning = 0.4f;

    // A fin whose trailing edge is not off the flank by a share of its length is turned back, step by step and to this rise at most: at its root first, from where it is turned out over a part of its length, and at most by this rise: a blade that is twisted further is wrung.
    private const float Margin = 0.07f;
    private const float Lowest = -0.55f;
    private const float Step = 0.1f;
    private const float TwistFrom = 0.4f;
    private const float Twist = 0.6f;
    private const float MostTwist = 0.6f;

    /// <summary>Sections along the fin, crowded towards its tip.</summary>
    private const int SectionCount = 17;

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
        FlankFin? form = FlankFin.Of(fin.Style);
        float lean = (float)FlankFin.AxisSweep(fin.Style);
        Vector3 outward = Vec.Normalize(new Vector3(1f, -(float)fin.Drop, -(float)fin.Sweep * lean));
        Vector3 skin = body.Skin.At(socket.CentreRing, fin.Socket.Segment + (fin.Socket.Columns / 2.0)).Normal;
        float rise = Scalar.Lerp(fin.Style == FinStyle.Paddle ? PronationOfPaddle : Pronation, UnderBody, Scalar.Smooth((-skin.Y - FacesDown) / Turning));
        float rootRise = rise;
        Vector3 Back(float s) => Vec.Normalize(Vec.Reject(new Vector3(0f, Scalar.Lerp(rootRise, rise, Scalar.Smooth((s - TwistFrom) / Twist)), -1f), outward));

        // Both edges are lifted off the skin, or a swept fin would dive into the body.
        Vector3 Lift(float s) => skin * (0.13f * length * Scalar.Smooth(s / 0.25f));
        Vector3 Lead(float s) => centre + Lift(s) + (outward * (length * s)) - (Back(s) * Ahead(s));
        Vector3 Trail(float s) => centre + Lift(s) + (skin * (length * 0.20f * Scalar.Smooth(s / 0.15f) * (1f - s))) + (outward * (length * s)) + (Back(s) * Behind(s));
        float Ahead(float s) => (Rounded(s) * (LeadOf(s) + Tipward(s))) - Tipward(s);
        float Behind(float s) => (Rounded(s) * (TrailOf(s) - Tipward(s))) + Tipward(s);
        float Tipward(float s) => Scalar.Lerp(-LeadOf(s), TrailOf(s), TipChord);
        float LeadOf(float s) => form is null
            ? (root * (1f - s)) + (0.05f * length * (float)PortableMath.Sin(PortableMath.Pi * s))
            : Scalar.Lerp(root, -length * Stretch(form) * (float)form.LeadAt(s), Grown(s));
        float TrailOf(float s) => form is null
            ? (root * (1f - s)) + Depth(s)
            : Scalar.Lerp(root, length * Stretch(form) * (float)form.TrailAt(s), Grown(s));
        float Grown(float s)
        {
            float x = Math.Max(0f, 1f - (s / Rooted));
            return 1f - (x * x);
        }

        float Rounded(float s)
        {
            float x = Math.Max(0f, (s - RoundedFrom) / (1f - RoundedFrom));
            return Math.Max(Tip, (float)PortableMath.Pow(1f - (x * x), Pointed));
        }

        float Stretch(FlankFin outline) => width / (float)outline.Depth;
        float Depth(float s)
        {
            double bow = PortableMath.Pow(Math.Max(0, PortableMath.Sin(PortableMath.Pi * Math.Min(1, (s * 0.965) + 0.02))), 0.75);
            return length * width * 0.9f * (float)bow * (1f - (0.12f * (float)Math.Abs(PortableMath.Sin(s * 14))));
        }

        while (Math.Max(rootRise, rise) > Lowest && !FlankClearance.Has(body.Skin, socket.CentreRing, Trail, Margin * length))
        {
            rise = rootRise > Lowest ? rise : Math.Max(Lowest, rise - Step);
            rootRise = Math.Max(Lowest, rootRise - Step);
            rise = Math.Min(rise, rootRise + MostTwist);
        }

        Vector3 Across(float s)
        {
            Vector3 normal = Vec.Cross(outward, Back(s));
            return normal.Y > 0f ? normal : -normal;
        }

        var blade = new BladeSweep(Lead, Trail)
        {
            Normal = s => -Across(s),
            Thickness = (s, u) => length * Thickness * (1f - (Thinning * s)) * RunningOut(s) * Foil(u),
            Sections = Sections(),
            Blend = 0.22f,
            Address = new VertexAddress { Region = SurfaceRegion.Fin, Appendage = (short)index, Sign = 1 },
        };
        int[] end = blade.Grow(surface, socket.Vertices);
        blade.Close(surface, end, fin.Socket, outward);
        surface.MirrorSince(firstVertex, firstFace);

        Vector3 Axis(float s) => Vec.Lerp(Lead(s), Trail(s), 0.35f);
        Vector3[] joints = { centre, Axis(0.5f), Axis(1f) };
        return new Appendage
        {
            Kind = LimbKind.Pectoral,
            Paired = true,
            RootRing = socket.CentreRing,
            Joints = joints,
            JointsAlong = new[] { 0f, 0.5f, 1f },
            Pole = Back(0.5f),
            Contact = joints[2],
        };
    }

    /// <summary>Thickness over the chord, relative to the greatest: drawn out behind.</summary>
    private static float Foil(float u) => u < Thickest ? 1f : 1f - (0.9f * Scalar.Smooth((u - 0.2f) / 0.5f));

    /// <summary>Thickness along the fin, relative to one that does not run out.</summary>
    private static float RunningOut(float s)
    {
        float x = Math.Max(0f, (s - RunsOutFrom) / (1f - RunsOutFrom));
        return Math.Max(Thinnest, (float)Math.Sqrt(1f - (x * x)));
    }

    private static float[] Sections()
    {
        float[] sections = new float[SectionCount];
        for (int i = 0; i < sections.Length; i++)
        {
            sections[i] = 1f - (float)PortableMath.Pow(1 - (i / (sections.Length - 1.0)), 1.5);
        }

        return sections;
    }
}
