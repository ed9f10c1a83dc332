using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>Gathers flat pieces of a floor, seen from a camera.</summary>
internal sealed class FloorMesh
{
    // Pieces thinner than this, metres squared, are not drawn.
    private const float MinArea = 1e-8f;

    private readonly RootPlace camera;
    private readonly RootPlace frame;
    private readonly List<Vector3> positions = [];
    private readonly List<Vector3> normals = [];
    private readonly List<Vector3> colours = [];
    private readonly List<int> triangles = [];

    /// <summary>An empty floor.</summary>
    /// <param name="camera">Where the camera is, world space.</param>
    /// <param name="frame">The axes of what is added.</param>
    public FloorMesh(in RootPlace camera, in RootPlace frame)
    {
        this.camera = camera;
        this.frame = frame;
    }

    /// <summary>Adds a piece with four corners, counter-clockwise or clockwise; nothing where a corner has no ground.</summary>
    public void Add(Vector3? a, Vector3? b, Vector3? c, Vector3? d, Vector3 colour)
    {
        if (a is not Vector3 first || b is not Vector3 second || c is not Vector3 third || d is not Vector3 fourth)
        {
            return;
        }

        int start = positions.Count;
        foreach (Vector3 corner in new[] { first, second, third, fourth })
        {
            positions.Add(camera.ToModel(frame.ToWorld(corner)));
            colours.Add(colour);
        }

        Vector3 across = Vec.Cross(positions[start + 2] - positions[start], positions[start + 3] - positions[start + 1]);
        if (Vec.Length(across) < MinArea)
        {
            positions.RemoveRange(start, 4);
            colours.RemoveRange(start, 4);
            return;
        }

        // Seen from the camera, whatever the order of the corners.
        Vector3 normal = Vec.Normalize(across);
        bool level = normal.Y is > 0.5f or < -0.5f;
        normal = level && normal.Y < 0f ? -normal : normal;
        for (int i = 0; i < 4; i++)
        {
            normals.Add(normal);
        }

        triangles.AddRange([start, start + 1, start + 2, start, start + 2, start + 3]);
        if (!level)
        {
            triangles.AddRange([start, start + 2, start + 1, start, start + 3, start + 2]);
        }
    }

    /// <summary>What was added.</summary>
    public RenderMesh ToMesh() =>
        new([.. positions], [.. normals], [.. colours], [.. triangles], [new RenderPart(new SurfaceMaterial(Facing.Front, 0f, 0f), 0, triangles.Count)]);
}
