using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of ears out of the head: leaves, each bent into a cup that opens ahead and to its side.</summary>
internal static class EarGrower
{
    /// <summary>Radians by which the cup of an upright ear is turned out from straight ahead: its leaf is seen from the side, its cup from the front.</summary>
    private const float TurnedOut = 0.68f;

    /// <summary>How far the edges of the leaf stand before its middle, in half widths.</summary>
    private const float Cup = 0.26f;

    private static readonly float[] pointed = { 0.75f, 1.05f, 1.12f, 0.7f, 0.14f };
    private static readonly float[] round = { 0.78f, 1.02f, 1.1f, 0.92f, 0.52f };
    private static readonly float[] thickness = { 0.62f, 0.44f, 0.27f, 0.24f, 0.24f };
    private static readonly float[] reach = { 0f, 0.22f, 0.55f, 0.85f, 1f };
    private static readonly float[] sag = { 0f, 0f, 0.15f, 0.5f, 0.8f };
    private static readonly float[] sections = { 0f, 0.6f, 1f, 1.5f, 2f, 2.5f, 3f, 3.5f, 4f };

    /// <summary>Grows the left ear, mirrors it, and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, EarBlueprint ear, int index)
    {
        SurfaceBuilder surface = body.Surface;
        SocketLoop socket = SocketLoop.Cut(body, ear.Socket);
        int firstVertex = surface.Positions.Count;
        int firstFace = surface.Faces.Count;
        float length = (float)ear.Length;
        float width = (float)ear.Width;
        Vector3 direction = Vec.Normalize(new Vector3((float)ear.Outward, (float)ear.Upward, (float)ear.Forward));
        var joints = new Vector3[5];
        var radii = new Vector2[5];
        for (int k = 0; k < 5; k++)
        {
            float outline = Scalar.Lerp(pointed[k], round[k], (float)ear.Roundness);
            joints[k] = socket.Centre + (direction * (length * reach[k])) - (Vector3.UnitY * ((float)ear.Droop * sag[k] * length));
            radii[k] = new Vector2((width * thickness[k] * outline) + 0.004f, width * outline);
        }

        Vector3 across = Vec.Normalize(Vec.Reject(socket.Around, direction), Vector3.UnitX);
        var address = new VertexAddress { Region = SurfaceRegion.Ear, Appendage = (short)index, Sign = 1 };
        var sweep = new LimbSweep
        {
            Joints = joints,
            Radii = radii,
            Sections = sections,
            Across = Rotation.Rotate(AxisRotation.About(direction, TurnedOut * Math.Max(0f, direction.Y)), across),
            Blend = 0.2f,
            Groove = 1.5f,
            Curl = Cup,
            Address = address,
        };
        SweepResult grown = sweep.Grow(surface, socket.Vertices);
        address.Along = 1f;
        int[] cap = CapGrid.Vertices(surface, grown.End, ear.Socket.Rows, ear.Socket.Columns, grown.Last.Tangent, width * 0.05f, address);
        CapGrid.Fill(surface, cap, ear.Socket.Rows, ear.Socket.Columns, surface.NewChart(), new Vector2(0.03f, 0.03f));
        surface.MirrorSince(firstVertex, firstFace);
        return new Appendage
        {
            Kind = LimbKind.Ear,
            Paired = true,
            RootRing = socket.CentreRing,
            Joints = new[] { joints[0], joints[2], joints[4] },
            JointsAlong = new[] { 0f, grown.Along[4], 1f },
            Pole = grown.Last.Fore,
            Contact = joints[4],
        };
    }
}
