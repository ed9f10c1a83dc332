using System;

namespace CreatureGen.Maths;

/// <summary>One time step of a damped spring, exact for any stiffness, damping and step: place and velocity afterwards are fixed mixes of those before.</summary>
/// <remarks>
/// <para>x″ = −ω²x − 2ζωx′. Below ζ = 1 the step is a decaying turn in phase, at 1 the limit of it, above 1 two decays; near 1 the limit is used. Nothing can blow up, however stiff the spring.</para>
/// <para>Based on: R. Juckett, "Damped springs" (2012).</para>
/// </remarks>
public readonly struct DampedSpring
{
    private const double Near = 1e-3;

    /// <summary>Works out the mixes.</summary>
    /// <param name="angularFrequency">ω, rad/s, not negative; 0 for no spring at all.</param>
    /// <param name="dampingRatio">ζ, not negative; 1 does not swing through.</param>
    /// <param name="seconds">Length of the step, not negative.</param>
    public DampedSpring(float angularFrequency, float dampingRatio, float seconds)
    {
        double w = angularFrequency;
        double z = dampingRatio;
        double t = seconds;
        if (!(w > 1e-6))
        {
            PlaceOfPlace = 1f;
            PlaceOfVelocity = seconds;
            VelocityOfPlace = 0f;
            VelocityOfVelocity = 1f;
            return;
        }

        double c;
        double s;
        if (z < 1 - Near)
        {
            double turn = w * Math.Sqrt(1 - (z * z));
            double left = PortableMath.Exp(-z * w * t);
            PortableMath.SinCos(turn * t, out double sine, out double cosine);
            c = left * cosine;
            s = left * sine / turn;
        }
        else if (z > 1 + Near)
        {
            double apart = w * Math.Sqrt((z * z) - 1);
            double slow = PortableMath.Exp(-((z * w) - apart) * t);
            double fast = PortableMath.Exp(-((z * w) + apart) * t);
            c = 0.5 * (slow + fast);
            s = 0.5 * (slow - fast) / apart;
        }
        else
        {
            c = PortableMath.Exp(-w * t);
            s = c * t;
            z = 1;
        }

        // x(t) = c·x + s·(v + ζωx) and its derivative.
        PlaceOfPlace = (float)(c + (z * w * s));
        PlaceOfVelocity = (float)s;
        VelocityOfPlace = (float)(-w * w * s);
        VelocityOfVelocity = (float)(c - (z * w * s));
    }

    /// <summary>Place afterwards per place before.</summary>
    public float PlaceOfPlace { get; }

    /// <summary>Place afterwards per velocity before, seconds.</summary>
    public float PlaceOfVelocity { get; }

    /// <summary>Velocity afterwards per place before, s⁻¹.</summary>
    public float VelocityOfPlace { get; }

    /// <summary>Velocity afterwards per velocity before.</summary>
    public float VelocityOfVelocity { get; }
}
