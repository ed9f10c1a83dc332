using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Idle;

/// <summary>The small steps of a body that has stood for long on legs under it (those out to the side are at the limits of their joints already): twice in two periods a foot off which the weight has gone is set a little ahead or back, and when it is its turn again back home.</summary>
internal struct RestlessFeet
{
    /// <summary>How long it stands with nothing to do before the first step: longer than a recording of it takes, periods and seconds.</summary>
    private const double PatientPeriods = 1.5;
    private const double PatientSeconds = 6;

    /// <summary>When in a period left and right feet carry least, and the resting hind foot is down.</summary>
    private const double LeftTurn = 0.70;
    private const double RightTurn = 0.20;

    /// <summary>How far a foot is set ahead or back, leg lengths.</summary>
    private const float Size = 0.06f;

    private double patience;
    private double before;
    private int steps;
    private bool skipped;

    /// <summary>Is put somewhere else.</summary>
    public void Wake() => patience = 0;

    /// <summary>Lets time pass.</summary>
    /// <param name="body">Whose feet.</param>
    /// <param name="seconds">How long its idle life has been.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="free">Whether it stands with nothing to do.</param>
    /// <param name="leg">Receives the leg that is to step.</param>
    /// <param name="ahead">Receives how far ahead of its home, leg lengths; 0 for home.</param>
    /// <returns>Whether one is.</returns>
    public bool Follow(LeggedBody body, double seconds, float dt, bool free, out int leg, out float ahead)
    {
        double place = seconds / body.Idle.Period;
        place -= Math.Floor(place);
        double last = before;
        before = place;
        leg = -1;
        ahead = 0f;
        patience = free && !body.Sprawls ? patience + dt : 0;
        if (patience < PatientSeconds + (PatientPeriods * body.Idle.Period))
        {
            return false;
        }

        bool left = steps % 2 == 0;
        double turn = left ? LeftTurn : RightTurn;
        if (last >= turn || place < turn)
        {
            return false;
        }

        // A side has its turn in every period: every other of them goes by.
        skipped = left && !skipped;
        if (skipped)
        {
            return false;
        }

        int turns = steps++ / 2;
        int row = turns % body.Rows;
        bool away = turns / body.Rows % 2 == 0;
        leg = Find(body, left ? Side.Left : Side.Right, row);
        ahead = !away ? 0f : (row + steps) % 2 == 0 ? Size : -Size;
        return leg >= 0;
    }

    /// <summary>The leg of a row on a side, −1 for one that rests on its tip at that time.</summary>
    private static int Find(LeggedBody body, Side side, int row)
    {
        for (int i = 0; i < body.Legs.Length; i++)
        {
            if (body.Legs[i].Side == side && body.Legs[i].Row == row)
            {
                return body.RestPitch(i) > 0f ? -1 : i;
            }
        }

        return -1;
    }
}
