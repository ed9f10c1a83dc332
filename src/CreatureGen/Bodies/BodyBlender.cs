using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Bodies;

/// <summary>Mixes base bodies, each region in its own shares, and applies the blueprint's proportions and posture, still as numbers at stations.</summary>
/// <remarks>
/// Based on: the seed thesis, "Base body": lerp(lerp(A, B, w₁), C, w₂). Widths and heights mix by their logarithms: a tenth of a thick body does not fill a wasp's waist.
/// </remarks>
internal static class BodyBlender
{
    /// <summary>How far a station belongs to the head: the neck goes over to the torso.</summary>
    private static readonly double[] headness = { 1, 1, 1, 1, 1, 1, 0.75, 0.5, 0.2, 0, 0, 0, 0, 0, 0, 0, 0, 0 };

    /// <summary>Thinnest loin of a body that takes from insects without being one, against its pelvis: thinner it is a waist before an abdomen, which legs under the rump do not bear.</summary>
    private const double Loin = 0.92;

    /// <summary>How far a station belongs to the tail: the rump goes over to the torso.</summary>
    private static readonly double[] tailness = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.25, 0.6, 1, 1, 1 };

    // The first station that a hump raises, and by how much of it each does: one that rose and fell within a station would be a corner before the shoulder and a step behind it.
    private const int FirstHumped = 8;
    private static readonly double[] humped = { 0.3, 0.9, 1, 0.4 };

    /// <summary>The stations of the mixed body, whatever its posture.</summary>
    public static BodyStations Blend(BodyBlueprint body)
    {
        ValueList<MixedBody> parts = body.Blend.Bodies;
        var tables = new BodyTable[parts.Count];
        for (int k = 0; k < tables.Length; k++)
        {
            tables[k] = SpeciesCatalogue.Find(parts[k].Name).Table;
        }

        double topExponent = tables[0].TopExponent;
        double bottomExponent = tables[0].BottomExponent;
        for (int k = 1; k < tables.Length; k++)
        {
            topExponent = Scalar.Lerp(topExponent, tables[k].TopExponent, parts[k].Torso);
            bottomExponent = Scalar.Lerp(bottomExponent, tables[k].BottomExponent, parts[k].Torso);
        }

        var s = new BodyStations { TopExponent = topExponent, BottomExponent = bottomExponent };
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            BodyTable first = tables[0];
            (double length, double width, double top, double bottom) = (first.Length[i], first.LogWidth[i], first.LogTop[i], first.LogBottom[i]);
            for (int k = 1; k < tables.Length; k++)
            {
                double weight = WeightAt(i, parts[k]);
                BodyTable next = tables[k];
                length = Scalar.Lerp(length, next.Length[i], weight);
                width = Scalar.Lerp(width, next.LogWidth[i], weight);
                top = Scalar.Lerp(top, next.LogTop[i], weight);
                bottom = Scalar.Lerp(bottom, next.LogBottom[i], weight);
            }

            s.Length[i] = length;
            s.Width[i] = PortableMath.Exp(width);
            s.Top[i] = PortableMath.Exp(top);
            s.Bottom[i] = PortableMath.Exp(bottom);
        }

        if (TakesFromInsects(parts))
        {
            FillWaist(s);
        }

        ApplyProportions(s, body.Proportions);
        return s;
    }

    /// <summary>The pitch of the mixed body's spine at its stations in its posture, radians; no proportion changes it.</summary>
    public static void Pitch(BodyBlueprint body, Span<double> pitch)
    {
        ValueList<MixedBody> parts = body.Blend.Bodies;
        SpeciesCatalogue.Find(parts[0].Name).Table.Pitch.CopyTo(pitch);
        for (int k = 1; k < parts.Count; k++)
        {
            double[] next = SpeciesCatalogue.Find(parts[k].Name).Table.Pitch;
            for (int i = 0; i < BodyGrid.StationCount; i++)
            {
                pitch[i] = Scalar.Lerp(pitch[i], next[i], WeightAt(i, parts[k]));
            }
        }

        ApplyPosture(pitch, body.Posture);
    }

    /// <summary>The weight of a body at a station.</summary>
    private static double WeightAt(int station, MixedBody part) =>
        Scalar.Lerp(Scalar.Lerp(part.Torso, part.Head, headness[station]), part.Tail, tailness[station]);

    private static bool TakesFromInsects(ValueList<MixedBody> parts)
    {
        bool insects = false;
        for (int k = 1; k < parts.Count; k++)
        {
            insects |= parts[k].Torso > 0 && SpeciesCatalogue.Find(parts[k].Name).Class == AnimalClass.Arthropod;
        }

        return insects && SpeciesCatalogue.Find(parts[0].Name).Class != AnimalClass.Arthropod;
    }

    private static void FillWaist(BodyStations s)
    {
        const int At = 12;
        const int Pelvis = 13;
        s.Width[At] = Math.Max(s.Width[At], Loin * s.Width[Pelvis]);
        s.Top[At] = Math.Max(s.Top[At], Loin * s.Top[Pelvis]);
        s.Bottom[At] = Math.Max(s.Bottom[At], Loin * s.Bottom[Pelvis]);
    }

    private static void ApplyProportions(BodyStations s, BodyProportions p)
    {
        double headLength = PortableMath.Pow(p.Head, 0.6);
        ScaleLength(s, 1, 5, headLength);
        ScaleLength(s, 1, 3, p.Snout);
        ScaleLength(s, 6, 8, p.Neck);
        ScaleLength(s, 14, 17, p.Tail);

        ScaleSection(s, 0, 5, p.Head);
        // The nape goes half of the way with the neck; the base of the neck goes half of the way with a chest that grows, and all of it with one that gives way, or it would stand out before it as a corner.
        ScaleSection(s, 6, 6, (1 + ((p.Head - 1) * 0.6)) * (0.5 + (0.5 * p.NeckGirth)));
        ScaleSection(s, 7, 7, (1 + ((p.Head - 1) * 0.3)) * p.NeckGirth);
        ScaleSection(s, 8, 8, Math.Min(p.Chest, 1 + ((p.Chest - 1) * 0.5)) * (0.5 + (0.5 * p.NeckGirth)));
        ScaleSection(s, 9, 10, p.Chest);
        ScaleSection(s, 12, 13, p.Rump);
        ScaleSection(s, 14, 16, p.TailGirth);
        for (int i = 9; i <= 12; i++)
        {
            s.Width[i] *= p.Girth;
            s.Top[i] *= 1 + ((p.Girth - 1) * 0.7);
            s.Bottom[i] *= 1 + ((p.Girth - 1) * 0.7);
        }

        for (int i = 0; i < humped.Length; i++)
        {
            s.Top[FirstHumped + i] *= 1 + (humped[i] * (p.Hump - 1));
        }

        for (int i = 10; i <= 11; i++)
        {
            s.Bottom[i] *= p.Belly;
        }
    }

    private static void ApplyPosture(Span<double> pitch, BodyPosture p)
    {
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            int ring = BodyGrid.StationRings[i];
            double neck = i <= 5 ? 0 : i == 6 ? 0.5 : i <= 8 ? 1 : 0;
            double tail = i < 14 ? 0 : i == 14 ? 0.4 : i == 15 ? 0.8 : 1;

            // The neck bends from its base up to the nape; the head turns back by three quarters, so that it looks ahead.
            double neckBend = ring >= 24 ? 0 : ring >= StationRing.Nape ? (24 - ring) / 8.0 : 0.25;
            double tailBend = ring <= StationRing.Pelvis ? 0 : (ring - StationRing.Pelvis) / 12.0;
            pitch[i] += (i <= 5 ? p.Head : 0)
                + (neck * p.Neck)
                + (i is >= 9 and <= 12 ? p.Torso : 0)
                + (tail * p.Tail)
                + (neckBend * BodyGrid.NeckBones * p.NeckBend)
                + (tailBend * BodyGrid.TailBones * p.TailBend);
        }
    }

    private static void ScaleLength(BodyStations s, int first, int last, double factor)
    {
        for (int i = first; i <= last; i++)
        {
            s.Length[i] *= factor;
        }
    }

    private static void ScaleSection(BodyStations s, int first, int last, double factor)
    {
        for (int i = first; i <= last; i++)
        {
            s.Width[i] *= factor;
            s.Top[i] *= factor;
            s.Bottom[i] *= factor;
        }
    }
}

/// <summary>A body as numbers at stations, on its way from the base bodies to the rings. Metres.</summary>
internal sealed class BodyStations
{
    public double[] Length { get; } = new double[BodyGrid.StationCount];

    public double[] Width { get; } = new double[BodyGrid.StationCount];

    public double[] Top { get; } = new double[BodyGrid.StationCount];

    public double[] Bottom { get; } = new double[BodyGrid.StationCount];

    public double TopExponent { get; init; }

    public double BottomExponent { get; init; }
}
