using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Placement;

/// <summary>Places the fins of a swimmer.</summary>
/// <remarks>Based on: A. Christo, "Procedural Creature Generation and Animation for Games" (MSc thesis, Bournemouth University, 2022), section 4.2.2. Fins on the belly are added.</remarks>
internal static class SwimmingRules
{
    /// <summary>First ring that a fin on the midline may cover: the base of the neck lies before it.</summary>
    public const int MidlineFirstRing = StationRing.NeckBase;

    /// <summary>Last ring that a fin on the midline may cover: behind it the back falls to the tail, and a fin would end in a wall there.</summary>
    public const int MidlineLastRing = StationRing.TailBase;

    private const int MinRows = 4;
    private const int MaxRows = 22;
    private const int PectoralRows = 4;
    private const int PectoralColumns = 2;
    private const int Pad = 1;

    private static readonly ScaleRange fin = new(0.75, 1.3);
    private static readonly ScaleRange tail = new(0.8, 1.2);

    /// <summary>Places the fins of a swimmer.</summary>
    /// <param name="measure">Its torso.</param>
    /// <param name="anatomy">The fins of its plan.</param>
    /// <param name="occupied">Cells already taken; not changed.</param>
    /// <param name="seed">Decides; children "dorsal", "ventral", "pectoral" and "tail", and of those one for each fin.</param>
    public static SwimmingPlacement Place(SpineMeasure measure, FinAnatomy anatomy, SocketGrid occupied, Seed seed)
    {
        SocketGrid grid = occupied.Copy();
        var fins = new List<FinPlacement>();
        Midline(measure, anatomy, FinPlace.Dorsal, anatomy.Dorsals, grid, seed.Child("dorsal"), fins);
        Midline(measure, anatomy, FinPlace.Ventral, anatomy.Ventrals, grid, seed.Child("ventral"), fins);
        Pectorals(measure, anatomy, grid, seed.Child("pectoral"), fins);
        RandomStream stream = seed.Child("tail").Stream();
        TailStyle style = anatomy.Tails[Draw(stream, anatomy.Tails, choice => choice.Weight)].Style;
        return new SwimmingPlacement(fins, new TailPlacement(style, tail.DrawEach(stream)));
    }

    /// <summary>For each fin: if a bone is free of crossing the fins already there, a random outline and size on a random free bone.</summary>
    private static void Midline(SpineMeasure measure, FinAnatomy anatomy, FinPlace place, CountRange range, SocketGrid grid, Seed seed, List<FinPlacement> fins)
    {
        int count = range.Draw(seed.Stream());
        for (int k = 0; k < count; k++)
        {
            RandomStream stream = seed.Child(k).Stream();
            FinStyle style = anatomy.Midline[Draw(stream, anatomy.Midline, choice => choice.Weight)].Style;
            PartScale scale = fin.DrawEach(stream);
            int rows = Even(anatomy.MidlineRows.Draw(stream) * scale.Z);
            double choice = stream.Uniform();
            List<(int Bone, SocketBlueprint Socket)> free = FreeBones(measure, anatomy, place, rows, grid);
            if (free.Count == 0)
            {
                continue;
            }

            (int bone, SocketBlueprint socket) = free[(int)(choice * free.Count)];
            grid.TryReserve(socket, Pad);
            fins.Add(new FinPlacement(place, style, bone, socket, scale));
        }
    }

    /// <summary>For each pair: if a place is free of crossing the fins already there, a random outline and size at a random free place.</summary>
    private static void Pectorals(SpineMeasure measure, FinAnatomy anatomy, SocketGrid grid, Seed seed, List<FinPlacement> fins)
    {
        int count = anatomy.Pectorals.Draw(seed.Stream());
        for (int k = 0; k < count; k++)
        {
            RandomStream stream = seed.Child(k).Stream();
            FinStyle style = anatomy.Paired[Draw(stream, anatomy.Paired, choice => choice.Weight)].Style;
            PartScale scale = fin.DrawEach(stream);
            var free = new List<FinSite>();
            foreach (FinSite site in anatomy.Flanks)
            {
                if (grid.IsFree(SocketSizing.Centre(site.Ring, site.Segment, PectoralRows, PectoralColumns), Pad))
                {
                    free.Add(site);
                }
            }

            if (free.Count == 0)
            {
                continue;
            }

            FinSite chosen = free[Draw(stream, free, site => site.Weight)];
            SocketBlueprint socket = SocketSizing.Centre(chosen.Ring, chosen.Segment, PectoralRows, PectoralColumns);
            grid.TryReserve(socket, Pad);
            fins.Add(new FinPlacement(FinPlace.Pectoral, style, measure.BoneAt(chosen.Ring), socket, scale));
        }
    }

    private static List<(int Bone, SocketBlueprint Socket)> FreeBones(SpineMeasure measure, FinAnatomy anatomy, FinPlace place, int rows, SocketGrid grid)
    {
        var free = new List<(int Bone, SocketBlueprint Socket)>();
        foreach (SpineBone bone in measure.Bones)
        {
            int first = (int)Math.Round(bone.Ring, MidpointRounding.ToEven) - (rows / 2);
            var socket = new SocketBlueprint(first, place == FinPlace.Dorsal ? 31 : 15, rows, 2);
            bool onBody = first >= MidlineFirstRing && first + rows <= MidlineLastRing;
            if (onBody && bone.Ring >= anatomy.FirstRing && bone.Ring <= anatomy.LastRing && grid.IsFree(socket, Pad))
            {
                free.Add((bone.Index, socket));
            }
        }

        return free;
    }

    private static int Even(double rows) => Math.Max(MinRows, Math.Min(MaxRows, 2 * (int)Math.Round(0.5 * rows, MidpointRounding.ToEven)));

    /// <summary>The index of one of several choices, each as likely as its weight says.</summary>
    public static int Draw<T>(RandomStream stream, IReadOnlyList<T> choices, Func<T, double> weight)
    {
        Span<double> weights = stackalloc double[choices.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = weight(choices[i]);
        }

        return stream.Weighted(weights);
    }
}
