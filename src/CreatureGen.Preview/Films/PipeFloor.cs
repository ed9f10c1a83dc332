using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>A hoop of a pipe along the X axis whose bottom is the origin, in checks that stay where they are; it is seen from within, and through its wall from without.</summary>
internal sealed class PipeFloor : IFloor
{
    // Flat pieces along a side of a check.
    private const int Patches = 3;

    private readonly float radius;
    private readonly int checks;
    private readonly int across;
    private readonly double side;

    /// <summary>A hoop.</summary>
    /// <param name="radius">Metres.</param>
    /// <param name="check">About the side of a check, metres: a whole and even number of them goes round.</param>
    /// <param name="halfWidth">To the left and right of where the course began, metres.</param>
    public PipeFloor(float radius, float check, float halfWidth)
    {
        this.radius = radius;
        checks = 2 * Math.Max((int)Math.Round(PortableMath.Pi * radius / check), 2);
        side = 2 * PortableMath.Pi * radius / checks;
        across = (int)Math.Ceiling(halfWidth / side);
    }

    /// <inheritdoc/>
    public RenderMesh At(in RootPlace camera, in RootPlace frame)
    {
        var floor = new FloorMesh(camera, frame);
        for (int round = 0; round < checks * Patches; round++)
        {
            (float y, float z) = Place(round);
            (float nextY, float nextZ) = Place(round + 1);
            for (int i = -across; i < across; i++)
            {
                Vector3 colour = FloorMesh.Check((round / Patches) + i);
                float left = (float)(side * (i + 1)), right = (float)(side * i);
                floor.AddFacing(new Vector3(right, y, z), new Vector3(right, nextY, nextZ), new Vector3(left, nextY, nextZ), new Vector3(left, y, z), colour);
            }
        }

        return floor.ToMesh();
    }

    private (float Y, float Z) Place(int round)
    {
        double angle = round * side / (Patches * radius);
        return ((float)(radius * (1 - PortableMath.Cos(angle))), (float)(radius * PortableMath.Sin(angle)));
    }
}
