using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Motion;

namespace CreatureGen.Lab.Runtime;

/// <summary>Where creatures live: one in each slot that is taken, on one ground.</summary>
internal sealed class Stage
{
    public const int MaxSlots = 64;

    /// <summary>
    /// Creatures that move in every frame at most: the one that is looked at and those nearest to it. The others take turns: those that have waited longest come first, as many as there is time for. Where so many take too long,
    /// fewer move in every frame, so that one turn is left; where there is not even time for that, there is one in every other frame.
    /// </summary>
    private const int MaxNear = 4;

    /// <summary>Milliseconds of a frame that those who move are not to pass, if the next one takes as long as the ones before.</summary>
    private const double Budget = 1.7;

    /// <summary>How much of what a move takes is taken from the last frame.</summary>
    private const double Freshness = 0.1;

    /// <summary>Longest move of who moves in every frame and of who takes turns, seconds. A long one takes hardly more time than a short one.</summary>
    private const float LongestStep = 0.1f;
    private const float LongestTurn = 0.2f;

    private const int MomentLength = 6;

    private static readonly Comparer<Actor> longestWait = Comparer<Actor>.Create(static (a, b) => a.Passed != b.Passed ? b.Passed.CompareTo(a.Passed) : a.Slot.CompareTo(b.Slot));

    private readonly Actor?[] slots = new Actor?[MaxSlots];
    private readonly List<Actor> living = [];
    private float[] frame = GC.AllocateArray<float>(1 << 15, pinned: true);
    private double moveMilliseconds = 0.3;
    private double turnMilliseconds = 0.3;
    private bool turned;

    /// <summary>What they stand on.</summary>
    public Land Land { get; private set; } = Land.Plane;

    /// <summary>Address of the numbers of the last frame.</summary>
    public unsafe int FrameAddress => (int)(nint)System.Runtime.CompilerServices.Unsafe.AsPointer(ref MemoryMarshal.GetArrayDataReference(frame));

    /// <summary>Who lives in a slot.</summary>
    public Actor this[int slot] => (uint)slot < MaxSlots && slots[slot] is { } actor ? actor : throw new ArgumentException(FormattableString.Invariant($"nobody lives in slot {slot}"));

    public IReadOnlyList<Actor> Living => living;

    public void Lay(ReadOnlySpan<float> heights, int columns, float cell, float corner, float surface)
    {
        Land = new Land(heights, columns, cell, corner, surface);
        foreach (Actor actor in living)
        {
            actor.StandAnew(Land);
        }
    }

    /// <summary>Lets a creature live in a slot, where the one before it was, with its habits.</summary>
    public void Settle(int slot, Creature creature, CreatureBlueprint design)
    {
        if ((uint)slot >= MaxSlots)
        {
            throw new ArgumentException(FormattableString.Invariant($"slot {slot}; expected 0 to {MaxSlots - 1}"));
        }

        var actor = new Actor(slot, creature, design, slots[slot]?.Mind ?? new Mind(slot));
        if (slots[slot] is { } before)
        {
            actor.TakePlaceOf(before, Land);
            living.Remove(before);
        }
        else
        {
            actor.Place(0f, 0f, 0f, 0f, Land);
        }

        slots[slot] = actor;
        living.Add(actor);
    }

    public void Remove(int slot)
    {
        living.Remove(this[slot]);
        slots[slot] = null;
    }

    /// <summary>Calls a creature to a place; one that swims in a lake comes as near as the lake lets it.</summary>
    public void Send(int slot, float x, float z)
    {
        Actor actor = this[slot];
        if (actor.Abilities.Medium == Medium.Water && float.IsFinite(Land.Surface))
        {
            actor.Mind.ComeNear(x, z);
        }
        else
        {
            actor.Mind.GoTo(x, z);
        }
    }

    /// <summary>Moves those on whose turn it is, and writes them: their number, the number of moments, then each creature, then each moment as kind, slot, place and strength.</summary>
    /// <param name="seconds">Since the last call.</param>
    /// <param name="eye">The slot that is looked at.</param>
    /// <returns>How many numbers were written.</returns>
    public int Frame(float seconds, int eye)
    {
        long begin = Stopwatch.GetTimestamp();
        Rank(eye);
        int at = 2;
        foreach (Actor actor in living)
        {
            actor.Wait(seconds);
        }

        int near = Math.Min(living.Count, Math.Clamp((int)((Budget - turnMilliseconds) / Math.Max(moveMilliseconds, 0.01)), 1, MaxNear));
        for (int rank = 0; rank < near; rank++)
        {
            at = Move(living[rank], LongestStep, at);
        }

        double passed = Stopwatch.GetElapsedTime(begin).TotalMilliseconds;
        moveMilliseconds += Freshness * ((passed / Math.Max(near, 1)) - moveMilliseconds);
        living.Sort(near, living.Count - near, longestWait);
        int moved = near;
        while (moved < living.Count && (passed + turnMilliseconds <= Budget || (moved == near && !turned)))
        {
            at = Move(living[moved], LongestTurn, at);
            double till = Stopwatch.GetElapsedTime(begin).TotalMilliseconds;
            turnMilliseconds += Freshness * (till - passed - turnMilliseconds);
            passed = till;
            moved++;
        }

        turned = moved > near;
        frame[0] = moved;
        frame[1] = 0f;
        foreach (Actor actor in living)
        {
            foreach (Moment moment in actor.Moments)
            {
                Room(at, MomentLength);
                frame[at] = (float)moment.Kind;
                frame[at + 1] = actor.Slot;
                moment.Place.CopyTo(frame, at + 2);
                frame[at + 5] = moment.Strength;
                at += MomentLength;
                frame[1]++;
            }

            actor.Moments.Clear();
        }

        return at;
    }

    /// <summary>Moves one on and writes it.</summary>
    /// <returns>The index after what was written.</returns>
    private int Move(Actor actor, float longest, int at)
    {
        actor.Move(this, longest);
        return actor.Write(Room(at, actor.FrameLength), at);
    }

    private float[] Room(int at, int more)
    {
        if (at + more > frame.Length)
        {
            float[] larger = GC.AllocateArray<float>(2 * (at + more), pinned: true);
            frame.AsSpan(0, at).CopyTo(larger);
            frame = larger;
        }

        return frame;
    }

    private void Rank(int eye)
    {
        Vector3 centre = (uint)eye < MaxSlots && slots[eye] is { } looked ? looked.Position : Vector3.Zero;
        foreach (Actor actor in living)
        {
            float x = actor.Position.X - centre.X;
            float z = actor.Position.Z - centre.Z;
            actor.Distance = actor.Slot == eye ? -1f : (x * x) + (z * z);
        }

        living.Sort(static (a, b) => a.Distance != b.Distance ? a.Distance.CompareTo(b.Distance) : a.Slot.CompareTo(b.Slot));
    }
}
