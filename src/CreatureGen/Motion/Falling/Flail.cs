using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Falling;

/// <summary>Legs that look for footing in a long fall: each treads the air, those beside and those behind it half and a quarter of a turn later, until the ground comes.</summary>
internal sealed class Flail
{
    /// <summary>How long a fall is before they begin, and how quickly they do, τ = √(ℓ/g). No jump takes as long.</summary>
    private const float Patience = 2.8f;
    private const float Rate = 3.5f;

    /// <summary>Time of a turn, τ.</summary>
    private const float Period = 2.6f;

    /// <summary>How far feet go to and fro, and up and down, leg lengths.</summary>
    private const float Stride = 0.22f;
    private const float Rise = 0.1f;

    private readonly LeggedBody body;
    private readonly BodyLayer layer;
    private CriticallyDampedSpring amount;
    private float seconds;

    public Flail(LeggedBody body)
    {
        this.body = body;
        layer = new BodyLayer(body.Legs.Length);
    }

    /// <summary>A fall begins.</summary>
    public void Begin()
    {
        amount = default;
        seconds = 0f;
    }

    /// <summary>Falls on.</summary>
    /// <param name="reaches">Whether legs are stretched to the ground that comes.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public void Step(bool reaches, float dt, float tau)
    {
        seconds += dt;
        amount.Step(!reaches && seconds > Patience * tau ? 1 : 0, Rate / tau, dt);
    }

    /// <summary>What is asked of the feet.</summary>
    /// <param name="asked">What is asked besides; null for nothing.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public BodyLayer? On(BodyLayer? asked, float tau)
    {
        float share = (float)amount.Value;
        if (share < 1e-3f)
        {
            return asked;
        }

        layer.Clear();
        if (asked != null)
        {
            layer.CopyFrom(asked);
        }

        float turn = 2f * (float)PortableMath.Pi * seconds / (Period * tau);
        for (int i = 0; i < layer.Feet.Length; i++)
        {
            float lag = (body.Legs[i].Side == Side.Left ? 0f : (float)PortableMath.Pi) + (0.5f * (float)PortableMath.Pi * body.Legs[i].Row);
            FastTrigonometry.SinCos(turn - lag, out float sine, out float cosine);
            layer.Feet[i].Way += new Vector3(0f, Rise * (1f + cosine), Stride * sine) * (share * body.LegLength);
        }

        return layer;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Flail other) => (amount, seconds) = (other.amount, other.seconds);
}
