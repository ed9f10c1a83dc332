using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Anatomy.Feet;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>What a limb's end may carry.</summary>
internal enum DigitTipKind
{
    /// <summary>A claw, as long as the blueprint says.</summary>
    Claw,

    /// <summary>A flat nail.</summary>
    Nail,

    /// <summary>A toe of its own that points back and ends in a claw; its claw length is that of the toe.</summary>
    Hallux,
}

/// <summary>A web between two toes. Left side, model space, metres at scale 1.</summary>
/// <param name="Root">Where the toes part.</param>
/// <param name="First">How far it reaches along the first toe.</param>
/// <param name="Second">How far it reaches along the second one.</param>
/// <param name="Thickness">Half of it.</param>
/// <param name="Vertex">A vertex of the surface at a toe, whose weights it takes.</param>
/// <param name="Floor">Height that it stays above; negative infinity for a free foot.</param>
internal readonly record struct ToeWeb(Vector3 Root, Vector3 First, Vector3 Second, float Thickness, int Vertex, float Floor);

/// <summary>What the ends of limbs carry, collected while they grow.</summary>
internal sealed class LimbEnds
{
    public List<DigitTip> Tips { get; } = new();

    public List<ToeWeb> Webs { get; } = new();
}

/// <summary>The end of a toe, finger or tip, where a claw can sit. Left side, model space, metres at scale 1.</summary>
internal readonly struct DigitTip
{
    public DigitTip(DigitTipKind kind, Vector3 position, Vector3 direction, float radius, float clawLength, int vertex)
    {
        Kind = kind;
        Position = position;
        Direction = direction;
        Radius = radius;
        ClawLength = clawLength;
        Vertex = vertex;
    }

    public DigitTipKind Kind { get; }

    public Vector3 Position { get; }

    /// <summary>Unit.</summary>
    public Vector3 Direction { get; }

    public float Radius { get; }

    /// <summary>In radii; 0 for none.</summary>
    public float ClawLength { get; }

    /// <summary>A vertex of the surface at the tip, whose weights the claw takes.</summary>
    public int Vertex { get; }
}

/// <summary>Grows a pair of legs or arms out of the body.</summary>
internal static class LegGrower
{
    /// <summary>Rings before and behind a socket whose sections a limb keeps out of.</summary>
    private const int GuardedRings = 7;

    /// <summary>How far from the middle of a pad its nails are, in its radii.</summary>
    private const float NailReach = 1.01f;

    /// <summary>How far the foot of a leg out to the side is turned to the level where it hangs in the water: level, it is a stick from the front and the side.</summary>
    private const float OarTurn = 0.4f;

    private static readonly float[] insectSections = { 0f, 0.5f, 1f, 1.6f, 2.3f, 3f, 3.5f, 4f, 4.5f, 5f, 6f, 7f, 8f };

