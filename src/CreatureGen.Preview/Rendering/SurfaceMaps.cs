using System;
using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>What is seen in the middle of each pixel, as numbers: distance, normal and triangle. Rows follow one another from the top.</summary>
public sealed class SurfaceMaps
{
    private readonly float[] depths;
    private readonly Vector3[] normals;
    private readonly int[] triangles;

    private SurfaceMaps(int width, int height, float[] depths, Vector3[] normals, int[] triangles) => (Width, Height, this.depths, this.normals, this.triangles) = (width, height, depths, normals, triangles);

    /// <summary>Pixels in a row.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>Distance along the camera's axis, metres; 0 where nothing is seen.</summary>
    public ReadOnlySpan<float> Depths => depths;

    /// <summary>Unit normals in the space of the camera (right, up, into the picture); zero where nothing is seen.</summary>
    public ReadOnlySpan<Vector3> Normals => normals;

    /// <summary>Which triangle of the mesh is seen, from 0; -1 where nothing is.</summary>
    public ReadOnlySpan<int> Triangles => triangles;

    /// <summary>Finds what a camera sees of a mesh. The same mesh and camera give the same numbers for any number of threads.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="camera">From where.</param>
    /// <param name="width">Pixels in a row, 1..8192.</param>
    /// <param name="height">Rows, 1..8192.</param>
    /// <param name="threads">Threads that share the work, at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public static SurfaceMaps Find(RenderMesh mesh, Camera camera, int width, int height, int threads = 1)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ArgumentNullException.ThrowIfNull(camera);
        var options = new RenderOptions { Width = width, Height = height, Threads = threads, Samples = SampleCount.One };
        Renderer.Check(options);
        VisibleSurface surface = VisibleSurface.Find(mesh, camera, options);
        int[] triangles = new int[width * height];
        Array.Fill(triangles, -1);
        foreach (Fragment[] tile in surface.Fragments)
        {
            foreach (Fragment fragment in tile)
            {
                triangles[fragment.Pixel] = surface.Triangles[fragment.Triangle].Source / 3;
            }
        }

        return new SurfaceMaps(width, height, surface.Depths, surface.Normals, triangles);
    }
}
