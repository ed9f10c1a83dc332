using System;
using System.Collections.Generic;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Seeding;

namespace CreatureGen.Motion;

/// <summary>What a creature that stands about does by itself, as a function of time and seed: time is cut into slots, in most of which one act begins if the creature has nothing else to do.</summary>
internal sealed class IdleActs
{
    /// <summary>Seconds of a slot of a kilogram; ∝ M^0.08.</summary>
    private const double PeriodAtOneKilogram = 13;

    /// <summary>Part of a slot within which an act begins, and slots in which one does.</summary>
    private const double Beginning = 0.6;
    private const double Busy = 0.75;

    /// <summary>Seconds for which it stands about before it does anything.</summary>
    private const float Patience = 2.5f;

    // What it does, and how often beside the others. None of it needs anything but itself.
    private static readonly (string Name, double Weight)[] usual = { ("Sniff", 3), ("Groom", 2), ("Scratch", 2), ("Shake", 1.5), ("Call", 1), ("Sit", 1) };

    private readonly List<(ActAbility Ability, double UpTo)> choices = new();
    private readonly Seed habits;
    private readonly double period;
    private State now;
    private State kept;

    /// <summary>What one creature on the scene does.</summary>
    /// <param name="acts">What it can do.</param>
    /// <param name="habits">Of this individual.</param>
    public IdleActs(CreatureActs acts, Seed habits)
    {
        this.habits = habits;
        period = PeriodAtOneKilogram * PortableMath.Pow(acts.Body.Subject.Mass.Mass, 0.08);
        double sum = 0;
        foreach ((string name, double weight) in usual)
        {
            if (acts.Find(name) is { IsPossible: true } ability)
            {
                sum += weight;
                choices.Add((ability, sum));
            }
        }
    }

    /// <summary>Lets time pass.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="readiness">How readily it does something by itself, a factor on how often; 0 while it has something else to do.</param>
    /// <param name="performed">What it performs at present.</param>
    /// <param name="next">Receives what it begins.</param>
    public IdleChange Advance(float dt, float readiness, Act? performed, out ActAbility? next)
    {
        next = null;
        bool own = performed != null && ReferenceEquals(performed, now.Act);
        now.Act = own ? performed : null;
        if (readiness <= 0f)
        {
            now.Waited = 0f;
            now.Act = null;
            return own ? IdleChange.BreaksOff : IdleChange.None;
        }

        now.Clock += dt * readiness;
        now.Waited += dt;
        int slot = Slots.At(now.Clock, period, out double since);
        if (slot == now.Done)
        {
            return IdleChange.None;
        }

        Seed drawn = habits.Child(slot);
        if (since < Slots.Number(drawn, 0) * Beginning * period)
        {
            return IdleChange.None;
        }

        now.Done = slot;
        if (own)
        {
            return IdleChange.GoesOn;
        }

        if (performed != null || now.Waited < Patience || choices.Count == 0 || Slots.Number(drawn, 1) >= Busy)
        {
            return IdleChange.None;
        }

        double at = Slots.Number(drawn, 2) * choices[^1].UpTo;
        int index = 0;
        while (at >= choices[index].UpTo)
        {
            index++;
        }

        next = choices[index].Ability;
        now.Act = next.Act;
        return IdleChange.Begins;
    }

    /// <summary>Keeps what was before an update.</summary>
    public void Keep() => kept = now;

    /// <summary>Goes back to it.</summary>
    public void Undo() => now = kept;

    private struct State
    {
        public double Clock;
        public float Waited;
        /// <summary>The slot that is over; the first has nothing before it.</summary>
        public int? Done;
        public Act? Act;
    }
}

/// <summary>What becomes of what a creature does by itself.</summary>
internal enum IdleChange
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It begins something.</summary>
    Begins,

    /// <summary>It leaves what lasts.</summary>
    GoesOn,

    /// <summary>It has something else to do.</summary>
    BreaksOff,
}
