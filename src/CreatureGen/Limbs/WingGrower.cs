using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of spread wings out of the body.</summary>
internal static class WingGrower
{
    /// <summary>How far a finger stands out of its membrane to either side, in spans.</summary>
    private const double FingerWidth = 0.02;

    /// <summary>Share of the span over which the depth of the root goes over into that of the wing.</summary>
    private const float Rooted = 0.1f;

    /// <summary>Last ring of the flank that a membrane is held by, and the most that it reaches along it, in depths of the wing.</summary>
    private const int Hip = 40;
    private const double MaxHeld = 1.15;

    /// <summary>Share of the span over which the edge of a membrane leaves the hip.</summary>
    private const float Leaving = 0.24f;

    /// <summary>Segments by which a membrane is held higher at the hip than at the shoulder.</summary>
    private const double AboveThigh = 2.2;

    /// <summary>How far a membrane stands off the flank that holds it, at the shoulder and at the hip, metres.</summary>
    private const float OffFlank = 0.012f;
    private const float OffHip = 0.022f;

    /// <summary>How far the feathers of the tip point outwards, radians.</summary>
    private const double FeatherTurn = 0.35;

    /// <summary>Columns of the cap at the tip, which is thin however high the root is.</summary>
    private const int TipColumns = 2;

    /// <summary>Least depth of a wing, relative to its greatest: a tip of no depth has no area.</summary>
    private const float MinDepth = 0.03f;

    // Radians by which the depth of a wing falls to the rear at its root, and by how much more at its tip.
    private const double RootFall = 0.36;
    private const double TipFall = 0.16;

    // By how much more the root of feathers falls than that in flight too, radians, and the share of the span over which that is twisted out: level at its root, a wing is its own edge from ahead there. The root of a membrane falls as the flank holds it; twisted against that, it is crowded where it folds.
    private const double Washout = 0.2;
    private const float WashedOut = 0.5f;

    // Share of the span over which it comes to hang as it does at rest, and from which on beyond the elbow.
    private const float Hung = 0.12f;
    private const float OuterHung = 0.2f;
    private const float WhollyOuterHung = 0.7f;

    private const int MembraneRows = 28;

    // The muscles of the shoulder: half their height at the socket in its half widths, the share of the span over which they run out, and the share of the depth at which they are thickest. Without them an arm is a rod plugged into the trunk.
    private const float MuscleHeight = 1.8f;
    private const float Muscled = 0.36f;
    private const float FullestMuscle = 0.3f;

    // Where across its width a feather is longest, and what of the notch outside of it the one inside of it is: cut off straight on one side feathers are the teeth of a saw.
    private const float FeatherTip = 0.35f;
    private const float InnerNotch = 0.4f;

    // Over how many of the outermost feathers the end of a wing is rounded: over less, between two chord lines, it is cut off square.
    private const float RoundTip = 0.8f;

    /// <summary>Chord lines of one feather, in its widths: four, or three where there are many.</summary>
    private static readonly float[] dense = { 0.02f, 0.35f, 0.7f, 0.99f };
    private static readonly float[] sparse = { 0.02f, 0.5f, 0.99f };

    /// <summary>The edge along which the bones of all wings lie.</summary>
    private static readonly WingForm arm = new() { Stations = new[] { 0, 0.1, 0.3, 0.52, 0.8, 0.93, 1 }, Lead = new[] { 0, 0.01, 0.03, 0.15, 0.11, 0.075, 0.045 } };

    /// <summary>Height of the leading edge over the span, for a rise of 1: an upper arm that hardly rises, a forearm that rises steeply, and a hand that goes on rising to the tip, or it is a cap cut off level from the side.</summary>
    private static readonly MonotoneCurve rise = new(new[] { 0, 0.14, 0.28, 0.36, 0.48, 0.56, 0.8, 1 }, new[] { 0, 0.08, 0.18, 0.30, 0.57, 0.67, 0.86, 0.95 });

    /// <summary>Shares of the span at shoulder, elbow, wrist, hand and tip.</summary>
    private static readonly float[] jointFractions = { 0f, 0.28f, 0.53f, 0.78f, 1f };

