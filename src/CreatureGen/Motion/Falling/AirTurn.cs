using CreatureGen.Maths;

namespace CreatureGen.Motion.Falling;

/// <summary>How a body turns about up while nothing carries it: what turn it left the ground with dies away, and one that it makes by itself begins and ends at rest, so that its feet do not come down turning.</summary>
internal struct AirTurn
{
    /// <summary>How quickly the turn dies away that it has from the ground, per second.</summary>
    private const float SpinDamping = 1.5f;

    private readonly float angle;
    private readonly float seconds;
    private float spin;
    private float elapsed;

    private AirTurn(float spin, float angle, float seconds)
    {
        this.spin = spin;
        this.angle = angle;
        this.seconds = seconds;
        elapsed = 0f;
    }

    /// <summary>Radians per second that are left of the turn with which it came off the ground.</summary>
    public readonly float Spin => spin;

    /// <summary>What is left of the turn that it makes by itself, radians.</summary>
    public readonly float Left => elapsed < seconds ? angle * (1f - Scalar.Smooth(elapsed / seconds)) : 0f;

    /// <summary>As the ground left it.</summary>
    /// <param name="spin">Radians per second.</param>
    public static AirTurn Spinning(float spin) => new(spin, 0f, 0f);

    /// <summary>By an angle in all until it lands.</summary>
    /// <param name="spin">With which it leaves the ground, radians per second.</param>
    /// <param name="angle">Radians.</param>
    /// <param name="seconds">Until then.</param>
    public static AirTurn To(float spin, float angle, float seconds) => new(spin, angle - (spin * Damping.Integral(SpinDamping, seconds)), seconds);

    /// <summary>Goes on.</summary>
    /// <param name="dt">Seconds.</param>
    /// <returns>By how much it turns, radians.</returns>
    public float Step(float dt)
    {
        float turn = Left + (spin * Damping.Integral(SpinDamping, dt));
        elapsed += dt;
        spin *= Damping.Left(SpinDamping, dt);
        return turn - Left;
    }
}
