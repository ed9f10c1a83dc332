using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>Checks that sockets lie within the grid of the body, on the side they belong to, clear of the mouth and of one another.</summary>
internal static class SocketRules
{
    /// <summary>Ring of the last vertices that a socket may reach; the tip of the tail keeps its own.</summary>
    private const int LastRing = BodyGrid.Rings - 2;

    /// <summary>Cells across the midline that a fin on it takes.</summary>
    public const int MidlineColumns = 2;

    /// <summary>First segment of a fin on the back.</summary>
    public const int DorsalSegment = BodyGrid.Segments - 1;

    /// <summary>First segment of a fin under the belly.</summary>
    public const int VentralSegment = (BodyGrid.Segments / 2) - 1;

    /// <summary>More sockets than all lists together may have are not compared.</summary>
    private const int MaxSockets = 64;

    /// <summary>Lists what is wrong with the sockets that are in range one by one.</summary>
    public static void Check(CreatureBlueprint blueprint, ProblemList problems)
    {
        List<Place> places = Collect(blueprint);
        foreach (Place place in places)
        {
            CheckPlace(place, problems);
            CheckMouth(place, blueprint.Head?.Mouth?.CornerRing ?? 0, problems);
        }

        for (int i = 1; i < places.Count; i++)
        {
            for (int k = 0; k < i; k++)
            {
                if (places[i].SharesCellsWith(places[k]))
                {
                    problems.Add(places[i].Path, places[i].ToString(), "no cell that " + places[k].Path + " takes (" + places[k] + ")");
                }
            }
        }
    }

    private static List<Place> Collect(CreatureBlueprint blueprint)
    {
        var places = new List<Place>();
        Add("legs", blueprint.Legs, leg => leg.Socket, _ => FinPlace.Pectoral);
        Add("wings", blueprint.Wings, wing => wing.Socket, _ => FinPlace.Pectoral);
        Add("fins", blueprint.Fins, fin => fin.Socket, fin => fin.Place);
        Add("ears", blueprint.Ears, ear => ear.Socket, _ => FinPlace.Pectoral);
        return places;

        void Add<T>(string list, ValueList<T>? items, Func<T, SocketBlueprint> socketOf, Func<T, FinPlace> placeOf)
            where T : IEquatable<T>
        {
            for (int i = 0; i < (items?.Count ?? 0) && places.Count < MaxSockets; i++)
            {
                SocketBlueprint socket = socketOf(items![i]);
                if (FieldChecker.Accepts(socket, LimbFields.Socket))
                {
                    places.Add(new Place(FormattableString.Invariant($"{list}[{i}].socket"), socket, placeOf(items[i])));
                }
            }
        }
    }

    private static void CheckPlace(Place place, ProblemList problems)
    {
        SocketBlueprint socket = place.Socket;
        if (socket.Ring + socket.Rows > LastRing)
        {
            problems.Add(place.Path, place.ToString(), FormattableString.Invariant($"rings within 1..{LastRing}"));
        }

        int? midline = place.On switch { FinPlace.Dorsal => DorsalSegment, FinPlace.Ventral => VentralSegment, _ => null };
        if (midline is int segment && (socket.Segment != segment || socket.Columns != MidlineColumns))
        {
            string name = AnatomyChoices.FinPlace.NameOf(place.On)!;
            problems.Add(place.Path, place.ToString(), FormattableString.Invariant($"segment {segment} and {MidlineColumns} columns for a {name} fin"));
        }

        if (midline is null && socket.Segment + socket.Columns > BodyGrid.Segments / 2)
        {
            problems.Add(place.Path, place.ToString(), FormattableString.Invariant($"segments within 0..{BodyGrid.Segments / 2}, the left side"));
        }
    }

    /// <summary>Below the slit the body uses the lower lip's vertices, which no socket's border knows: a socket across the slit or right below it would tear the surface.</summary>
    private static void CheckMouth(Place place, int cornerRing, ProblemList problems)
    {
        SocketBlueprint socket = place.Socket;
        bool tearsLips = socket.Segment <= BodyGrid.LipSegment && socket.Segment + socket.Columns > BodyGrid.LipSegment;
        if (tearsLips && socket.Ring < cornerRing)
        {
            problems.Add(
                place.Path,
                place.ToString(),
                FormattableString.Invariant($"rings from {cornerRing} on, or segments up to {BodyGrid.LipSegment} or from {BodyGrid.LipSegment + 1} on, clear of the mouth"));
        }
    }

    /// <summary>A socket and where it stands in the blueprint.</summary>
    private sealed class Place
    {
        private readonly uint columns;

        public Place(string path, SocketBlueprint socket, FinPlace on)
        {
            Path = path;
            Socket = socket;
            On = on;
            for (int c = 0; c < socket.Columns; c++)
            {
                int column = (socket.Segment + c) % BodyGrid.Segments;
                columns |= (1u << column) | (1u << BodyGrid.MirrorCell(column));
            }
        }

        public string Path { get; }

        public SocketBlueprint Socket { get; }

        /// <summary>The midline of back or belly, or the side, where all but midline fins grow.</summary>
        public FinPlace On { get; }

        /// <summary>Whether the sockets, with their mirror images, have a cell in common.</summary>
        public bool SharesCellsWith(Place other) =>
            (columns & other.columns) != 0
            && Socket.Ring < other.Socket.Ring + other.Socket.Rows
            && other.Socket.Ring < Socket.Ring + Socket.Rows;

        public override string ToString() =>
            FormattableString.Invariant($"rings {Socket.Ring}..{Socket.Ring + Socket.Rows}, segments {Socket.Segment}..{Socket.Segment + Socket.Columns}");
    }
}
