using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Bodies;

/// <summary>Mixes three base bodies and applies the blueprint's proportions and posture, still as numbers at stations.</summary>
/// <remarks>
/// Based on: the seed thesis, "Base body": lerp(lerp(A, B, w₁), C, w₂). Widths and heights mix by their logarithms: a tenth of a thick body does not fill a wasp's waist.
/// </remarks>
internal static class BodyBlender
{
    /// <summary>The stations of the mixed body.</summary>
    public static BodyStations Blend(BodyBlueprint body)
    {
        BodyTable a = SpeciesCatalogue.Find(body.Blend.First).Table;
        BodyTable b = SpeciesCatalogue.Find(body.Blend.Second).Table;
        BodyTable c = SpeciesCatalogue.Find(body.Blend.Third).Table;
        double w = body.Blend.SecondWeight;
        double v = body.Blend.ThirdWeight;
        var s = new BodyStations
        {
            TopExponent = Mix(a.TopExponent, b.TopExponent, c.TopExponent),
            BottomExponent = Mix(a.BottomExponent, b.BottomExponent, c.BottomExponent),
        };

        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            s.Length[i] = Mix(a.Length[i], b.Length[i], c.Length[i]);
            s.Pitch[i] = Mix(a.Pitch[i], b.Pitch[i], c.Pitch[i]);
            s.Width[i] = PortableMath.Exp(Mix(a.LogWidth[i], b.LogWidth[i], c.LogWidth[i]));
            s.Top[i] = PortableMath.Exp(Mix(a.LogTop[i], b.LogTop[i], c.LogTop[i]));
            s.Bottom[i] = PortableMath.Exp(Mix(a.LogBottom[i], b.LogBottom[i], c.LogBottom[i]));
        }

        ApplyProportions(s, body.Proportions);
        ApplyPosture(s, body.Posture);
        return s;

        double Mix(double x, double y, double z) => Scalar.Lerp(Scalar.Lerp(x, y, w), z, v);
    }

    private static void ApplyProportions(BodyStations s, BodyProportions p)
    {
        double headLength = PortableMath.Pow(p.Head, 0.6);
        ScaleLength(s, 1, 5, headLength);
        ScaleLength(s, 1, 3, p.Snout);
        ScaleLength(s, 6, 8, p.Neck);
        ScaleLength(s, 14, 17, p.Tail);

        ScaleSection(s, 0, 5, p.Head);
        ScaleSection(s, 6, 6, 1 + ((p.Head - 1) * 0.6));
        ScaleSection(s, 7, 7, (1 + ((p.Head - 1) * 0.3)) * p.NeckGirth);
        ScaleSection(s, 8, 8, (1 + ((p.Chest - 1) * 0.5)) * (0.5 + (0.5 * p.NeckGirth)));
        ScaleSection(s, 9, 10, p.Chest);
        ScaleSection(s, 12, 13, p.Rump);
        ScaleSection(s, 14, 16, p.TailGirth);
        for (int i = 9; i <= 12; i++)
        {
            s.Width[i] *= p.Girth;
            s.Top[i] *= 1 + ((p.Girth - 1) * 0.7);
            s.Bottom[i] *= 1 + ((p.Girth - 1) * 0.7);
        }

        for (int i = 9; i <= 10; i++)
        {
            s.Top[i] *= p.Hump;
            s.Bottom[i + 1] *= p.Belly;
        }
    }

    private static void ApplyPosture(BodyStations s, BodyPosture p)
    {
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            int ring = BodyGrid.StationRings[i];
            double neck = i <= 5 ? 0 : i == 6 ? 0.5 : i <= 8 ? 1 : 0;
            double tail = i < 14 ? 0 : i == 14 ? 0.4 : i == 15 ? 0.8 : 1;

            // The neck bends from its base up to the nape; the head turns back by three quarters, so that it looks ahead.
            double neckBend = ring >= 24 ? 0 : ring >= 16 ? (24 - ring) / 8.0 : 0.25;
            double tailBend = ring <= 42 ? 0 : (ring - 42) / 12.0;
            s.Pitch[i] += (i <= 5 ? p.Head : 0)
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

/// <summary>A body as numbers at stations, on its way from the base bodies to the rings. Metres and radians.</summary>
internal sealed class BodyStations
{
    public double[] Length { get; } = new double[BodyGrid.StationCount];

    public double[] Pitch { get; } = new double[BodyGrid.StationCount];

    public double[] Width { get; } = new double[BodyGrid.StationCount];

    public double[] Top { get; } = new double[BodyGrid.StationCount];

    public double[] Bottom { get; } = new double[BodyGrid.StationCount];

    public double TopExponent { get; init; }

    public double BottomExponent { get; init; }
}
