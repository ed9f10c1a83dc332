using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>Six pictures beside each other of figures whose bones are thick: those of the left teal, of the right coral, of the middle pale. The camera stands at angles in degrees, and sees a box.</summary>
internal sealed class BoneStrip(double azimuth, double elevation, Vector3 low, Vector3 high, float thick, GroundKind ground = GroundKind.Shadows)
{
    private const int Frames = 6;
    private const int Side = 240;
    private const int Around = 14;
    private readonly Camera camera = Camera.Fit(new CameraAngle(azimuth, elevation), new BoundingBox(low, high), 1f, 0.04f);

    /// <summary>The picture so far.</summary>
    public Picture Picture { get; } = new(Frames * Side, Side, PixelLayout.Rgb);

    /// <summary>Room for a pose of a skeleton.</summary>
    public static Pose Room(Skeleton skeleton) => new(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);

    /// <summary>Draws the last pose of every so many, and what is around it, into the next frame.</summary>
    public void DrawEvery(int updates, int update, Skeleton skeleton, ReadOnlySpan<Vector3> modelPositions, params Thing[] things)
    {
        if (update % updates == updates - 1)
        {
            Draw(update / updates, Bones(skeleton, modelPositions, things));
        }
    }

    /// <summary>Draws a scene into a frame.</summary>
    public void Draw(int frame, RenderMesh scene) => Picture.Blit(Renderer.Render(scene, camera, new RenderOptions { Width = Side, Height = Side, Ground = ground }), frame * Side, 0);

    /// <summary>The bones of a pose as capsules, and what is around them; ends on the ground rest on it.</summary>
    public RenderMesh Bones(Skeleton skeleton, ReadOnlySpan<Vector3> modelPositions, params Thing[] things)
    {
        var (positions, normals, colours, triangles) = (new List<Vector3>(), new List<Vector3>(), new List<Vector3>(), new List<int>());
        for (int i = 1; i < skeleton.Count; i++)
        {
            Vector3 colour = (skeleton.Joints[i].Side == Anatomy.Side.Median ? JointNames.SideOf(skeleton.Joints[i].Name) : skeleton.Joints[i].Side) switch { Anatomy.Side.Left => new(0.03f, 0.32f, 0.33f), Anatomy.Side.Right => new(0.75f, 0.14f, 0.07f), _ => new(0.62f, 0.5f, 0.34f) };
            float end = skeleton.Parents.IndexOf(i) >= 0 ? thick : 0.7f * thick;
            Capsule(new Thing(modelPositions[skeleton.Parents[i]], modelPositions[i], thick, colour), end);
        }

        foreach (Thing thing in things)
        {
            Capsule(thing, thing.Radius);
        }

        return new RenderMesh([.. positions], [.. normals], [.. colours], [.. triangles], [new RenderPart(new SurfaceMaterial(Facing.Front, 0.15f, 0f), 0, triangles.Count)]);

        void Capsule(Thing bone, float end)
        {
            Vector3 along = bone.To == bone.From ? Vector3.UnitY : Vector3.Normalize(bone.To - bone.From);
            Vector3 side = Vector3.Normalize(Vector3.Cross(along, MathF.Abs(along.Y) > 0.9f ? Vector3.UnitX : Vector3.UnitY)), other = Vector3.Cross(along, side);
            for (int i = 0; i < 12 * Around; i++)
            {
                (int ring, float turn) = (i / Around, MathF.Tau * (i % Around) / Around);
                float slope = MathF.PI * ((ring < 6 ? ring : ring - 1) - 5f) / 10f;
                Vector3 normal = (along * MathF.Sin(slope)) + (((side * MathF.Cos(turn)) + (other * MathF.Sin(turn))) * MathF.Cos(slope));
                if (ring < 11)
                {
                    (int at, int next) = (positions.Count, positions.Count - i + (ring * Around) + ((i + 1) % Around));
                    triangles.AddRange([at, next, next + Around, at, next + Around, at + Around]);
                }

                positions.Add((ring < 6 ? bone.From : bone.To) + ((ring < 6 ? bone.Radius : end) * normal) + new Vector3(0f, 0.7f * thick, 0f));
                normals.Add(normal);
                colours.Add(bone.Colour);
            }
        }
    }

    /// <summary>Something round beside the bones: a ball, or a log from one place to another.</summary>
    internal readonly record struct Thing(Vector3 From, Vector3 To, float Radius, Vector3 Colour);
}
