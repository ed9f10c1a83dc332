using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Motion;

namespace CreatureGen.Lab.Runtime;

/// <summary>Where creatures live: one in each slot that is taken, on one ground.</summary>
internal sealed class Stage
{
    public const int MostSlots = 64;

    /// <summary>Creatures that move in every frame: the one that is looked at and those nearest to it. The others take turns.</summary>
    private const int NearCount = 4;
    private const int MiddleCount = 10;

    private readonly Actor?[] slots = new Actor?[MostSlots];
    private readonly List<Actor> living = [];
    private float[] frame = GC.AllocateArray<float>(1 << 15, pinned: true);
    private int count;

    /// <summary>What they stand on.</summary>
    public Land Land { get; private set; } = Land.Plane;

    /// <summary>Address of the numbers of the last frame.</summary>
    public unsafe int FrameAddress => (int)(nint)System.Runtime.CompilerServices.Unsafe.AsPointer(ref MemoryMarshal.GetArrayDataReference(frame));

    /// <summary>Who lives in a slot.</summary>
    public Actor this[int slot] => (uint)slot < MostSlots && slots[slot] is { } actor ? actor : throw new ArgumentException(FormattableString.Invariant($"nobody lives in slot {slot}"));

    public IReadOnlyList<Actor> Living => living;

    public void Lay(ReadOnlySpan<float> heights, int columns, float cell, float corner)
    {
        Land = new Land(heights, columns, cell, corner);
        foreach (Actor actor in living)
        {
            actor.StandAnew(Land);
        }
    }

    /// <summary>Lets a creature live in a slot, where the one before it was, with its habits.</summary>
    public void Settle(int slot, Creature creature, CreatureBlueprint design)
    {
        if ((uint)slot >= MostSlots)
        {
            throw new ArgumentException(FormattableString.Invariant($"slot {slot}; expected 0 to {MostSlots - 1}"));
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

    /// <summary>Moves all on, and writes those that moved: their number, the number of footfalls, then each creature, then each footfall.</summary>
    /// <param name="seconds">Since the last call.</param>
    /// <param name="eye">The slot that is looked at.</param>
    /// <returns>How many numbers were written.</returns>
    public int Frame(float seconds, int eye)
    {
        count++;
        Rank(eye);
        int at = 2;
        int moved = 0;
        for (int rank = 0; rank < living.Count; rank++)
        {
            Actor actor = living[rank];
            actor.Wait(seconds);
            int turns = rank < NearCount ? 1 : rank < MiddleCount ? 2 : 4;
            if ((count + actor.Slot) % turns == 0)
            {
                actor.Move(this);
                at = actor.Write(Room(at, actor.FrameLength), at);
                moved++;
            }
        }

        frame[0] = moved;
        frame[1] = 0f;
        foreach (Actor actor in living)
        {
            foreach (Vector4 step in actor.Footfalls)
            {
                Room(at, 4);
                new Vector4(step.X, step.Y, step.Z, step.W).CopyTo(frame, at);
                at += 4;
                frame[1]++;
            }

            actor.Footfalls.Clear();
        }

        return at;
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
        Vector3 centre = (uint)eye < MostSlots && slots[eye] is { } looked ? looked.Position : Vector3.Zero;
        foreach (Actor actor in living)
        {
            float x = actor.Position.X - centre.X;
            float z = actor.Position.Z - centre.Z;
            actor.Distance = actor.Slot == eye ? -1f : (x * x) + (z * z);
        }

        living.Sort(static (a, b) => a.Distance != b.Distance ? a.Distance.CompareTo(b.Distance) : a.Slot.CompareTo(b.Slot));
    }
}
