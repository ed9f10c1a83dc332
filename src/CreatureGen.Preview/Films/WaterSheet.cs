using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>The level surface of water around a camera: what is under it is seen through it.</summary>
internal sealed class WaterSheet
{
    private static readonly Vector3 colour = new(0.16f, 0.30f, 0.36f);

    // Share of the colour of water in what is seen through its surface, 256ths.
    private const int Veil = 120;

    private readonly IWaterGround water;
    private readonly float reach;

    /// <summary>A sheet of water.</summary>
    /// <param name="water">Where it is.</param>
    /// <param name="reach">How far it is drawn around the camera, metres.</param>
    public WaterSheet(IWaterGround water, float reach)
    {
        this.water = water;
        this.reach = reach;
    }

    /// <summary>The surface as a camera sees it, in its axes.</summary>
    public RenderMesh At(in RootPlace camera)
    {
        Vector3 middle = camera.Position;
        middle.Y += water.DepthAt(middle);
        var sheet = new FloorMesh(camera, RootPlace.Identity);
        sheet.Add(middle + new Vector3(-reach, 0f, -reach), middle + new Vector3(-reach, 0f, reach), middle + new Vector3(reach, 0f, reach), middle + new Vector3(reach, 0f, -reach), colour);
        return sheet.ToMesh();
    }

    /// <summary>Lays the picture with the surface over that without it.</summary>
    public static void Lay(Picture seen, Picture surface)
    {
        for (int y = 0; y < seen.Height; y++)
        {
            for (int x = 0; x < seen.Width; x++)
            {
                Pixel under = seen[x, y];
                Pixel over = surface[x, y];
                seen[x, y] = new Pixel(Mix(under.R, over.R), Mix(under.G, over.G), Mix(under.B, over.B), under.A);
            }
        }
    }

    private static byte Mix(byte under, byte over) => (byte)(((under * (256 - Veil)) + (over * Veil)) >> 8);
}
