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

    private static readonly Vector3 light = new(0.60f, 0.58f, 0.54f);
    private static readonly Vector3 dark = new(0.30f, 0.30f, 0.31f);

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

    /// <summary>The colour of a check: one of two in turn.</summary>
    /// <param name="number">Its row and its column together.</param>
    public static Vector3 Check(long number) => (number & 1) == 0 ? light : dark;

    /// <summary>Adds a piece with four corners, counter-clockwise or clockwise; nothing where a corner has no ground. Level pieces are seen from above, others from both sides.</summary>
    public void Add(Vector3? a, Vector3? b, Vector3? c, Vector3? d, Vector3 colour)
    {
        if (a is not Vector3 first || b is not Vector3 second || c is not Vector3 third || d is not Vector3 fourth || !TryPlace(first, second, third, fourth, colour, out int start, out Vector3 normal))
        {
            return;
        }

        // Seen from the camera, whatever the order of the corners.
        bool level = normal.Y is > 0.5f or < -0.5f;
        Face(start, level && normal.Y < 0f ? -normal : normal);
        if (!level)
        {
            triangles.AddRange([start, start + 2, start + 1, start, start + 3, start + 2]);
        }
    }

    /// <summary>Adds a piece that is seen from where its corners go counter-clockwise.</summary>
    public void AddFacing(Vector3 a, Vector3 b, Vector3 c, Vector3 d, Vector3 colour)
    {
        if (TryPlace(a, b, c, d, colour, out int start, out Vector3 normal))
        {
            Face(start, normal);
        }
    }

    /// <summary>What was added.</summary>
    public RenderMesh ToMesh() =>
        new([.. positions], [.. normals], [.. colours], [.. triangles], [new RenderPart(new SurfaceMaterial(Facing.Front, 0f, 0f), 0, triangles.Count)]);

    /// <summary>Puts corners in the camera's axes; false where there is nothing to be drawn between them.</summary>
    private bool TryPlace(Vector3 a, Vector3 b, Vector3 c, Vector3 d, Vector3 colour, out int start, out Vector3 normal)
    {
        start = positions.Count;
        Vector3 first = Seen(a), second = Seen(b), third = Seen(c), fourth = Seen(d);
        Vector3 across = Vec.Cross(third - first, fourth - second);
        normal = Vec.Normalize(across);
        if (Vec.Length(across) < MinArea)
        {
            return false;
        }

        positions.AddRange([first, second, third, fourth]);
        colours.AddRange([colour, colour, colour, colour]);
        return true;
    }

    private Vector3 Seen(Vector3 corner) => camera.ToModel(frame.ToWorld(corner));

    private void Face(int start, Vector3 normal)
    {
        normals.AddRange([normal, normal, normal, normal]);
        triangles.AddRange([start, start + 1, start + 2, start, start + 2, start + 3]);
    }
}