    /// <summary>Grows the left leg, mirrors it, and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, LegBlueprint leg, int index, LimbEnds ends)
    {
        SurfaceBuilder surface = body.Surface;
        LegForm form = LegForm.Of(leg);
        SocketLoop socket = SocketLoop.Cut(body, leg.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        LegPath path = LegPath.Lay(form, leg, socket, body.Skin.Shape);

        bool standing = leg.Stance == LegStance.Standing;
        bool vertical = form.End is FootEnd.Hoof or FootEnd.Pad;
        var sweep = new LimbSweep
        {
            Joints = path.Centres,
            Radii = path.Radii,
            Sections = SectionsOf(form),
            Across = socket.Around,
            Blend = Scalar.Clamp(1.5f * socket.HalfLength / path.Length, 0.1f, 0.42f),
            Floor = standing ? 0f : float.NegativeInfinity,
            EndDirection = vertical ? -Vector3.UnitY : Vector3.Zero,
            LevelFrom = form.End == FootEnd.Toes && (standing || form.Sprawling) ? 0.6f : 2f,
            LevelShare = standing ? 1f : OarTurn,
            KeepOut = socket.Centre.X > 0.02f ? new BodyKeepOut(body.Skin, leg.Socket.Ring - GuardedRings, leg.Socket.Ring + leg.Socket.Rows + GuardedRings) : null,
            Address = new VertexAddress { Region = SurfaceRegion.Leg, Appendage = (short)index, Sign = 1 },
        };
        SweepResult grown = sweep.Grow(surface, socket.Vertices);
        Finish(surface, form, leg, path, grown, index, ends);
        surface.MirrorSince(firstVertex, firstFace);
        return Describe(form, leg, socket, path, grown);
    }

    private static void Finish(SurfaceBuilder surface, LegForm form, LegBlueprint leg, LegPath path, SweepResult grown, int index, LimbEnds ends)
    {
        SweepFrame end = grown.Last;
        var address = new VertexAddress { Region = SurfaceRegion.Leg, Appendage = (short)index, Sign = 1, Along = 1f };
        float radius = Math.Min(end.ForeRadius, end.AcrossRadius);
        switch (form.End)
        {
            case FootEnd.Toes:
                Digits.Grow(surface, form, leg, path.Thickness, grown, index, ends);
                return;
            case FootEnd.Hoof:
                int hoofStart = surface.Positions.Count - (2 * grown.End.Length);
                for (int v = hoofStart; v < surface.Positions.Count; v++)
                {
                    VertexAddress a = surface.Addresses[v];
                    a.Region = SurfaceRegion.Hoof;
                    surface.Addresses[v] = a;
                }

                Cleave(surface, FootForm.Of(leg.Foot).Cleft, grown);
                address.Region = SurfaceRegion.Hoof;
                Cap(surface, leg, grown.End, end.Tangent, 0f, address);
                return;
            case FootEnd.Pad:
                Cap(surface, leg, grown.End, end.Tangent, 0f, address);
                for (int q = -1; q <= 1; q++)
                {
                    double a = q * 0.75;
                    var p = end.Centre + (new Vector3((float)PortableMath.Sin(a) * end.AcrossRadius, 0f, (float)PortableMath.Cos(a) * end.ForeRadius) * NailReach);
                    p.Y = end.ForeRadius * 0.22f;
                    ends.Tips.Add(new DigitTip(DigitTipKind.Nail, p, new Vector3((float)PortableMath.Sin(a), 0f, (float)PortableMath.Cos(a)), end.ForeRadius * 0.2f, 0f, grown.End[0]));
                }

                return;
            default:
                Cap(surface, leg, grown.End, end.Tangent, radius, address);
                ends.Tips.Add(new DigitTip(DigitTipKind.Claw, end.Centre, Vec.Normalize(end.Tangent), radius, (float)leg.ClawLength, grown.End[0]));
                if (form.Carried)
                {
                    LegSpines.Add(form, grown, ends.Tips);
                }

                return;
        }
    }

    /// <summary>Draws a hoof in along its front and its rear, deeper in front, so that it falls into two halves.</summary>
    private static void Cleave(SurfaceBuilder surface, float cleft, SweepResult grown)
    {
        int count = grown.End.Length;
        for (int k = 0; k < count && cleft > 0f; k++)
        {
            double cosine = PortableMath.Cos(PortableMath.Tau * k / count);
            float depth = cleft * (cosine > 0 ? 1f : 0.45f) * (float)PortableMath.Pow(Math.Abs(cosine), 12);
            for (int row = 0; row < 2; row++)
            {
                SweepFrame frame = grown.Frames[grown.Frames.Length - 1 - row];
                int v = grown.End[k] - (row * count);
                float along = depth * (row == 0 ? 1f : 0.8f) * (float)cosine * frame.ForeRadius;
                surface.Positions[v] -= frame.Fore * along;
            }
        }
    }

    private static void Cap(SurfaceBuilder surface, LegBlueprint leg, int[] loop, Vector3 outward, float bulge, in VertexAddress address)
    {
        SocketBlueprint socket = leg.Socket;
        int[] cap = CapGrid.Vertices(surface, loop, socket.Rows, socket.Columns, outward, bulge, address);
        for (int r = 1; r < socket.Rows && leg.Stance == LegStance.Standing; r++)
        {
            for (int c = 1; c < socket.Columns; c++)
            {
                int v = cap[(r * (socket.Columns + 1)) + c];
                Vector3 p = surface.Positions[v];
                surface.Positions[v] = new Vector3(p.X, Math.Max(p.Y, 0f), p.Z);
            }
        }

        CapGrid.Fill(surface, cap, socket.Rows, socket.Columns, surface.NewChart(), new Vector2(0.05f, 0.05f));
    }

    private static float[] SectionsOf(LegForm form)
    {
        if (form.Arched)
        {
            return insectSections;
        }

        // Between the rows of a calf, of what is thin below it and of the hock there are no more: they would only be creased with the knee.
        bool hocked = !form.Lateral && !form.Jointed && form.AnkleRow - form.KneeRow == 3;
        var sections = new List<float>();
        for (int i = 0; i < (2 * form.Rows) - 1; i++)
        {
            float row = i / 2f;
            if (i % 2 == 0 || !hocked || row < form.KneeRow + 1 || row > form.AnkleRow)
            {
                sections.Add(row);
            }
        }

        return sections.ToArray();
    }

    private static Appendage Describe(LegForm form, LegBlueprint leg, SocketLoop socket, LegPath path, SweepResult grown)
    {
        Vector3[] joints = path.Joints;
        int last = form.Rows - 1;
        Vector3 hip = joints[0];
        hip.X += (joints[1].X - joints[0].X) / 2f;
        Vector3 end = joints[last];
        float reach = Math.Max(form.ToeLength * path.Thickness * (float)leg.FootSize, 0.25f * Vec.Distance(joints[last], joints[form.BallRow]));
        Vector3 ahead = leg.Stance == LegStance.Standing ? Vec.Normalize(new Vector3(grown.Last.Tangent.X, 0f, grown.Last.Tangent.Z), Vector3.UnitZ) : Vec.Normalize(grown.Last.Tangent, Vector3.UnitZ);
        end += ahead * Math.Max(reach, 0.01f);
        Vector3 knee = joints[form.KneeRow];
        Vector3 line = Vec.Normalize(joints[form.AnkleRow] - hip, -Vector3.UnitY);
        Vector3 ball = form.BallRow == last ? Vec.Lerp(joints[last - 1], joints[last], 0.8f) : joints[form.BallRow];
        return new Appendage
        {
            Kind = form.Handed ? LimbKind.Arm : LimbKind.Leg,
            Paired = true,
            Archetype = form.Archetype,
            RootRing = socket.CentreRing,
            Joints = new[] { hip, knee, joints[form.AnkleRow], ball, end },
            JointsAlong = new[] { 0f, At(form.KneeRow), At(form.AnkleRow), At(form.BallRow), 1f },
            Pole = Vec.Normalize(Vec.Reject(knee - hip, line), Vector3.UnitZ),
            Contact = leg.Stance == LegStance.Standing ? new Vector3(ball.X, 0f, ball.Z) : end,
            Stands = leg.Stance == LegStance.Standing,
        };

        float At(int row)
        {
            int q = Array.IndexOf(SectionsOf(form), (float)row);
            return grown.Along[q];
        }
    }
}
