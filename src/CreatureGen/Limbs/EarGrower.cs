using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a pair of leaf-shaped ears out of the head.</summary>
internal static class EarGrower
{
    private static readonly float[] pointed = { 0.7f, 0.95f, 0.95f, 0.55f, 0.12f };
    private static readonly float[] round = { 0.75f, 0.95f, 1f, 0.85f, 0.5f };
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
            radii[k] = new Vector2((width * (k == 0 ? 0.47f : k == 1 ? 0.34f : 0.24f) * outline) + 0.004f, width * outline);
        }

        var address = new VertexAddress { Region = SurfaceRegion.Ear, Appendage = (short)index, Sign = 1 };
        var sweep = new LimbSweep
        {
            Joints = joints,
            Radii = radii,
            Sections = sections,
            Across = socket.Around,
            Blend = 0.2f,
            Groove = 1.5f,
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
