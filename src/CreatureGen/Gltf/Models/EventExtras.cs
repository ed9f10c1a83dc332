using System;
using System.Collections.Generic;
using CreatureGen.Json;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf.Models;

/// <summary>Events of a clip in the extras of its animation: <c>events</c>, a list of objects with <c>time</c>, <c>name</c>, <c>joint</c> and <c>strength</c>.</summary>
internal static class EventExtras
{
    private const string Member = "events";

    /// <summary>Writes the member into the object that is open; nothing without events.</summary>
    public static void Write(JsonWriter json, IReadOnlyList<ClipEvent> events)
    {
        if (events.Count == 0)
        {
            return;
        }

        json.Name(Member).BeginArray();
        foreach (ClipEvent one in events)
        {
            json.BeginObject();
            json.Name("time").Number(one.Time);
            json.Name("name").Text(one.Name);
            json.Name("joint").Text(one.Joint);
            json.Name("strength").Number(one.Strength);
            json.EndObject();
        }

        json.EndArray();
    }

    /// <summary>Reads the member; none if it is not there. Extras are anybody's: what is no list of events is passed over.</summary>
    public static IReadOnlyList<ClipEvent> Read(JsonValue? extras, float duration)
    {
        var events = new List<ClipEvent>();
        if (extras is null || ModelDocument.Find(extras, Member) is not { Kind: JsonKind.Array } list)
        {
            return events;
        }

        foreach (JsonValue one in list.Items)
        {
            if (ModelDocument.Find(one, "time") is { Kind: JsonKind.Number } time && ModelDocument.Find(one, "name") is { Kind: JsonKind.Text, Text: { Length: > 0 } name })
            {
                string joint = ModelDocument.Find(one, "joint") is { Kind: JsonKind.Text } at ? at.Text : string.Empty;
                float strength = ModelDocument.Find(one, "strength") is { Kind: JsonKind.Number, Number: >= 0 and <= float.MaxValue } given ? (float)given.Number : 1f;
                if (time.Number >= 0 && time.Number <= duration + 1e-4f)
                {
                    events.Add(new ClipEvent(Math.Min((float)time.Number, duration), name, joint, strength));
                }
            }
        }

        return events;
    }
}
