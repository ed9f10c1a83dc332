using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>
/// One body as numbers at the 18 stations of <see cref="BodyGrid"/>, nose to tail, straight along +Z apart from the pitch of its spine. A torso is about one metre long.
/// </summary>
internal sealed class BodyTable
{
    /// <summary>Reads a table.</summary>
    /// <param name="topExponent">Superellipse exponent of the torso above the spine.</param>
    /// <param name="bottomExponent">The same below the spine.</param>
    /// <param name="stations">Length from the station before (mm), pitch (degrees), half width, height above and depth below the spine (mm), from the nose to the end of the tail.</param>
    /// <exception cref="ArgumentException">There are not as many stations as a body has.</exception>
    public BodyTable(double topExponent, double bottomExponent, params (int Length, int Pitch, int Width, int Top, int Bottom)[] stations)
    {
        if (stations.Length != BodyGrid.StationCount)
        {
            throw new ArgumentException(FormattableString.Invariant($"a body table has {stations.Length} stations; expected {BodyGrid.StationCount}"), nameof(stations));
        }

        TopExponent = topExponent;
        BottomExponent = bottomExponent;
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            Length[i] = stations[i].Length / 1000.0;
            Pitch[i] = Maths.Scalar.Radians(stations[i].Pitch);
            Width[i] = stations[i].Width / 1000.0;
            Top[i] = stations[i].Top / 1000.0;
            Bottom[i] = stations[i].Bottom / 1000.0;
            LogWidth[i] = Maths.PortableMath.Log(Width[i]);
            LogTop[i] = Maths.PortableMath.Log(Top[i]);
            LogBottom[i] = Maths.PortableMath.Log(Bottom[i]);
        }
    }

    /// <summary>Superellipse exponent of the torso above the spine.</summary>
    public double TopExponent { get; }

    /// <summary>Superellipse exponent of the torso below the spine.</summary>
    public double BottomExponent { get; }

    /// <summary>Metres from the station before.</summary>
    public double[] Length { get; } = new double[BodyGrid.StationCount];

    /// <summary>Absolute pitch of the spine, radians.</summary>
    public double[] Pitch { get; } = new double[BodyGrid.StationCount];

    /// <summary>Half width, metres.</summary>
    public double[] Width { get; } = new double[BodyGrid.StationCount];

    /// <summary>Height above the spine, metres.</summary>
    public double[] Top { get; } = new double[BodyGrid.StationCount];

    /// <summary>Depth below the spine, metres.</summary>
    public double[] Bottom { get; } = new double[BodyGrid.StationCount];

    /// <summary>Natural logarithm of <see cref="Width"/>.</summary>
    public double[] LogWidth { get; } = new double[BodyGrid.StationCount];

    /// <summary>Natural logarithm of <see cref="Top"/>.</summary>
    public double[] LogTop { get; } = new double[BodyGrid.StationCount];

    /// <summary>Natural logarithm of <see cref="Bottom"/>.</summary>
    public double[] LogBottom { get; } = new double[BodyGrid.StationCount];
}
