using CreatureGen.Maths;

namespace CreatureGen.Motion.Swimming;

/// <summary>
/// Numbers of a style of swimming. The axis of the body follows y(s, t) = A(s)·L·sin 2π(s/λ − f·t), s from 0 at the nose to 1 at the tail, with amplitudes and wavelengths in body lengths L.
/// </summary>
/// <remarks>
/// <para>Envelope of carangiform swimmers: A = 0.02 − 0.0825 s + 0.1625 s², λ = 1 (Videler and Hess 1984, in the form of Maertens, Gao and Triantafyllou 2017); whales have the same, upright, with a
/// longer wave (Fish 1993). Of eels: A = 0.1·e^(s−1), λ ≈ 0.7 (Tytell and Lauder 2004). Strouhal numbers f·A/U, A from peak to peak of the tail, lie between 0.2 and 0.4 (Taylor, Nudds and Thomas 2003).</para>
/// <para>The envelopes are measured on free fish: the recoil of the body is in them, nothing is to be taken off.</para>
/// <para>Frequency at cruise: 1.2 Hz at one metre, falling with L to the power −0.55, a fit between small fish (about 5 Hz at 8 cm) and large whales.</para>
/// </remarks>
/// <param name="Wavelength">Body lengths.</param>
/// <param name="TailSweep">Tail beat from peak to peak, body lengths.</param>
/// <param name="Strouhal">Number at cruise.</param>
/// <param name="Tempo">Factor on the frequency of cruise.</param>
/// <param name="HeadFraction">Share of its own heading that the head keeps.</param>
/// <param name="Banking">Roll per radian of bend in a turn.</param>
internal sealed record SwimKinematics(double Wavelength, double TailSweep, double Strouhal, double Tempo, double HeadFraction, double Banking)
{
    /// <summary>Frequency at cruise of a body of one metre, Hz.</summary>
    private const double UnitFrequency = 1.2;

    /// <summary>Power of the body length in the frequency.</summary>
    private const double FrequencyPower = -0.55;

    private static readonly SwimKinematics carangiform = new(Wavelength: 1.0, TailSweep: 0.20, Strouhal: 0.28, Tempo: 1.0, HeadFraction: 0.55, Banking: 0.25);
    private static readonly SwimKinematics anguilliform = new(Wavelength: 0.72, TailSweep: 0.20, Strouhal: 0.38, Tempo: 1.1, HeadFraction: 0.55, Banking: 0.15);
    private static readonly SwimKinematics cetacean = new(Wavelength: 1.25, TailSweep: 0.22, Strouhal: 0.27, Tempo: 0.8, HeadFraction: 0.55, Banking: 0.45);
    private static readonly SwimKinematics disc = new(Wavelength: 1.4, TailSweep: 0.03, Strouhal: 0.30, Tempo: 0.6, HeadFraction: 0.55, Banking: 0.6);
    private static readonly SwimKinematics flippers = new(Wavelength: 1.2, TailSweep: 0.056, Strouhal: 0.30, Tempo: 0.6, HeadFraction: 0.55, Banking: 0.5);

    /// <summary>Numbers of a style.</summary>
    public static SwimKinematics Of(SwimStyle style) => style switch
    {
        SwimStyle.Anguilliform => anguilliform,
        SwimStyle.Cetacean => cetacean,
        SwimStyle.Flippers => flippers,
        SwimStyle.Disc => disc,
        _ => carangiform,
    };

    /// <summary>Frequency at cruise, Hz, of a body of so many metres.</summary>
    public double Frequency(double length) => UnitFrequency * Tempo * PortableMath.Pow(length, FrequencyPower);

    /// <summary>Shape of the amplitude along the body, to be scaled to the tail's sweep.</summary>
    public static double Envelope(SwimStyle style, double s) => style == SwimStyle.Anguilliform
        ? 0.1 * PortableMath.Exp(0.9 * (s - 1)) * (0.45 + (0.55 * Scalar.Smooth(2 * s)))
        : 0.02 - (0.0825 * s) + (0.1625 * s * s);
}
