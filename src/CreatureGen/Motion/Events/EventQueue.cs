using System;

namespace CreatureGen.Motion.Events;

/// <summary>What happened in the last update. Of fixed size: nothing is allocated.</summary>
internal sealed class EventQueue
{
    private readonly MotionEvent[] events;
    private int count;

    public EventQueue(int capacity) => events = new MotionEvent[capacity];

    /// <summary>What happened, in order.</summary>
    public ReadOnlySpan<MotionEvent> Items => events.AsSpan(0, count);

    /// <summary>Seconds of the update that come after the piece of it that is gone through at present: what happens in that is so much longer ago.</summary>
    public float Left { get; set; }

    public void Clear() => (count, Left) = (0, 0f);

    /// <summary>Notes an event; the capacity is that of the quickest gait in the longest update.</summary>
    public void Add(in MotionEvent item)
    {
        if (count < events.Length)
        {
            events[count++] = item with { SecondsAgo = item.SecondsAgo + Left };
        }
    }
}
