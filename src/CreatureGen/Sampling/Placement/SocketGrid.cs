using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling.Placement;

/// <summary>Which cells of the body are taken by sockets. Cell (ring i, segment j) lies between rings i and i + 1 and segments j and j + 1: 54 × 32 cells.</summary>
internal sealed class SocketGrid
{
    private const int CellRows = BodyGrid.Rings - 1;

    /// <summary>The taken cells of each row, a bit for each of its 32 columns: a grid is made, copied and counted for every blueprint.</summary>
    private readonly uint[] taken;

    /// <summary>A body without sockets.</summary>
    public SocketGrid() => taken = new uint[CellRows];

    private SocketGrid(SocketGrid other)
    {
        taken = (uint[])other.taken.Clone();
        Refusals = other.Refusals;
        TakenCells = other.TakenCells;
    }

    /// <summary>How many reservations were refused.</summary>
    public int Refusals { get; private set; }

    /// <summary>How many cells are taken, on both sides.</summary>
    public int TakenCells { get; private set; }

    /// <summary>Another grid with the same cells taken.</summary>
    public SocketGrid Copy() => new(this);

    /// <summary>Whether a cell is taken.</summary>
    public bool IsTaken(int ring, int column) => (taken[ring] & (1U << column)) != 0;

    /// <summary>
    /// Whether a socket fits: it and its mirror image lie on the body without touching its end rings, they do not run into one another (a socket on the midline is its own
    /// mirror image), and no cell of theirs is taken, nor any in the <paramref name="pad"/> rings of cells before and behind.
    /// </summary>
    public bool IsFree(SocketBlueprint socket, int pad)
    {
        if (socket.Rows < 1 || socket.Columns < 1 || socket.Columns > BodyGrid.Segments / 2 || socket.Ring < 1 || socket.Ring + socket.Rows > BodyGrid.Rings - 2 || socket.Segment < 0 || socket.Segment >= BodyGrid.Segments)
        {
            return false;
        }

        if (!IsOwnMirror(socket) && CrossesMidline(socket))
        {
            return false;
        }

        int first = Math.Max(0, socket.Ring - pad);
        int end = Math.Min(CellRows, socket.Ring + socket.Rows + pad);
        uint cells = CellsOf(socket);
        for (int i = first; i < end; i++)
        {
            if ((taken[i] & cells) != 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Takes the cells of a socket and of its mirror image if they are free; else counts a refusal and changes nothing.</summary>
    /// <param name="socket">Where it is.</param>
    /// <param name="pad">Rings of cells before and behind it that must be free too; they are not taken.</param>
    public bool TryReserve(SocketBlueprint socket, int pad)
    {
        if (!IsFree(socket, pad))
        {
            Refusals++;
            return false;
        }

        uint cells = CellsOf(socket);
        for (int i = socket.Ring; i < socket.Ring + socket.Rows; i++)
        {
            taken[i] |= cells;
        }

        for (uint left = cells; left != 0; left &= left - 1)
        {
            TakenCells += socket.Rows;
        }

        return true;
    }

    /// <summary>The cells of a socket and of its mirror image in each of its rows.</summary>
    private static uint CellsOf(SocketBlueprint socket)
    {
        uint cells = 0;
        for (int j = 0; j < socket.Columns; j++)
        {
            int column = (socket.Segment + j) % BodyGrid.Segments;
            cells |= (1U << column) | (1U << BodyGrid.MirrorCell(column));
        }

        return cells;
    }

    private static bool IsOwnMirror(SocketBlueprint socket) =>
        BodyGrid.MirrorCell(socket.Segment) == (socket.Segment + socket.Columns - 1) % BodyGrid.Segments;

    private static bool CrossesMidline(SocketBlueprint socket)
    {
        int last = socket.Segment + socket.Columns - 1;
        return last >= BodyGrid.Segments || (socket.Segment < BodyGrid.Segments / 2 && last >= BodyGrid.Segments / 2);
    }
}
