using System;
using System.Collections.Generic;

namespace CreatureGen.Sampling.Placement;

/// <summary>
/// The rules by which a walker's legs find their bones. Legs must not overlap, must look balanced, sit where a body could carry them (at its widest), and vary.
/// </summary>
/// <remarks>Based on: A. Christo, "Procedural Creature Generation and Animation for Games" (MSc thesis, Bournemouth University, 2022), section 4.2.3.</remarks>
internal static class LegRules
{
    /// <summary>A bone is nearly as wide as the widest from this part of its width on.</summary>
    public const double NearlyAsWide = 0.75;

    /// <summary>A body is long from this many times its height above the ground on.</summary>
    public const double LongBody = 3;

    /// <summary>Bones on either side of the centre bone that still count as the centre.</summary>
    public const int CentreReach = 2;

    /// <summary>Chooses sockets for legs, in the order in which they were chosen.</summary>
    public static (WalkingRule Rule, List<int> Sockets) Choose(LegField field)
    {
        var chosen = new List<int>();
        int[] byWidth = field.BonesByWidth();
        int first = field.SocketOf(byWidth[0]);
        if (first < 0)
        {
            return (WalkingRule.NoLegs, chosen);
        }

        SpineMeasure measure = field.Measure;
        double widest = measure.Bones[byWidth[0]].HipWidth;
        double narrowest = measure.Bones[byWidth[byWidth.Length - 1]].HipWidth;
        if (measure.BodyLength > LongBody * measure.BodyHeight || narrowest >= NearlyAsWide * widest)
        {
            return (WalkingRule.AsManyAsFit, AsManyAsFit(field));
        }

        chosen.Add(first);
        (int nextBone, int nextSocket) = WidestFree(field, byWidth, chosen);
        if (nextSocket >= 0 && measure.Bones[nextBone].HipWidth >= NearlyAsWide * widest)
        {
            chosen.Add(nextSocket);
            return (WalkingRule.TwoWidest, chosen);
        }

        if (Math.Abs(field[first].Bone - measure.CentreBone) <= CentreReach)
        {
            return (WalkingRule.OnePairAtCentre, chosen);
        }

        int opposite = NearestOpposite(field, first);
        if (opposite < 0)
        {
            return (WalkingRule.WidestAlone, chosen);
        }

        chosen.Add(opposite);
        return (WalkingRule.Counterweight, chosen);
    }

    /// <summary>
    /// As many pairs as fit among the sockets, spread evenly between the first and the last of them; a single one sits at the widest place.
    /// </summary>
    public static List<int> AsManyAsFit(LegField field)
    {
        // Taking always the foremost socket that still fits gives the greatest number of intervals that do not overlap.
        var packed = new List<int>();
        for (int i = 0; i < field.Count; i++)
        {
            if (field.IsFree(i, packed))
            {
                packed.Add(i);
            }
        }

        if (packed.Count == 1)
        {
            packed[0] = WidestSocket(field);
            return packed;
        }

        List<int> spread = Spread(field, packed.Count);
        return spread.Count == packed.Count ? spread : packed;
    }

    /// <summary>Adds free sockets, widest place first, until there are <paramref name="pairs"/> or none is free; gives how many were added.</summary>
    public static int Complete(LegField field, List<int> chosen, int pairs)
    {
        int before = chosen.Count;
        while (chosen.Count < pairs)
        {
            int best = -1;
            for (int i = 0; i < field.Count; i++)
            {
                if (field.IsFree(i, chosen) && (best < 0 || Width(field, i) > Width(field, best)))
                {
                    best = i;
                }
            }

            if (best < 0)
            {
                break;
            }

            chosen.Add(best);
        }

        return chosen.Count - before;
    }

    /// <summary>The usable socket whose foot stands nearest under the centre of mass; −1 when none is usable.</summary>
    public static int UnderMass(LegField field)
    {
        int best = -1;
        double nearest = double.MaxValue;
        for (int i = 0; i < field.Count; i++)
        {
            double off = Math.Abs(field[i].Foot.Z - field.Measure.CentreOfMass.Z);
            if (field.IsUsable(i) && off < nearest)
            {
                best = i;
                nearest = off;
            }
        }

        return best;
    }

    private static (int Bone, int Socket) WidestFree(LegField field, int[] byWidth, List<int> chosen)
    {
        foreach (int bone in byWidth)
        {
            int socket = field.SocketOf(bone);
            if (field.IsFree(socket, chosen))
            {
                return (bone, socket);
            }
        }

        return (-1, -1);
    }

    /// <summary>The socket of the free bone nearest to the first pair on the other side of the centre; a nearer one that leaves the creature unbalanced gives way to the first that does not.</summary>
    private static int NearestOpposite(LegField field, int first)
    {
        SpineMeasure measure = field.Measure;
        int from = field[first].Bone;
        int step = from > measure.CentreBone ? -1 : 1;
        int nearest = -1;
        for (int bone = measure.CentreBone + step; bone >= 0 && bone < measure.Bones.Count; bone += step)
        {
            int socket = field.SocketOf(bone);
            bool opposite = (field[socket].Bone - measure.CentreBone) * step > 0;
            if (!opposite || !field.IsFree(socket, new[] { first }))
            {
                continue;
            }

            nearest = nearest < 0 ? socket : nearest;
            if (field.Correct(new[] { first, socket }).Remedy <= BalanceRemedy.ShiftFeet)
            {
                return socket;
            }
        }

        return nearest;
    }

    private static List<int> Spread(LegField field, int count)
    {
        var spread = new List<int>();
        int front = -1;
        int rear = -1;
        for (int i = 0; i < field.Count; i++)
        {
            if (field.IsUsable(i))
            {
                front = front < 0 ? i : front;
                rear = i;
            }
        }

        for (int k = 0; k < count; k++)
        {
            double ideal = field[front].Along + ((field[rear].Along - field[front].Along) * k / (count - 1));
            int best = -1;
            for (int i = front; i <= rear; i++)
            {
                if (field.IsUsable(i) && (best < 0 || Math.Abs(field[i].Along - ideal) < Math.Abs(field[best].Along - ideal)))
                {
                    best = i;
                }
            }

            if (!field.IsFree(best, spread))
            {
                break;
            }

            spread.Add(best);
        }

        return spread;
    }

    private static int WidestSocket(LegField field)
    {
        int best = -1;
        for (int i = 0; i < field.Count; i++)
        {
            if (field.IsUsable(i) && (best < 0 || Width(field, i) > Width(field, best)))
            {
                best = i;
            }
        }

        return best;
    }

    private static double Width(LegField field, int socket) => field.Measure.At(field[socket].Site.Ring).HipWidth;
}
