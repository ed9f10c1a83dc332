using System;
using System.Globalization;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Maths;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>The spines of nine animals as station tables (length, pitch in degrees, half width, height above and below the spine; lengths in millimetres, nose to tail).</summary>
internal static class BaseBodySpines
{
    private const string Canine = "0/-16/42/36/36 30/-16/64/56/54 65/-16/70/58/60 65/-20/86/70/70 50/-24/118/122/80 80/-15/142/132/100 100/12/105/100/105 130/60/108/110/120 140/58/135/140/170 140/26/170/170/230 250/2/190/165/265 250/-2/155/150/190 220/-2/130/150/135 200/2/150/150/160 140/25/58/66/66 160/30/50/55/55 180/15/45/50/50 160/-5/16/16/16";
    private const string Bovine = "0/-38/70/55/55 45/-36/108/80/76 65/-36/98/80/76 75/-38/100/98/85 80/-38/128/115/95 80/-30/135/120/110 100/0/125/120/130 130/42/140/160/180 140/38/180/210/250 150/12/215/250/290 260/0/245/235/310 260/-1/260/215/320 240/0/235/205/270 220/2/205/195/220 140/35/65/75/75 130/70/28/30/30 160/80/22/24/24 160/82/26/30/30";
    private const string Feline = "0/-10/45/34/36 25/-10/72/52/56 40/-10/86/60/68 45/-16/104/80/80 45/-22/136/128/90 80/-15/152/138/102 100/10/108/100/100 110/56/100/105/110 130/52/125/130/150 130/22/155/160/190 260/0/162/150/200 270/-2/152/148/170 240/0/135/148/140 220/3/145/150/155 130/22/58/60/60 280/35/42/42/42 300/5/40/40/40 260/-45/28/28/28";
    private const string Reptile = "0/-4/40/24/26 50/-4/60/35/36 110/-4/68/40/40 120/-4/92/56/50 80/-5/122/90/60 90/-3/140/88/75 100/4/128/80/85 90/12/120/85/90 100/14/142/100/110 120/5/175/120/140 260/0/210/130/160 260/0/220/130/160 250/0/190/125/145 220/0/165/120/125 160/4/115/100/100 300/6/78/75/70 340/0/45/50/40 300/-6/12/14/14";
    private const string Avian = "0/-14/14/14/12 50/-14/32/34/26 70/-12/46/50/40 60/-12/72/76/55 60/-14/92/108/75 70/-8/96/110/85 80/20/80/85/85 160/68/74/78/80 160/64/95/100/120 140/42/150/150/190 220/18/200/180/230 220/8/200/180/210 200/3/170/165/170 180/0/130/140/130 140/-3/85/88/80 200/-5/60/55/50 220/-5/45/36/30 160/-5/20/16/14";
    private const string Fish = "0/0/30/30/30 40/0/60/60/60 60/0/85/90/85 60/0/100/120/110 60/0/115/145/135 70/0/130/175/165 80/0/140/200/190 80/0/145/220/210 100/0/150/235/225 120/0/150/245/240 170/0/150/250/250 170/0/135/235/235 160/0/110/195/190 150/0/80/145/140 120/0/55/95/90 120/0/30/52/50 100/0/22/45/43 140/0/8/30/30";
    private const string Insect = "0/-35/40/40/40 30/-35/75/70/70 40/-35/100/92/90 50/-30/120/110/100 50/-25/130/130/110 60/-15/122/122/110 70/0/82/85/80 50/5/58/60/60 60/5/100/100/100 120/5/155/155/150 150/2/165/165/155 120/0/105/105/100 120/-2/135/135/130 200/0/195/175/180 220/8/185/165/170 180/16/135/125/120 140/24/78/72/70 100/30/16/16/16";
    private const string Serpent = "0/-6/32/24/20 30/-6/56/40/34 60/-6/70/50/40 70/-8/90/62/45 60/-8/106/78/55 80/-2/114/75/60 100/14/90/70/65 180/45/80/80/80 220/48/86/90/90 250/25/100/100/100 350/5/115/115/110 350/0/120/120/115 350/0/115/115/110 320/0/105/105/100 300/0/90/90/85 350/2/70/70/65 350/2/45/45/42 300/-4/12/12/12";
    private const string Amphibian = "0/2/85/30/30 30/2/125/50/50 60/2/160/70/65 70/2/185/90/80 70/2/200/115/90 80/4/205/120/105 80/8/200/120/120 70/12/195/125/135 80/14/200/135/155 100/16/215/150/175 180/14/240/155/200 180/10/235/155/200 160/4/200/140/170 150/0/160/125/130 100/-4/90/80/80 120/0/55/50/45 120/0/34/30/30 80/0/12/12/12";

    /// <summary>The names of the animals.</summary>
    public static readonly string[] Names = { "canine", "bovine", "feline", "reptile", "avian", "fish", "insect", "serpent", "amphibian" };

    /// <summary>The torso of an animal whose spine runs at a height above the ground at ring 42, its torso pitched up by some degrees.</summary>
    public static SpineMeasure Measure(string name, double height, double pitchDegrees = 0)
    {
        string table = name switch
        {
            "canine" => Canine,
            "bovine" => Bovine,
            "feline" => Feline,
            "reptile" => Reptile,
            "avian" => Avian,
            "fish" => Fish,
            "insect" => Insect,
            "serpent" => Serpent,
            "amphibian" => Amphibian,
            _ => throw new ArgumentException(name),
        };
        string[] stations = table.Split(' ');
        double[] pitch = new double[BodyGrid.Rings];
        double[] width = new double[BodyGrid.Rings];
        double[] top = new double[BodyGrid.Rings];
        double[] bottom = new double[BodyGrid.Rings];
        double[] step = new double[BodyGrid.Rings];
        double[] before = Numbers(stations[0]);
        for (int s = 1; s < stations.Length; s++)
        {
            double[] now = Numbers(stations[s]);
            int from = BodyGrid.StationRings[s - 1];
            int to = BodyGrid.StationRings[s];
            for (int i = from; i <= to; i++)
            {
                double t = (i - from) / (double)(to - from);
                pitch[i] = Scalar.Radians(Scalar.Lerp(before[1], now[1], t) + (i is > 21 and < 45 ? pitchDegrees : 0));
                width[i] = Scalar.Lerp(before[2], now[2], t) / 1000;
                top[i] = Scalar.Lerp(before[3], now[3], t) / 1000;
                bottom[i] = Scalar.Lerp(before[4], now[4], t) / 1000;
                step[i] = i == from ? step[i] : now[0] / 1000 / (to - from);
            }

            before = now;
        }

        double[] y = new double[BodyGrid.Rings];
        double[] z = new double[BodyGrid.Rings];
        for (int i = 1; i < y.Length; i++)
        {
            y[i] = y[i - 1] - (step[i] * PortableMath.Sin(pitch[i]));
            z[i] = z[i - 1] - (step[i] * PortableMath.Cos(pitch[i]));
        }

        double lift = height - y[42];
        double origin = z[32];
        for (int i = 0; i < y.Length; i++)
        {
            y[i] += lift;
            z[i] -= origin;
        }

        return SpineSurvey.Measure(y, z, width, top, bottom);
    }

    private static double[] Numbers(string station) => Array.ConvertAll(station.Split('/'), text => double.Parse(text, CultureInfo.InvariantCulture));
}
