using System;
using System.Collections.Generic;
using System.Linq;

namespace CreatureGen.Tests.Conventions;

/// <summary>The rooms of the house and which rooms each may know, as docs/architecture.md lists them. A room is named by its folder; the library's own folder is <c>./</c>.</summary>
internal sealed class RoomTable
{
    private readonly Dictionary<string, string[]> known;

    private RoomTable(IReadOnlyList<(string Room, string[] Known)> rows)
    {
        Rooms = rows.Select(r => r.Room).ToArray();
        known = rows.ToDictionary(r => r.Room, r => r.Known, StringComparer.Ordinal);
    }

    /// <summary>The rooms in the order of the table: lower rooms first.</summary>
    public IReadOnlyList<string> Rooms { get; }

    /// <summary>The rooms that a room may know, without itself.</summary>
    public IReadOnlyList<string> KnownTo(string room) => known[room];

    /// <summary>Whether code of one room may use code of another.</summary>
    public bool Allows(string room, string other) => room == other || known[room].Contains(other);

    /// <summary>The table of the committed page.</summary>
    public static RoomTable Read() => Parse(RepositoryFiles.Text("docs/architecture.md"));

    /// <summary>Finds the rows that begin with a folder: its name, what it is for, and the rooms it may know, divided by commas.</summary>
    /// <exception cref="FormatException">There is no row, or a room has two.</exception>
    public static RoomTable Parse(string page)
    {
        var rows = new List<(string Room, string[] Known)>();
        foreach (string[] cells in page.Split('\n').Where(l => l.StartsWith("| `", StringComparison.Ordinal)).Select(l => l.Split('|', StringSplitOptions.TrimEntries)))
        {
            string room = cells[1].Trim('`').TrimEnd('/');
            string[] names = cells[^2] == "–" ? [] : cells[^2].Split(',', StringSplitOptions.TrimEntries);
            rows.Add((room, names));
        }

        if (rows.Count == 0 || rows.Select(r => r.Room).Distinct().Count() != rows.Count)
        {
            throw new FormatException($"{rows.Count} rows of rooms; expected a table with one row for each room");
        }

        return new RoomTable(rows);
    }

    /// <summary>The room that a folder of the library is in: the nearest folder upwards that has a row; null when none has.</summary>
    public string? RoomOf(string? folder)
    {
        while (folder != null && !known.ContainsKey(folder))
        {
            int slash = folder.LastIndexOf('/');
            folder = slash < 0 ? null : folder[..slash];
        }

        return folder;
    }
}
