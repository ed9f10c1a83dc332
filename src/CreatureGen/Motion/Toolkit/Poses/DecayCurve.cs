namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>
/// A number that goes from a value and a velocity to zero in a given time, there with velocity and acceleration zero: a polynomial of degree 5.
/// </summary>
/// <remarks>
/// Based on: D. Bollo, "Inertialization: high-performance animation transitions in Gears of War" (GDC 2018). With x₀, v₀ and the time t₁, cut to −5x₀/v₀ when the value already
/// falls so fast that it would overshoot: a₀ = (−8v₀t₁ − 20x₀)/t₁², not below 0 for positive x₀;
/// A = −(a₀t₁² + 6v₀t₁ + 12x₀)/2t₁⁵, B = (3a₀t₁² + 16v₀t₁ + 30x₀)/2t₁⁴, C = −(3a₀t₁² + 12v₀t₁ + 20x₀)/2t₁³;
/// x(t) = At⁵ + Bt⁴ + Ct³ + a₀t²/2 + v₀t + x₀.
/// </remarks>
internal readonly struct DecayCurve
{
    private readonly float duration;
    private readonly float value;
    private readonly float velocity;
    private readonly float halfAcceleration;
    private readonly float a;
    private readonly float b;
    private readonly float c;

    /// <summary>Lays the curve.</summary>
    /// <param name="value">At time 0, not negative.</param>
    /// <param name="velocity">At time 0, per second.</param>
    /// <param name="duration">Seconds; 0 for nothing at all.</param>
    public DecayCurve(float value, float velocity, float duration)
    {
        if (velocity < 0f && -5f * value > velocity * duration)
        {
            duration = -5f * value / velocity;
        }

        double t = duration;
        if (!(t > 1e-6))
        {
            this = default;
            return;
        }

        double x = value;
        double v = velocity;
        double acceleration = ((-8 * v * t) - (20 * x)) / (t * t);
        acceleration = acceleration > 0 ? acceleration : 0;
        double at = acceleration * t * t;
        double vt = v * t;
        double cube = 2 * t * t * t;
        this.duration = duration;
        this.value = value;
        this.velocity = velocity;
        halfAcceleration = (float)(0.5 * acceleration);
        a = (float)(-(at + (6 * vt) + (12 * x)) / (cube * t * t));
        b = (float)(((3 * at) + (16 * vt) + (30 * x)) / (cube * t));
        c = (float)(-((3 * at) + (12 * vt) + (20 * x)) / cube);
    }

    /// <summary>The number at a time, seconds.</summary>
    public float At(float time)
    {
        if (time >= duration)
        {
            return 0f;
        }

        return (((((((((a * time) + b) * time) + c) * time) + halfAcceleration) * time) + velocity) * time) + value;
    }
}
