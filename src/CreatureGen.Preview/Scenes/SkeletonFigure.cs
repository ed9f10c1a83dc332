using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Scenes;

/// <summary>A skeleton as a mesh: each bone an octahedron from joint to child, thick near the joint, each joint a ball. Left is blue, right is red, the middle amber.</summary>
public static class SkeletonFigure
{
    // Parts of the longest side of the skeleton.
    private const float JointRadius = 0.0085f;
    private const float SmallestJoint = 0.004f;
    private const float ThickestBone = 0.016f;
    private const float ShortestBone = 1e-4f;

    // Parts of a bone's length.
    private const float JointPart = 0.2f;
    private const float BoneThickness = 0.09f;
    private const float ThickestPlace = 0.15f;

    // The thinnest a bone gets, as a part of the radius of joints.
    private const float ThinnestBone = 0.45f;

    private static readonly Vector3 LeftColour = Decode(74, 144, 226);
    private static readonly Vector3 RightColour = Decode(226, 84, 74);
    private static readonly Vector3 MiddleColour = Decode(240, 176, 48);

    /// <summary>The skeleton in rest pose.</summary>
    public static RenderMesh From(Skeleton skeleton)
    {
        ArgumentNullException.ThrowIfNull(skeleton);
        var positions = new Vector3[skeleton.Joints.Count];
        for (int i = 0; i < positions.Length; i++)
        {
            positions[i] = skeleton.Joints[i].ModelPosition;
        }

        return From(skeleton, positions);
    }

    /// <summary>The skeleton in another pose.</summary>
    /// <param name="skeleton">The joints; the root and the bone from it to the body are not drawn.</param>
    /// <param name="posedPositions">Where the joints are, model space, metres; one per joint.</param>
    /// <exception cref="ArgumentException">There is not one position per joint.</exception>
    public static RenderMesh From(Skeleton skeleton, ReadOnlySpan<Vector3> posedPositions)
    {
        ArgumentNullException.ThrowIfNull(skeleton);
        if (posedPositions.Length != skeleton.Joints.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{posedPositions.Length} positions; expected {skeleton.Joints.Count}, one per joint"), nameof(posedPositions));
        }

        Vector3 size = BoundingBox.Of(posedPositions).Size;
        float longest = Math.Max(1e-3f, Math.Max(size.X, Math.Max(size.Y, size.Z)));
        var builder = new Builder();
        for (int i = 0; i < posedPositions.Length; i++)
        {
            Joint joint = skeleton.Joints[i];
            Vector3 colour = joint.Side switch { Side.Left => LeftColour, Side.Right => RightColour, _ => MiddleColour };
            if (joint.Parent < 0)
            {
                continue;
            }

            float length = Vec.Distance(posedPositions[joint.Parent], posedPositions[i]);
            if (joint.Parent > 0)
            {
                builder.AddBone(posedPositions[joint.Parent], posedPositions[i], longest, colour);
            }

            if (joint.Role != JointRole.End)
            {
                float radius = Math.Clamp(length * JointPart, longest * SmallestJoint, longest * JointRadius);
                builder.AddBall(posedPositions[i], radius, Vec.Lerp(colour, Vector3.One, 0.75f));
            }
        }

        return builder.Finish();
    }

    private static Vector3 Decode(byte r, byte g, byte b) => new(SrgbCurve.Decode(r), SrgbCurve.Decode(g), SrgbCurve.Decode(b));

    private sealed class Builder
    {
        private const int BallSegments = 10;
        private const int BallRings = 6;

        private readonly List<Vector3> positions = [];
        private readonly List<Vector3> normals = [];
        private readonly List<Vector3> colours = [];
        private readonly List<int> triangles = [];

        public void AddBone(Vector3 from, Vector3 to, float longest, Vector3 colour)
        {
            Vector3 along = to - from;
            float length = Vec.Length(along);
            if (length < longest * ShortestBone)
            {
                return;
            }

            along /= length;
            Vector3 side = Vec.Normalize(Vec.Cross(along, Math.Abs(along.Y) > 0.9f ? Vector3.UnitX : Vector3.UnitY));
            Vector3 other = Vec.Cross(side, along);
            float radius = Math.Clamp(length * BoneThickness, longest * JointRadius * ThinnestBone, longest * ThickestBone);
            Vector3 middle = from + (along * (length * ThickestPlace));
            Span<Vector3> ring = [middle + (side * radius), middle + (other * radius), middle - (side * radius), middle - (other * radius)];
            for (int i = 0; i < ring.Length; i++)
            {
                // side, other, along are right-handed with side × other = −along: seen from the joint the ring runs counter-clockwise.
                Vector3 next = ring[(i + 1) % ring.Length];
                AddFace(from, ring[i], next, colour);
                AddFace(to, next, ring[i], colour);
            }
        }

        public void AddBall(Vector3 centre, float radius, Vector3 colour)
        {
            int first = positions.Count;
            for (int ring = 0; ring <= BallRings; ring++)
            {
                double latitude = PortableMath.Pi * ring / BallRings;
                for (int segment = 0; segment < BallSegments; segment++)
                {
                    double longitude = PortableMath.Tau * segment / BallSegments;
                    var normal = new Vector3(
                        (float)(PortableMath.Sin(latitude) * PortableMath.Sin(longitude)),
                        (float)PortableMath.Cos(latitude),
                        (float)(PortableMath.Sin(latitude) * PortableMath.Cos(longitude)));
                    positions.Add(centre + (normal * radius));
                    normals.Add(normal);
                    colours.Add(colour);
                }
            }

            for (int ring = 0; ring < BallRings; ring++)
            {
                for (int segment = 0; segment < BallSegments; segment++)
                {
                    int a = first + (ring * BallSegments) + segment;
                    int b = first + (ring * BallSegments) + ((segment + 1) % BallSegments);
                    triangles.AddRange([a, a + BallSegments, b + BallSegments, a, b + BallSegments, b]);
                }
            }
        }

        public RenderMesh Finish() => new(
            [.. positions],
            [.. normals],
            [.. colours],
            [.. triangles],
            [new RenderPart(new SurfaceMaterial(Facing.Front, 0.2f, 0f), 0, triangles.Count)]);

        private void AddFace(Vector3 a, Vector3 b, Vector3 c, Vector3 colour)
        {
            Vector3 normal = Vec.Normalize(Vec.Cross(b - a, c - a), Vector3.UnitY);
            foreach (Vector3 corner in (ReadOnlySpan<Vector3>)[a, b, c])
            {
                triangles.Add(positions.Count);
                positions.Add(corner);
                normals.Add(normal);
                colours.Add(colour);
            }
        }
    }
}