    /// <summary>Grows the left wing, mirrors it, and says where its joints are.</summary>
    /// <param name="body">What it grows out of.</param>
    /// <param name="wing">The wing.</param>
    /// <param name="index">Its place among the limbs.</param>
    /// <param name="free">Rings of the flank from the wing's to here are free: the next wings, or thighs, begin behind.</param>
    public static Appendage Grow(BodySurface body, WingBlueprint wing, int index, int free)
    {
        SurfaceBuilder surface = body.Surface;
        SocketLoop socket = SocketLoop.Cut(body, wing.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        WingForm form = WingForm.Of(wing.Style);
        Func<float, Vector3> edge = LeadingEdge(wing, form, socket);
        Func<float, Vector3> bones = LeadingEdge(wing, arm, socket);
        float root = 2f * socket.HalfLength;

        // An arm on a socket that is only long has no shoulder: it carries nothing.
        float shoulder = wing.Socket.Columns > TipColumns ? 1f : 0f;
        double washout = form.Feathers > 0 ? shoulder * Washout : 0;

        BodyShape shape = body.Skin.Shape;
        double start = wing.Socket.Ring + wing.Socket.Rows;
        double end = Math.Min(Math.Min(Hip, free), shape.RingAt(BodyShape.At(shape.Arc, start) + (MaxHeld * wing.Chord)));
        double middle = wing.Socket.Segment + (wing.Socket.Columns / 2.0);

        // A membrane is held by the flank as far as the hip; feathers leave it at the shoulder.
        Vector3 Trail(float s)
        {
            if (form.Feathers > 0 || end <= start || s >= Leaving)
            {
                return Open(s);
            }

            double held = Math.Min(1, s / Rooted);
            SurfacePoint flank = body.Skin.At(Scalar.Lerp(start, end, held), middle - (AboveThigh * held));
            return Vec.Lerp(flank.Position + (flank.Normal * Scalar.Lerp(OffFlank, OffHip, (float)held)), Open(s), Scalar.Smooth((s - Rooted) / (Leaving - Rooted)));
        }

        // Between its edges it goes round a body that is thicker there.
        Vector3 Middle(float s)
        {
            Vector3 straight = (edge(s) + Trail(s)) / 2f;
            if (form.Feathers > 0 || end <= start || s >= Leaving)
            {
                return straight;
            }

            double held = Math.Min(1, s / Rooted) / 2;
            SurfacePoint flank = body.Skin.At(Scalar.Lerp(start, end, held), middle - (AboveThigh * held));
            Vector3 off = flank.Position + (flank.Normal * (2f * OffHip));
            straight.X = Math.Max(straight.X, off.X);
            return straight;
        }

        Vector3 Open(float s) => edge(s) + (Back(s) * Scalar.Lerp(root, DepthAt(wing, form, s), Scalar.Smooth(s / Rooted)));

        Vector3 whole = edge(1f) - edge(0f);
        Vector3 off = Vec.Normalize(new Vector3(whole.Y, -whole.X, 0f), -Vector3.UnitY);
        Vector3 Along(float s) => edge(Math.Min(s + 0.02f, 1f)) - edge(Math.Max(s - 0.02f, 0f));

        // It falls off its own plane, not off the level: a raised wing that hung straight down would be the line of its edge from the front.
        Vector3 Back(float s)
        {
            double turn = form.Feathers > 0 ? FeatherTurn * s : 0;
            double incidence = (washout * (1 - Scalar.Smooth(s / WashedOut))) + (WingForm.RestIncidence * Scalar.Smooth(s / Hung)) + (WingForm.OuterIncidence * Scalar.Smooth((s - OuterHung) / (WhollyOuterHung - OuterHung)));
            PortableMath.SinCos(RootFall + (TipFall * s) + incidence, out double down, out double level);
            return (Vec.Lerp(-Vector3.UnitY, off, Scalar.Smooth(s / Hung)) * (float)down) + new Vector3((float)(level * PortableMath.Sin(turn)), 0f, -(float)(level * PortableMath.Cos(turn)));
        }

        Vector3 Normal(float s) => -Vec.Normalize(Vec.Cross(Along(s), Vec.Lerp(-Vector3.UnitZ, Back(s), Scalar.Smooth(s / Hung))), Vector3.UnitY);

        // Bones lie along an arm that hardly bends, behind whatever edge is in front of them, so that all wings fold alike.
        Vector3 Joint(float s)
        {
            Vector3 bone = edge(s);
            bone.Z = Math.Min(bone.Z, Scalar.Lerp(edge(0f).Z, bones(s).Z, (float)Math.Min(1, form.Depth / HenWing.Form.Depth)));
            return bone + ((Trail(s) - edge(s)) * (s == 0f ? 0.35f : 0.06f));
        }

        float thickest = Scalar.Clamp(0.10f * (float)wing.Chord, 0.018f, 0.05f);
        var blade = new BladeSweep(edge, Trail)
        {
            Normal = Normal,
            Middle = Middle,
            Thickness = (s, u) => Math.Max(Thickness(thickest, s, u), Muscle(shoulder * socket.HalfWidth, s, u)) + FingerRidge(form, thickest, s, u),
            Sections = form.Feathers > 0 ? FeatherSections(form.Feathers) : MembraneSections(form),
            Blend = 0.14f,
            Crowding = 0.85f,
            Address = new VertexAddress { Region = SurfaceRegion.Wing, Appendage = (short)index, Sign = 1 },
        };
        int[] tip = blade.Grow(surface, socket.Vertices);
        blade.Close(surface, tip, wing.Socket with { Rows = wing.Socket.Rows + wing.Socket.Columns - TipColumns, Columns = TipColumns }, Vector3.UnitX);
        surface.MirrorSince(firstVertex, firstFace);

        var joints = Array.ConvertAll(jointFractions, s => Joint(s));
        return WingAppendage.Of(socket.CentreRing, joints, jointFractions, form.Feathers == 0);
    }

    private static Func<float, Vector3> LeadingEdge(WingBlueprint wing, WingForm form, SocketLoop socket)
    {
        double span = wing.Span;
        return s => new Vector3(
            (float)(socket.Centre.X + (s * span * 0.98)),
            (float)(socket.Centre.Y + (rise.At(s) * wing.Rise * span)),
            (float)(socket.Centre.Z + (socket.HalfLength * (1 - (0.5 * s))) + ((form.LeadAt(s) - form.LeadAt(0)) * span) - (wing.Sweep * span * s * 0.6)));
    }

    /// <summary>Depth of the wing at a share of its span, the notches between its feathers taken off, metres.</summary>
    private static float DepthAt(WingBlueprint wing, WingForm form, float s)
    {
        float depth = Math.Max((float)(wing.Chord * (form.LeadAt(s) - form.TrailAt(s)) / form.Depth), MinDepth * (float)wing.Chord);
        if (form.Feathers == 0)
        {
            return depth;
        }

        float slots = (float)form.Slots;
        float tooth = Piecewise(s, stackalloc float[] { 0f, 0.4f, 0.75f, 0.9f, 1f }, stackalloc float[] { 0.05f, 0.08f, slots, slots, 0.06f });
        float phase = (s * form.Feathers) - (float)Math.Floor(s * form.Feathers);
        float off = phase < FeatherTip ? (FeatherTip - phase) / FeatherTip : (phase - FeatherTip) / (1f - FeatherTip);
        float feathered = depth * (1f - ((phase < FeatherTip ? InnerNotch : 1f) * tooth * off * off));

        // The outermost feather is rounded at its tip.
        float last = Math.Max(1f - ((1f - s) * form.Feathers / RoundTip), 0f);
        return Math.Max(feathered * (float)Math.Sqrt(1f - (last * last)), MinDepth * (float)wing.Chord);
    }

    private static float Thickness(float thickest, float s, float u)
    {
        float r = thickest * (1f - (0.65f * s));
        return u < 0.25f
            ? r * (float)Math.Sqrt(Scalar.Clamp(u / 0.12f, 0f, 1f)) * (u < 0.12f ? 1f : 1f - (0.75f * Scalar.Smooth((u - 0.12f) / 0.13f)))
            : r * 0.25f * (1f - (u * 0.75f));
    }

    /// <summary>Half thickness of the muscles that run from the trunk out over the upper arm, metres.</summary>
    private static float Muscle(float halfWidth, float s, float u)
    {
        float left = Math.Max(1f - (s / Muscled), 0f);
        float ahead = Math.Max(1f - (u / FullestMuscle), 0f);
        float across = (float)Math.Sqrt(1f - (ahead * ahead)) * (1f - Scalar.Smooth((u - FullestMuscle) / (1f - FullestMuscle)));
        return MuscleHeight * halfWidth * left * left * across;
    }

    /// <summary>Fingers stand out of the membrane.</summary>
    private static float FingerRidge(WingForm form, float thickest, float s, float u)
    {
        if (form.Digits.Length == 0 || u <= 0.1f || s <= 0.2f)
        {
            return 0f;
        }

        double f = form.FromFingers(s, Scalar.Lerp(form.LeadAt(s), form.TrailAt(s), u)) / FingerWidth;
        return thickest * (1f - (0.65f * s)) * 0.9f * (float)PortableMath.Exp(-f * f) * (1f - (u * 0.5f));
    }

    /// <summary>Even ones, and one at the tip of each finger, or ridges and corners would miss each other.</summary>
    private static float[] MembraneSections(WingForm form)
    {
        var sections = new List<float>();
        for (int i = 0; i <= MembraneRows; i++)
        {
            sections.Add(i / (float)MembraneRows);
        }

        foreach (WingPoint tip in form.Tips)
        {
            int nearest = 1;
            for (int i = 2; i < MembraneRows; i++)
            {
                nearest = Math.Abs(sections[i] - tip.X) < Math.Abs(sections[nearest] - tip.X) ? i : nearest;
            }

            sections[nearest] = tip.X > Rooted && tip.X < 1 ? (float)tip.X : sections[nearest];
        }

        return sections.ToArray();
    }

    private static float[] FeatherSections(int feathers)
    {
        var sections = new List<float> { 0f };
        for (int q = 0; q < feathers; q++)
        {
            foreach (float part in feathers > 11 ? sparse : dense)
            {
                sections.Add((q + part) / feathers);
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
