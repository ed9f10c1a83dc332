using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>
/// The border of a rectangle of cells cut out of the body: the loop that a limb grows from. It starts in the middle of the front row and runs
/// towards larger segments, so that its angle α is 0 in front, π/2 on the ventral side, π behind and 3π/2 on the dorsal side.
/// </summary>
internal sealed class SocketLoop
{
    private SocketLoop(SocketBlueprint socket, int[] vertices, Vector3[] points, Vector3 around, float halfLength, float halfWidth)
    {
        Socket = socket;
        Vertices = vertices;
        Points = points;
        Around = around;
        HalfLength = halfLength;
        HalfWidth = halfWidth;
        Centre = Mean(points);
    }

    /// <summary>The cells.</summary>
    public SocketBlueprint Socket { get; }

    /// <summary>Vertices of the border in loop order.</summary>
    public int[] Vertices { get; }

    /// <summary>Their positions.</summary>
    public Vector3[] Points { get; }

    /// <summary>Mean of the border's points.</summary>
    public Vector3 Centre { get; }

    /// <summary>Unit direction across the middle of the socket towards larger segments.</summary>
    public Vector3 Around { get; }

    /// <summary>Half the distance from the front to the rear of the socket.</summary>
    public float HalfLength { get; }

    /// <summary>Half the distance across the socket.</summary>
    public float HalfWidth { get; }

    /// <summary>Ring of the socket's centre.</summary>
    public float CentreRing => Socket.Ring + (Socket.Rows / 2f);

    /// <summary>Cuts the socket and its mirror image out of the body. A socket on the midline is its own mirror image.</summary>
    public static SocketLoop Cut(BodySurface body, SocketBlueprint socket)
    {
        for (int r = 0; r < socket.Rows; r++)
        {
            for (int c = 0; c < socket.Columns; c++)
            {
                int cell = (socket.Segment + c) & 31;
                body.Cut(socket.Ring + r, cell);
                body.Cut(socket.Ring + r, 31 - cell);
            }
        }

        int[] loop = BorderOf(body, socket);
        int middle = socket.Ring + (socket.Rows / 2);
        int half = socket.Segment + (socket.Columns / 2);
        Vector3[] points = Array.ConvertAll(loop, v => body.Surface.Positions[v]);
        Vector3 across = body.Skin[middle, (socket.Segment + socket.Columns) & 31] - body.Skin[middle, socket.Segment & 31];
        Vector3 along = body.Skin[socket.Ring, half & 31] - body.Skin[socket.Ring + socket.Rows, half & 31];
        return new SocketLoop(socket, loop, points, Vec.Normalize(across, Vector3.UnitX), Vec.Length(along) / 2f, Vec.Length(across) / 2f);
    }

    /// <summary>The vertices of a socket's border in loop order.</summary>
    public static int[] BorderOf(BodySurface body, SocketBlueprint socket)
    {
        int i0 = socket.Ring;
        int i1 = socket.Ring + socket.Rows;
        int j0 = socket.Segment;
        int j1 = socket.Segment + socket.Columns;
        int half = (j0 + j1) / 2;
        int[] loop = new int[2 * (socket.Rows + socket.Columns)];
        int k = 0;
        for (int j = half; j < j1; j++)
        {
            loop[k++] = body[i0, j];
        }

        for (int i = i0; i < i1; i++)
        {
            loop[k++] = body[i, j1];
        }

        for (int j = j1; j > j0; j--)
        {
            loop[k++] = body[i1, j];
        }

        for (int i = i1; i > i0; i--)
        {
            loop[k++] = body[i, j0];
        }

        for (int j = j0; j < half; j++)
        {
            loop[k++] = body[i0, j];
        }

        return loop;
    }

    /// <summary>The border between two rows and two columns of a grid of vertices, in the same order as a socket's.</summary>
    public static int[] OfGrid(int[] grid, int stride, int row0, int row1, int column0, int column1)
    {
        int half = (column0 + column1) / 2;
        int[] loop = new int[2 * (row1 - row0 + column1 - column0)];
        int k = 0;
        for (int c = half; c < column1; c++)
        {
            loop[k++] = grid[(row0 * stride) + c];
        }

        for (int r = row0; r < row1; r++)
        {
            loop[k++] = grid[(r * stride) + column1];
        }

        for (int c = column1; c > column0; c--)
        {
            loop[k++] = grid[(row1 * stride) + c];
        }

        for (int r = row1; r > row0; r--)
        {
            loop[k++] = grid[(r * stride) + column0];
        }

        for (int c = column0; c < half; c++)
        {
            loop[k++] = grid[(row0 * stride) + c];
        }

        return loop;
    }

    /// <summary>The mean of points, added in order.</summary>
    public static Vector3 Mean(ReadOnlySpan<Vector3> points)
    {
        Vector3 sum = Vector3.Zero;
        foreach (Vector3 p in points)
        {
            sum += p;
        }

        return sum / points.Length;
    }
}
